// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "session/session.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <cstdio>
#include <exception>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

namespace utsuri {

/// What programs that measure scenes are told on the command line.
struct SceneProgram {
    std::vector<std::string> scenes;
    std::string json_path;
    std::string wanted_device;
    RenderSettings settings;
    std::uint32_t map_size = 256;  ///< texels along an edge of a map
    int rounds = 31;
};

/// Measures one scene file, prints what it finds, and returns it.
/// @param session without a scene
using MeasureScene = std::function<nlohmann::ordered_json(Session& session, const std::string& path,
                                                          const SceneProgram& program)>;

inline int measure_scenes(int argc, char** argv, const std::string& description,
                          const MeasureScene& measure) {
    CLI::App app(description);
    SceneProgram program;
    app.add_option("scenes", program.scenes, "glTF scenes")->required();
    app.add_option("--json", program.json_path, "Write the figures to this file");
    app.add_option("--device", program.wanted_device, "Vulkan device")->envname("UTSURI_DEVICE");
    app.add_option("--width", program.settings.width, "Width of the picture")->capture_default_str();
    app.add_option("--height", program.settings.height, "Height of the picture")->capture_default_str();
    app.add_option("--map-size", program.map_size, "Texels along an edge of a map")->capture_default_str();
    app.add_option("--rounds", program.rounds, "Frames of each contestant")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    CLI11_PARSE(app, argc, argv);

    const DeviceSummary device = Session({program.wanted_device, Validation::off, {}}).device();
    nlohmann::ordered_json report = {
        {"device", device.name},           {"driver", device.driver},
        {"width", program.settings.width}, {"height", program.settings.height},
        {"map_size", program.map_size},    {"scenes", nlohmann::ordered_json::array()}};
    fmt::print("{}, {}\n", device.name, device.driver);
    for (const std::string& path : program.scenes) {
        Session session({program.wanted_device, Validation::off, {}});
        report["scenes"].push_back(measure(session, path, program));
    }
    if (!program.json_path.empty()) std::ofstream(program.json_path) << report.dump(2) << '\n';
    return 0;
}

/// The whole of main().
inline int run_scene_program(int argc, char** argv, const std::string& description,
                             const MeasureScene& measure) {
    // Each method's figures as soon as they are there, to a file too.
    std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
    try {
        return measure_scenes(argc, argv, description, measure);
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}: {}\n", argv[0], error.what());
        return 1;
    }
}

}  // namespace utsuri
