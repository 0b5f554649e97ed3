// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/scene_data.h"
#include "renderers/methods/ray_tracer.h"
#include "renderers/methods/renderer.h"

#include "base/progress.h"
#include "image/image.h"
#include "scene/scene.h"

#include <cstdint>
#include <random>

namespace utsuri::test {

/// Materials: a pure Lambert surface, a perfect mirror of reflectance 1, a Lambert surface that also emits,
/// GGX metal.
Material lambert(glm::vec3 albedo);
Material mirror();
Material emitter(glm::vec3 radiance, glm::vec3 albedo = glm::vec3(0.0f));
Material glossy_metal(float roughness, glm::vec3 f0 = glm::vec3(1.0f));

/// Meshes. A quad spans `u` and `v` from `corner`; its front is where u x v points. A sphere has its front
/// outside and smooth normals; an icosphere of 20 * 4^level triangles inscribed in the radius.
Mesh quad(glm::vec3 corner, glm::vec3 u, glm::vec3 v);
Mesh icosphere(glm::vec3 centre, float radius, int level);
/// The six walls of a box, with fronts inside.
Mesh room(glm::vec3 lower, glm::vec3 upper);

/// Adds a mesh with a material as one instance; returns the instance's index.
std::uint32_t add(Scene& scene, Mesh mesh, const Material& material);

/// A camera at `eye` that looks at `target`, +Y up (or +Z where it looks along Y).
Camera look_at(glm::dvec3 eye, glm::dvec3 target, double vertical_fov = 0.7853981633974483);

/// All lengths times `factor`, intensities of punctual lights times its square: the same picture.
Scene scaled(const Scene& scene, double factor);

/// A tracer that lights surfaces anew where rays meet them.
std::unique_ptr<RayTracer> make_tracer(Device& device, const SceneData& data, const GpuScene& gpu_scene,
                                       const Camera& camera, const RenderSettings& settings);

/// Renders direct/trace.
struct Traced {
    Image image;
    RenderStatistics statistics;
};
Traced trace(Device& device, const Scene& scene, const Camera& camera, const RenderSettings& settings,
             std::uint32_t samples);

}  // namespace utsuri::test
