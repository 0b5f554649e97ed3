// SPDX-License-Identifier: Apache-2.0
// What a frame costs while the eye moves: every method's time to prepare and to render one frame, beside a
// traced frame. Usage: bench_frames [--json FILE] [--device NAME] [--width W --height H] [--map-size N]
// [--rounds N] SCENE ...
#include "import/conversion/gltf.h"

#include "median.h"
#include "scene_program.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <filesystem>

namespace utsuri {
namespace {

using Json = nlohmann::ordered_json;

/// Each round is one frame of one sample per pixel, from another place.
Json measure_method(Session& session, const PictureSettings& settings, int rounds) {
    Progress progress;
    Picture picture = session.make_picture(settings);
    picture.prepare(progress);
    picture.add_samples(1, progress);
    std::vector<double> seconds;
    std::vector<double> gpu_seconds;
    std::vector<double> shown_seconds;
    for (int round = 0; round < rounds; ++round) {
        Camera camera = settings.camera;
        camera.position += 1e-3 * (round + 1) * camera.right;
        picture.set_camera(camera);
        const RenderStatistics before = picture.statistics();
        picture.add_samples(1, progress);
        seconds.push_back(picture.statistics().frame_seconds - before.frame_seconds);
        gpu_seconds.push_back(picture.statistics().counts.gpu_seconds - before.counts.gpu_seconds);
        // The same without a film, from yet another place.
        camera.position += 5e-4 * camera.right;
        picture.set_camera(camera);
        const auto start = std::chrono::steady_clock::now();
        if (picture.draw_frame()) {
            shown_seconds.push_back(
                std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
        }
    }
    const Json shown = shown_seconds.empty() ? Json(nullptr) : Json(1e3 * median(shown_seconds));
    return {{"method", method_name(settings.method)},
            {"prepare_seconds", picture.statistics().prepare_seconds},
            {"compile_seconds", picture.statistics().compile_seconds},
            {"frame_ms", 1e3 * median(seconds)},
            {"gpu_ms", 1e3 * median(gpu_seconds)},
            {"shown_ms", shown}};
}

Json measure_scene(Session& session, const std::string& path, const SceneProgram& program) {
    const RenderSettings& settings = program.settings;
    MapSettings maps;
    maps.size = program.map_size;
    const Scene scene = import_gltf(path).scene;
    session.set_scene(scene);
    Json result = {{"scene", std::filesystem::path(path).filename().string()}, {"methods", Json::array()}};
    fmt::print("{}, {}x{}, a sample per pixel\n", result["scene"].get<std::string>(), settings.width,
               settings.height);
    for (const Method& method : all_methods(light_methods().front())) {
        const Json row =
            measure_method(session, {method, scene.cameras.front(), settings, maps}, program.rounds);
        fmt::print(
            "  {:<20} prepare {:7.3f} s   compile {:6.3f} s   frame {:8.2f} ms   on the device {:8.2f} ms   "
            "{}\n",
            method_name(method), row["prepare_seconds"].get<double>(), row["compile_seconds"].get<double>(),
            row["frame_ms"].get<double>(), row["gpu_ms"].get<double>(),
            row["shown_ms"].is_null()
                ? ""
                : fmt::format("without a film {:8.2f} ms", row["shown_ms"].get<double>()));
        result["methods"].push_back(row);
    }
    return result;
}

}  // namespace
}  // namespace utsuri

int main(int argc, char** argv) {
    return utsuri::run_scene_program(argc, argv, "What a frame costs with each method",
                                     utsuri::measure_scene);
}
