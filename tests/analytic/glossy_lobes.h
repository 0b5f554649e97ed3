// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/methods/raster_renderer.h"
#include "support/methods.h"
#include "support/scenes.h"

#include "interop/glossy_map.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace utsuri::test {

/// Of a GGX width.
inline Material metal_of(double alpha, float f0 = 1.0f) {
    return glossy_metal(static_cast<float>(std::sqrt(alpha)), glm::vec3(f0));
}

/// Weight of light from l where normal and viewer lie along n: GGX D(h) times the cosine.
inline double lobe(const glm::dvec3& n, const glm::dvec3& l, double alpha) {
    const double cosine = glm::dot(n, l);
    if (cosine <= 0.0) return 0.0;
    const double cos_h = glm::dot(n, glm::normalize(n + l));
    const double d = cos_h * cos_h * (alpha * alpha - 1.0) + 1.0;
    return cosine / (d * d);
}

/// Mean over the lobe about n of a value of directions, or the share of it where that is true: midpoint rule
/// about n, fine where the lobe is.
template <typename Value>
double mean_over_lobe(const glm::dvec3& n, double alpha, const Value& value) {
    constexpr int kSteps = 200;
    const glm::dvec3 tangent =
        glm::normalize(glm::cross(n, std::abs(n.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
    const glm::dvec3 bitangent = glm::cross(n, tangent);
    double sum = 0.0;
    double weights = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        // tan(t / 2) = alpha s / (1 - s): half of the steps within an alpha of the half vector.
        const double s = (i + 0.5) / kSteps;
        const double t = 2.0 * std::atan(alpha * s / (1.0 - s));
        const double slope = 2.0 * alpha / ((1.0 - s) * (1.0 - s) + alpha * alpha * s * s);
        for (int j = 0; j < kSteps; ++j) {
            const double turn = 2.0 * std::numbers::pi * (j + 0.5) / kSteps;
            const glm::dvec3 l =
                std::cos(t) * n + std::sin(t) * (std::cos(turn) * tangent + std::sin(turn) * bitangent);
            const double weight = lobe(n, l, alpha) * std::sin(t) * slope;
            weights += weight;
            sum += weight * static_cast<double>(value(l));
        }
    }
    return sum / weights;
}

/// Through the centre of a texel of a face, border included, with the convention of shaders/lib/cube.glsl.
/// @param stride texels along an edge of a face, border included
inline glm::dvec3 glossy_map_direction(std::uint32_t face, std::uint32_t column, std::uint32_t row,
                                       std::uint32_t stride) {
    const double size = stride - 2.0 * interop::GLOSSY_MAP_BORDER;
    glm::dvec3 d;
    d[static_cast<int>(face / 2)] = face % 2 == 0 ? 1.0 : -1.0;
    d[static_cast<int>((face / 2 + 1) % 3)] = (2.0 * column - 1.0) / size - 1.0;
    d[static_cast<int>((face / 2 + 2) % 3)] = (2.0 * row - 1.0) / size - 1.0;
    return glm::normalize(d);
}

/// Calls `use` with the maps of a scene's glossy instances, prepared for a kind of map.
template <typename Use>
void with_glossy_maps(Device& device, const Scene& scene, MapKind kind, const MapSettings& settings,
                      const Use& use) {
    const SceneData data = prepare_scene_data(scene);
    const GpuScene gpu_scene(device, data);
    KeptLight light = kept_light(device, data, gpu_scene, evenly_kept(1.0 / 60.0, 4, 0));
    RenderSettings picture;
    picture.width = picture.height = interop::TILE_SIZE;
    RasterRenderer renderer =
        make_raster(device, data, gpu_scene, light, look_at({0, 0, 3}, {0, 0, 0}), kind, picture, settings);
    Progress progress;
    renderer.prepare(progress);
    use(renderer.maps().glossy_maps());
}

}  // namespace utsuri::test
