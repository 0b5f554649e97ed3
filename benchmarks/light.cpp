// SPDX-License-Identifier: Apache-2.0
// What it takes to keep light on the surfaces of a scene. Usage: bench_light [--json FILE] [--device NAME]
// [--rounds N] SCENE ...
#include "import/conversion/gltf.h"
#include "renderers/light/direct/light_cache.h"

#include "base/stopwatch.h"

#include "median.h"
#include "scene_program.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace utsuri {
namespace {

using Json = nlohmann::ordered_json;

/// Each round keeps the light anew.
Json measure_scene(Session&, const std::string& path, const SceneProgram& program) {
    // Below a session, which would not tell rays from points.
    const VulkanInstance instance;
    Device device(instance, program.wanted_device);
    const SceneData data = prepare_scene_data(import_gltf(path).scene);
    const GpuScene scene(device, data);
    std::vector<double> seconds;
    std::vector<double> device_seconds;
    std::vector<double> whole_seconds;
    FrameCounts counts;
    std::size_t points = 0;
    for (int round = 0; round < program.rounds; ++round) {
        Progress progress;
        LightCache light(device, data, scene, {});
        const Stopwatch stopwatch;
        light.fill(progress);
        whole_seconds.push_back(stopwatch.seconds() - light.cost().compile_seconds);
        seconds.push_back(light.cost().seconds);
        counts = light.cost().counts;
        device_seconds.push_back(counts.gpu_seconds);
        points = light.mesh().points.size();
    }
    const Json row = {{"scene", std::filesystem::path(path).stem().string()},
                      {"lights", data.lights.size()},
                      {"points", points},
                      {"rays", counts.rays},
                      {"seconds", median(whole_seconds)},
                      {"simulation_seconds", median(seconds)},
                      {"device_seconds", median(device_seconds)}};
    fmt::print(
        "{:<18} {:5} lights   {:7} points kept   {:6.2f} M rays   in all {:6.2f} s, simulation {:6.2f} s, "
        "on the device {:6.2f} s\n",
        row["scene"].get<std::string>(), data.lights.size(), points, 1e-6 * static_cast<double>(counts.rays),
        median(whole_seconds), median(seconds), median(device_seconds));
    return row;
}

}  // namespace
}  // namespace utsuri

int main(int argc, char** argv) {
    return utsuri::run_scene_program(argc, argv, "What it takes to keep light on surfaces",
                                     utsuri::measure_scene);
}
