// SPDX-License-Identifier: Apache-2.0
// Rays per second of the traversal kernel beside Embree, on the same rays and cores in the same run.
// Usage: bench_tracing [--json FILE] [--device NAME] [--size WxH] [--rounds N] SCENE ...
#include "import/conversion/gltf.h"
#include "renderers/device_scene/ray_list.h"
#include "support/embree_oracle.h"

#include "median.h"
#include "ray_sets.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <thread>

namespace utsuri {
namespace {

using Clock = std::chrono::steady_clock;
using Json = nlohmann::ordered_json;

template <typename Work>
double seconds_of(const Work& work) {
    const auto start = Clock::now();
    work();
    return std::chrono::duration<double>(Clock::now() - start).count();
}

struct Contest {
    const EmbreeOracle& embree;
    unsigned threads;
    int rounds;
};

/// Alternates the two, so that a machine whose speed drifts treats both alike; medians of the rounds.
Json race(const Contest& contest, RayList& ours, const std::vector<interop::RayInfo>& rays, RayQuery query) {
    ours.upload(rays);
    ours.trace();  // the first dispatch compiles
    std::vector<double> our_rates;
    std::vector<double> embree_rates;
    std::vector<double> ratios;
    const double count = static_cast<double>(rays.size());
    for (int round = 0; round < contest.rounds; ++round) {
        our_rates.push_back(count / ours.trace() * 1e-6);
        const double seconds = seconds_of([&] {
            if (query == RayQuery::closest_hit) {
                contest.embree.closest_hits(rays, contest.threads);
            } else {
                contest.embree.occlusions(rays, contest.threads);
            }
        });
        embree_rates.push_back(count / seconds * 1e-6);
        ratios.push_back(our_rates.back() / embree_rates.back());
    }
    return {{"rays", rays.size()},
            {"mrays_per_second", median(our_rates)},
            {"embree_mrays_per_second", median(embree_rates)},
            {"ratio", median(ratios)},
            {"ratio_min", *std::min_element(ratios.begin(), ratios.end())},
            {"ratio_max", *std::max_element(ratios.begin(), ratios.end())}};
}

Json measure_scene(Device& device, const std::string& path, glm::uvec2 size, int rounds) {
    const Scene scene = import_gltf(path).scene;
    const SceneData data = prepare_scene_data(scene);
    const GpuScene gpu_scene(device, data);
    const RaySets sets = make_ray_sets(data, scene.cameras.front(), size.x, size.y);
    const EmbreeOracle embree(data.bvh.triangles, EmbreeOracle::Mode::fast);
    const Contest contest{embree, std::max(1u, std::thread::hardware_concurrency()), rounds};
    RayList closest(device, gpu_scene, RayQuery::closest_hit);
    RayList any(device, gpu_scene, RayQuery::any_hit);
    return {{"scene", std::filesystem::path(path).filename().string()},
            {"triangles", data.bvh.triangles.size()},
            {"bvh_seconds", data.build_seconds},
            {"bvh_bytes", data.bvh.nodes.size() * sizeof(interop::BvhNode)},
            {"primary", race(contest, closest, sets.primary, RayQuery::closest_hit)},
            {"diffuse", race(contest, closest, sets.diffuse, RayQuery::closest_hit)},
            {"shadow", race(contest, any, sets.shadow, RayQuery::any_hit)}};
}

void print_scene(const Json& result) {
    fmt::print("{}: {} triangles, BVH {:.1f} MiB built in {:.3f} s\n", result["scene"].get<std::string>(),
               result["triangles"].get<std::size_t>(), result["bvh_bytes"].get<double>() / 1048576.0,
               result["bvh_seconds"].get<double>());
    for (const char* set : {"primary", "diffuse", "shadow"}) {
        const Json& row = result[set];
        fmt::print("  {:<8} {:7.2f} Mrays/s   Embree {:7.2f}   ratio {:.3f} ({:.3f} to {:.3f})\n", set,
                   row["mrays_per_second"].get<double>(), row["embree_mrays_per_second"].get<double>(),
                   row["ratio"].get<double>(), row["ratio_min"].get<double>(),
                   row["ratio_max"].get<double>());
    }
}

int run(int argc, char** argv) {
    CLI::App app("Rays per second of the traversal kernel beside Embree");
    std::vector<std::string> scenes;
    std::string json_path;
    std::string wanted_device;
    glm::uvec2 size(1024, 768);
    int rounds = 7;
    app.add_option("scenes", scenes, "glTF scenes")->required();
    app.add_option("--json", json_path, "Write the figures to this file");
    app.add_option("--device", wanted_device, "Vulkan device")->envname("UTSURI_DEVICE");
    app.add_option("--width", size.x, "Width of the picture whose rays are traced")->capture_default_str();
    app.add_option("--height", size.y, "Height of that picture")->capture_default_str();
    app.add_option("--rounds", rounds, "Rounds per figure")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    CLI11_PARSE(app, argc, argv);

    const VulkanInstance instance;
    Device device(instance, wanted_device);
    Json report = {{"device", device.summary().name},
                   {"driver", device.summary().driver},
                   {"embree", EmbreeOracle::version()},
                   {"threads", std::thread::hardware_concurrency()},
                   {"scenes", Json::array()}};
    fmt::print("{}, {}; Embree {} with {} threads\n", device.summary().name, device.summary().driver,
               EmbreeOracle::version(), std::thread::hardware_concurrency());
    for (const std::string& path : scenes) {
        report["scenes"].push_back(measure_scene(device, path, size, rounds));
        print_scene(report["scenes"].back());
    }
    if (!json_path.empty()) std::ofstream(json_path) << report.dump(2) << '\n';
    return 0;
}

}  // namespace
}  // namespace utsuri

int main(int argc, char** argv) {
    try {
        return utsuri::run(argc, argv);
    } catch (const std::exception& error) {
        fmt::print(stderr, "bench_tracing: {}\n", error.what());
        return 1;
    }
}
