// SPDX-License-Identifier: Apache-2.0
// What it costs to take over a change of a scene: every method's time after a colour, a light, an object or a
// mirror changed, beside preparing it anew. Usage: bench_changes [--json FILE] [--device NAME] [--width W
// --height H]
// [--map-size N] [--rounds N] SCENE ...
#include "import/conversion/gltf.h"

#include "median.h"
#include "scene_program.h"

#include <fmt/format.h>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <limits>
#include <optional>

namespace utsuri {
namespace {

using Json = nlohmann::ordered_json;

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Length of the diagonal of an instance's bounds, metres.
double extent_of(const Scene& scene, const Instance& instance) {
    glm::dvec3 lower(std::numeric_limits<double>::infinity());
    glm::dvec3 upper(-lower);
    for (const glm::vec3& position : scene.meshes[instance.mesh].positions) {
        const glm::dvec3 world(instance.world_from_object * glm::dvec4(glm::dvec3(position), 1.0));
        lower = glm::min(lower, world);
        upper = glm::max(upper, world);
    }
    return glm::distance(lower, upper);
}

/// The smallest instance that is a mirror, or that is none and does not shine.
std::optional<std::size_t> smallest_instance(const Scene& scene, bool is_mirror) {
    std::optional<std::size_t> smallest;
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const Material& material = scene.materials[scene.instances[i].material];
        if (may_be_mirror(scene, material) != is_mirror || material.emissive != glm::vec3(0.0f)) continue;
        if (!smallest || extent_of(scene, scene.instances[i]) < extent_of(scene, scene.instances[*smallest]))
            smallest = i;
    }
    return smallest;
}

struct Change {
    std::string name;
    Scene scene;
};

/// A tenth of its own size upwards.
Change moved(const Scene& scene, std::size_t index, const std::string& name) {
    Change change{name, scene};
    Instance& instance = change.scene.instances[index];
    const glm::dvec3 by(0.0, 0.1 * extent_of(scene, instance), 0.0);
    instance.world_from_object = glm::translate(glm::dmat4(1.0), by) * instance.world_from_object;
    return change;
}

std::vector<Change> changes_of(const Scene& scene) {
    std::vector<Change> changes;
    if (const auto object = smallest_instance(scene, false)) {
        Change colour{"a colour", scene};
        colour.scene.materials[scene.instances[*object].material].base_colour *= 0.5f;
        changes.push_back(colour);
        changes.push_back(moved(scene, *object, "an object moved"));
    }
    Change light{"a light", scene};
    const auto shines = [](const Material& material) { return material.emissive != glm::vec3(0.0f); };
    const auto lamp = std::find_if(light.scene.materials.begin(), light.scene.materials.end(), shines);
    if (!light.scene.lights.empty()) {
        light.scene.lights.front().intensity *= 0.5f;
        changes.push_back(light);
    } else if (lamp != light.scene.materials.end()) {
        lamp->emissive *= 0.5f;
        changes.push_back(light);
    }
    if (const auto mirror = smallest_instance(scene, true))
        changes.push_back(moved(scene, *mirror, "a mirror moved"));
    return changes;
}

/// What it cost a session to take over a scene.
struct Cost {
    double update_seconds;   ///< all of it: scene, light and picture, pipelines included
    double prepare_seconds;  ///< of that, what the picture prepared, pipelines excluded
};

Cost take_over(Session& session, const Picture& picture, const Scene& scene) {
    const auto start = std::chrono::steady_clock::now();
    session.set_scene(scene);
    return {seconds_since(start), picture.statistics().prepare_seconds};
}

Json measure_changes(Session& session, const Picture& picture, const Scene& scene,
                     const std::vector<Change>& changes, int rounds) {
    Json rows = Json::array();
    for (const Change& change : changes) {
        std::vector<double> update;
        std::vector<double> prepare;
        for (int round = 0; round < rounds; ++round) {
            const Cost cost = take_over(session, picture, round % 2 == 0 ? change.scene : scene);
            update.push_back(1e3 * cost.update_seconds);
            prepare.push_back(1e3 * cost.prepare_seconds);
        }
        if (rounds % 2 == 1) session.set_scene(scene);
        rows.push_back(
            {{"change", change.name}, {"update_ms", median(update)}, {"prepare_ms", median(prepare)}});
    }
    return rows;
}

Json measure_scene(Session& session, const std::string& path, const SceneProgram& program) {
    MapSettings maps;
    maps.size = program.map_size;
    const Scene scene = import_gltf(path).scene;
    const std::vector<Change> changes = changes_of(scene);
    session.set_scene(scene);
    Json result = {{"scene", std::filesystem::path(path).filename().string()}, {"methods", Json::array()}};
    fmt::print("{}, {}x{}: milliseconds to take over a change\n", result["scene"].get<std::string>(),
               program.settings.width, program.settings.height);
    for (const Method& method : all_methods(light_methods().front())) {
        if (!method.reflection->traits.looks_up_maps) continue;
        Picture picture = session.make_picture({method, scene.cameras.front(), program.settings, maps});
        Progress progress;
        picture.prepare(progress);
        const double anew = 1e3 * picture.statistics().prepare_seconds;
        const Json rows = measure_changes(session, picture, scene, changes, program.rounds);
        fmt::print("  {:<20} anew {:9.1f}", method_name(method), anew);
        for (const Json& row : rows)
            fmt::print("   {} {:9.1f}", row["change"].get<std::string>(), row["update_ms"].get<double>());
        fmt::print("\n");
        result["methods"].push_back({{"method", method_name(method)}, {"anew_ms", anew}, {"changes", rows}});
    }
    return result;
}

}  // namespace
}  // namespace utsuri

int main(int argc, char** argv) {
    return utsuri::run_scene_program(argc, argv, "What it costs to take over a change of a scene",
                                     utsuri::measure_scene);
}
