// SPDX-License-Identifier: Apache-2.0
// What it saves to model only what a scene requires: the time of a traced sample with kernels specialised for
// the scene, beside kernels with everything on, which give the same picture; and the memory of maps for the
// instances that need them, beside maps for all. Usage: bench_requirements [--json FILE] [--device NAME]
// [--width W --height H] [--map-size N] [--rounds N] SCENE ...
#include "import/conversion/gltf.h"
#include "renderers/device_scene/scene_triangles.h"
#include "renderers/methods/method.h"
#include "renderers/methods/ray_tracer.h"
#include "renderers/reflection/glossy/glossy_map_plan.h"

#include "base/check.h"

#include "interop/reflection.h"
#include "median.h"
#include "scene_program.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace utsuri {
namespace {

using Json = nlohmann::ordered_json;

/// The same scene as if it had every kind of surface and light and the deepest tree. Its surroundings stay as
/// they are: uniform ones are a light of their own.
SceneData with_everything_on(SceneData data) {
    Requirements& needs = data.requirements;
    needs.textures = std::max(needs.textures, 1u);
    needs.emissive_triangles = std::max<std::uint64_t>(needs.emissive_triangles, 1);
    needs.punctual_lights = std::max(needs.punctual_lights, 1u);
    needs.glossy = true;
    needs.mirror = true;
    needs.max_depth = kUnboundedDepth;
    data.bvh.depth = interop::BVH_MAX_DEPTH;
    needs.reflective_instances.clear();
    for (std::uint32_t instance = 0; instance < needs.instances; ++instance) {
        if (!triangles_of(data, instance).empty()) needs.reflective_instances.push_back(instance);
    }
    needs.glossy_instances = needs.reflective_instances;
    for (SurfaceFeatures& surface : needs.surfaces)
        surface = {true, true, true};
    return data;
}

/// A tracer with its scene and film.
class Contestant {
  public:
    Contestant(Device& device, const SceneData& data, const Camera& camera, const RenderSettings& settings)
        : scene_(device, data),
          light_(device, data, scene_, light_methods().front(), {}),
          tracer_({device, data, scene_, light_methods().front(), light_, camera}, settings),
          film_(device, settings.width, settings.height, "benchmark film") {
        tracer_.prepare(progress_);
        tracer_.add_samples(film_, 1, progress_);
    }
    /// @returns seconds of one more sample per pixel
    double sample() {
        const double before = tracer_.statistics().frame_seconds;
        tracer_.add_samples(film_, 1, progress_);
        return tracer_.statistics().frame_seconds - before;
    }
    [[nodiscard]] Image picture() const { return film_.resolve(); }

  private:
    Progress progress_;
    GpuScene scene_;
    KeptLight light_;
    RayTracer tracer_;
    Film film_;
};

/// Device memory of what reflective and glossy instances look up, in bytes.
std::uint64_t map_bytes(const SceneData& data, std::uint32_t size) {
    const std::uint64_t stride = std::uint64_t{size} + std::uint64_t{2} * interop::MAP_BORDER;
    return data.requirements.reflective_instances.size() * interop::CUBE_FACES * stride * stride *
               sizeof(glm::vec3) +
           glossy_map_bytes(data, size);
}

Json measure_scene(Session&, const std::string& path, const SceneProgram& program) {
    // Below a session, which would ask for what the scene requires.
    const VulkanInstance instance;
    Device device(instance, program.wanted_device);
    const Scene scene = import_gltf(path).scene;
    const SceneData data = prepare_scene_data(scene);
    const SceneData everything = with_everything_on(data);
    const Camera& camera = scene.cameras.front();
    Contestant required(device, data, camera, program.settings);
    Contestant all(device, everything, camera, program.settings);
    std::vector<double> required_seconds;
    std::vector<double> all_seconds;
    std::vector<double> ratios;
    for (int round = 0; round < program.rounds; ++round) {
        required_seconds.push_back(required.sample());
        all_seconds.push_back(all.sample());
        ratios.push_back(all_seconds.back() / required_seconds.back());
    }
    UTSURI_CHECK(required.picture().pixels == all.picture().pixels);
    const Json row = {{"scene", std::filesystem::path(path).stem().string()},
                      {"required_ms", 1e3 * median(required_seconds)},
                      {"everything_ms", 1e3 * median(all_seconds)},
                      {"ratio", median(ratios)},
                      {"required_map_bytes", map_bytes(data, program.map_size)},
                      {"everything_map_bytes", map_bytes(everything, program.map_size)}};
    fmt::print(
        "{:<18} a sample {:7.1f} ms, with everything {:7.1f} ms: {:5.2f}   maps {:7.1f} MiB, {:8.1f} MiB\n",
        row["scene"].get<std::string>(), row["required_ms"].get<double>(), row["everything_ms"].get<double>(),
        row["ratio"].get<double>(), row["required_map_bytes"].get<double>() / 1048576.0,
        row["everything_map_bytes"].get<double>() / 1048576.0);
    return row;
}

}  // namespace
}  // namespace utsuri

int main(int argc, char** argv) {
    return utsuri::run_scene_program(argc, argv, "What it saves to model only what a scene requires",
                                     utsuri::measure_scene);
}
