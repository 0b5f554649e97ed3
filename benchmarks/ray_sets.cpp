// SPDX-License-Identifier: Apache-2.0
#include "ray_sets.h"

#include "renderers/film/frame_camera.h"

#include "base/sampler.h"
#include "geometry/reference_intersection.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>
#include <numbers>

namespace utsuri {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
/// Contestants get the same origins, moved off the surface by this part of the distance travelled.
constexpr double kOriginOffset = 1e-4;

interop::RayInfo camera_ray(const interop::CameraInfo& camera, glm::uvec2 pixel, glm::uvec2 size) {
    const float x = 2.0f * (static_cast<float>(pixel.x) + 0.5f) / static_cast<float>(size.x) - 1.0f;
    const float y = 1.0f - 2.0f * (static_cast<float>(pixel.y) + 0.5f) / static_cast<float>(size.y);
    return {camera.origin, glm::normalize(camera.forward + x * camera.right + y * camera.up), kInfinity,
            interop::NONE};
}

glm::dvec3 facing_normal(const interop::BvhTriangle& triangle, const glm::dvec3& direction) {
    const glm::dvec3 v0(triangle.v0);
    const glm::dvec3 normal =
        glm::normalize(glm::cross(glm::dvec3(triangle.v1) - v0, glm::dvec3(triangle.v2) - v0));
    return glm::dot(normal, direction) < 0.0 ? normal : -normal;
}

glm::dvec3 cosine_direction(const glm::dvec3& normal, glm::vec2 u) {
    const double z = 1.0 - 2.0 * static_cast<double>(u.x);
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(u.y);
    const double radius = std::sqrt(std::max(0.0, 1.0 - z * z));
    return glm::normalize(1.0001 * normal +
                          glm::dvec3(radius * std::cos(angle), radius * std::sin(angle), z));
}

/// A point of the light that a sample picks; lights without a place are replaced by the middle of the scene.
glm::dvec3 light_point(const SceneData& data, glm::vec2 choice, glm::vec2 u) {
    if (data.lights.empty()) return glm::dvec3(0.0);
    const auto index =
        static_cast<std::size_t>(static_cast<double>(choice.x) * static_cast<double>(data.lights.size()));
    const interop::LightInfo& light = data.lights[index];
    if (light.triangle == interop::NONE) return glm::dvec3(light.position);
    const interop::BvhTriangle& triangle = data.bvh.triangles[light.triangle];
    const double root = std::sqrt(static_cast<double>(u.x));
    return (1.0 - root) * glm::dvec3(triangle.v0) +
           root * (1.0 - static_cast<double>(u.y)) * glm::dvec3(triangle.v1) +
           root * static_cast<double>(u.y) * glm::dvec3(triangle.v2);
}

void add_secondary_rays(const SceneData& data, const interop::RayInfo& ray, glm::uvec2 pixel, RaySets& sets) {
    const glm::dvec3 origin(ray.origin);
    const glm::dvec3 direction(ray.direction);
    const auto hit =
        closest_hit_reference(data.bvh, origin, direction, std::numeric_limits<double>::infinity());
    if (!hit) return;
    const glm::dvec3 normal = facing_normal(data.bvh.triangles[hit->triangle], direction);
    const glm::dvec3 point = origin + hit->t * direction + kOriginOffset * hit->t * normal;
    const std::uint32_t key = sampler_key(pixel, 0, 0);
    const glm::vec3 bounce(cosine_direction(normal, sample_2d(key, 0, 0)));
    sets.diffuse.push_back({glm::vec3(point), bounce, kInfinity, interop::NONE});
    const glm::dvec3 target = light_point(data, sample_2d(key, 0, 1), sample_2d(key, 0, 2));
    sets.shadow.push_back(
        {glm::vec3(point), glm::vec3((1.0 - kOriginOffset) * (target - point)), 1.0f, interop::NONE});
}

}  // namespace

RaySets make_ray_sets(const SceneData& data, const Camera& camera, std::uint32_t width,
                      std::uint32_t height) {
    const interop::CameraInfo info = make_camera_info(camera, data.origin, width, height);
    RaySets sets;
    for (std::uint32_t tile_y = 0; tile_y < height; tile_y += interop::TILE_SIZE) {
        for (std::uint32_t tile_x = 0; tile_x < width; tile_x += interop::TILE_SIZE) {
            for (std::uint32_t i = 0; i < interop::TILE_SIZE * interop::TILE_SIZE; ++i) {
                // Blocks of 4 x 2 pixels, as in shaders/kernels/film/film_bindings.glsl.
                const glm::uvec2 pixel(tile_x + ((i & 3u) | ((i >> 1) & 4u)),
                                       tile_y + (((i >> 2) & 1u) | ((i >> 3) & 6u)));
                if (pixel.x >= width || pixel.y >= height) continue;
                sets.primary.push_back(camera_ray(info, pixel, {width, height}));
                add_secondary_rays(data, sets.primary.back(), pixel, sets);
            }
        }
    }
    return sets;
}

}  // namespace utsuri
