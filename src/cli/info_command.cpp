// SPDX-License-Identifier: Apache-2.0
#include "cli/command.h"
#include "cli/output.h"
#include "cli/scene_session.h"
#include "compare/comparison/comparison_table.h"
#include "renderers/film/film.h"
#include "renderers/light/direct/light_cache.h"
#include "renderers/reflection/distances/distance_maps.h"
#include "renderers/reflection/glossy/glossy_map_plan.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <limits>
#include <memory>

namespace utsuri {
namespace {

struct InfoOptions {
    CommonOptions common;
    PictureOptions picture;
    std::string scene;
};

/// Device memory that a run at the given settings will take, in bytes.
struct Prediction {
    std::uint64_t scene = 0;
    std::uint64_t film = 0;
    MeshBytes light;                 ///< kept on surfaces, for methods that draw
    std::uint64_t drawing = 0;       ///< the pictures that are drawn into
    std::uint64_t polygon_maps = 0;  ///< with their film
    std::uint64_t glossy_maps = 0;   ///< what glossy lobes reflect, with what it takes to capture that
    std::uint64_t distances = 0;     ///< beside both, for methods that keep distances
};

Prediction predict(const SceneData& data, const RenderSettings& settings, const LightSettings& light,
                   const MapSettings& maps) {
    Prediction prediction;
    prediction.scene = data.device_bytes();
    prediction.film = Film::bytes(settings.width, settings.height);
    prediction.light =
        predict_mesh_bytes(data, mesh_settings(data, light, std::numeric_limits<std::uint64_t>::max()));
    // Colour, depth, and the colour again where the film reads it.
    prediction.drawing = std::uint64_t{settings.width} * settings.height * (16 + 4 + 16);
    const std::uint64_t stride = std::uint64_t{maps.size} + std::uint64_t{2} * interop::MAP_BORDER;
    const std::uint64_t reflectors = data.requirements.reflective_instances.size();
    if (reflectors > 0) {
        prediction.polygon_maps =
            reflectors * maps.polyhedron.planes.size() * stride * stride * sizeof(glm::vec3) +
            Film::bytes(maps.size + 2, maps.size + 2);
    }
    prediction.glossy_maps = glossy_map_bytes(data, maps.size);
    prediction.distances = glossy_distance_bytes(data, maps.size);
    if (reflectors > 0) {
        prediction.distances += reflectors * DistanceMaps::bytes(DistanceMaps::size_for(maps.size)) +
                                data.triangle_infos.size() * sizeof(float);
    }
    return prediction;
}

std::string depth_text(std::uint32_t depth) {
    return depth == kUnboundedDepth ? "unbounded (surfaces that reflect can face each other)"
                                    : fmt::format("{}", depth);
}

std::string yes(bool value) {
    return value ? "yes" : "no";
}

std::string describe(const InfoOptions& options, const LoadedScene& loaded, const SceneData& data,
                     const Prediction& memory) {
    const Requirements& needs = data.requirements;
    const glm::vec3 size = data.bounds.empty() ? glm::vec3(0.0f) : data.bounds.extent();
    std::string text;
    const auto row = [&](std::string_view name, const std::string& value) {
        text += fmt::format("  {:<26}{}\n", name, value);
    };
    text += fmt::format("{}\n", options.scene);
    row("size [m]", fmt::format("{:.4g} x {:.4g} x {:.4g}", size.x, size.y, size.z));
    row("triangles", fmt::format("{} in {} instances", needs.triangles, needs.instances));
    row("vertices", fmt::format("{}", needs.vertices));
    row("materials in use", fmt::format("{}", needs.materials));
    row("textures in use",
        fmt::format("{} with {} texels", needs.textures, format_count(static_cast<double>(needs.texels))));
    for (std::size_t i = 0; i < loaded.scene.cameras.size(); ++i) {
        row(i == 0 ? "cameras" : "", fmt::format("{}: {}", i, loaded.scene.cameras[i].name));
    }
    row("BVH", fmt::format("{} nodes, depth {}, built in {}", data.bvh.nodes.size(), data.bvh.depth,
                           format_seconds(data.build_seconds)));
    text += "requires\n";
    row("emissive triangles", fmt::format("{}", needs.emissive_triangles));
    row("punctual lights", fmt::format("{}", needs.punctual_lights));
    row("uniform environment", yes(needs.environment));
    row("texture lookups", yes(needs.textures > 0));
    row("glossy lobes", yes(needs.glossy));
    row("mirrors", yes(needs.mirror));
    for (const std::uint32_t instance : needs.reflective_instances) {
        row("", loaded.scene.instances[instance].name);
    }
    row("specular chain depth", depth_text(needs.max_depth));
    text += fmt::format("memory predicted at {}, maps of {}\n", options.picture.size,
                        options.picture.map_size.value_or(fmt::format("{}", MapSettings().size)));
    row("scene", format_bytes(memory.scene));
    row("film", format_bytes(memory.film));
    row("light on surfaces", fmt::format("{}, up to {} where it changes", format_bytes(memory.light.least),
                                         format_bytes(memory.light.most)));
    row("drawing", format_bytes(memory.drawing));
    row("polygon maps", format_bytes(memory.polygon_maps));
    row("maps of glossy lobes", format_bytes(memory.glossy_maps));
    row("distances beside maps", format_bytes(memory.distances));
    if (!loaded.notes.empty()) text += "notes\n";
    for (const std::string& note : loaded.notes)
        text += fmt::format("  {}\n", note);
    return text;
}

nlohmann::ordered_json to_json(const InfoOptions& options, const LoadedScene& loaded, const SceneData& data,
                               const Prediction& memory) {
    const Requirements& needs = data.requirements;
    nlohmann::ordered_json reflective = nlohmann::ordered_json::array();
    for (const std::uint32_t instance : needs.reflective_instances) {
        reflective.push_back(loaded.scene.instances[instance].name);
    }
    nlohmann::ordered_json cameras = nlohmann::ordered_json::array();
    for (const Camera& camera : loaded.scene.cameras)
        cameras.push_back(camera.name);
    return {
        {"scene", options.scene},
        {"triangles", needs.triangles},
        {"vertices", needs.vertices},
        {"instances", needs.instances},
        {"materials", needs.materials},
        {"textures", needs.textures},
        {"texels", needs.texels},
        {"cameras", cameras},
        {"bvh_nodes", data.bvh.nodes.size()},
        {"bvh_depth", data.bvh.depth},
        {"requires",
         {{"emissive_triangles", needs.emissive_triangles},
          {"punctual_lights", needs.punctual_lights},
          {"environment", needs.environment},
          {"textures", needs.textures > 0},
          {"glossy", needs.glossy},
          {"mirror", needs.mirror},
          {"reflective_instances", reflective},
          {"specular_depth", needs.max_depth == kUnboundedDepth ? nlohmann::ordered_json(nullptr)
                                                                : nlohmann::ordered_json(needs.max_depth)}}},
        {"predicted_bytes",
         {{"scene", memory.scene},
          {"film", memory.film},
          {"light", memory.light.least},
          {"light_refined", memory.light.most},
          {"drawing", memory.drawing},
          {"polygon_maps", memory.polygon_maps},
          {"glossy_maps", memory.glossy_maps},
          {"distances", memory.distances}}},
        {"notes", loaded.notes}};
}

ExitCode info(const InfoOptions& options) {
    const RenderSettings settings = options.picture.render_settings();
    const LoadedScene loaded = load_scene(options.scene);
    const SceneData data = prepare_scene_data(loaded.scene);
    const Prediction memory =
        predict(data, settings, options.picture.light_settings(), options.picture.map_settings());
    print_text(options.common, describe(options, loaded, data, memory));
    write_json(options.common, to_json(options, loaded, data, memory));
    return ExitCode::success;
}

}  // namespace

void add_info_command(CLI::App& app, Action& action) {
    auto options = std::make_shared<InfoOptions>();
    CLI::App* command =
        app.add_subcommand("info", "Tell what a scene holds, what it requires and what is ignored");
    command->add_option("scene", options->scene, "glTF scene, .gltf or .glb")->required()->type_name("SCENE");
    command->add_option("--size", options->picture.size, "Picture size in pixels, for the memory prediction")
        ->type_name("WxH")
        ->capture_default_str();
    command
        ->add_option(
            "--map-size", options->picture.map_size,
            fmt::format("Texels along an edge of a map, for the memory prediction; fit: at most [{}]",
                        MapSettings().size))
        ->type_name("TEXELS|fit");
    command
        ->add_option("--polyhedron", options->picture.polyhedron,
                     "Polyhedron of polygon maps, for the memory prediction: see utsuri render --help")
        ->type_name("NAME|FILE")
        ->capture_default_str();
    add_common_options(*command, options->common);
    command->callback([=, &action] { action = [=] { return info(*options); }; });
}

}  // namespace utsuri
