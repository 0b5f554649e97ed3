// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/maps/map_size.h"

#include "renderers/device_scene/closest_hit.h"

#include "geometry/reference_intersection.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace utsuri {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Pixels that are looked at along an edge of the picture, at most.
constexpr std::uint32_t kPixels = 128;
/// One look-up of so many may see finer than its map is: a crease or a focus has no bound.
constexpr std::size_t kSharper = 64;
/// Sizes are multiples of this, the least too: what is seen between the pixels looked at needs a little.
constexpr std::uint32_t kStep = 8;

/// What a pixel sees by way of a reflector.
struct ReflectedSample {
    std::uint32_t reflector;
    glm::dvec3 place;               ///< on it, scene space
    glm::dvec3 direction;           ///< unit
    std::optional<glm::dvec3> hit;  ///< that the ray meets; none if it meets nothing
};

glm::dvec3 shading_normal(const SceneData& scene, const ReferenceHit& hit, const glm::dvec3& direction) {
    const interop::BvhTriangle& triangle = scene.bvh.triangles[hit.triangle];
    const glm::dvec3 v0 = triangle.v0;
    const glm::dvec3 ng = glm::cross(glm::dvec3(triangle.v1) - v0, glm::dvec3(triangle.v2) - v0);
    const glm::uvec3& vertices = scene.triangle_infos[hit.triangle].vertices;
    glm::dvec3 ns = (1.0 - hit.b1 - hit.b2) * glm::dvec3(scene.normals[vertices.x]) +
                    hit.b1 * glm::dvec3(scene.normals[vertices.y]) +
                    hit.b2 * glm::dvec3(scene.normals[vertices.z]);
    if (!(glm::dot(ns, ng) > 0.0)) ns = ng;
    return glm::normalize(glm::dot(ng, direction) < 0.0 ? ns : -ns);
}

class Sights {
  public:
    Sights(const SceneData& scene, const Reflectors& reflectors, MapKind kind, const MapView& view)
        : scene_(scene), reflectors_(reflectors), finds_hits_(finds_hits(kind)), view_(view) {}

    /// @param x, y of the pixel, from the top left corner
    [[nodiscard]] std::optional<ReflectedSample> at(std::uint32_t x, std::uint32_t y) const {
        const double half_height = std::tan(0.5 * view_.camera.vertical_fov);
        const double pixel = 2.0 * half_height / view_.height;
        const glm::dvec3 direction =
            glm::normalize(view_.camera.forward + pixel * (x + 0.5 - 0.5 * view_.width) * view_.camera.right -
                           pixel * (y + 0.5 - 0.5 * view_.height) * view_.camera.up);
        const glm::dvec3 eye = view_.camera.position - scene_.origin;
        const auto first = closest_hit_reference(scene_.bvh, eye, direction, kInfinity);
        if (!first) return std::nullopt;
        const std::uint32_t instance = scene_.triangle_infos[first->triangle].instance;
        const std::uint32_t reflector = reflectors_.instance_reflectors[instance];
        if (reflector == interop::NONE) return std::nullopt;
        const glm::dvec3 normal = shading_normal(scene_, *first, direction);
        ReflectedSample sample{reflector, eye + first->t * direction,
                               direction - 2.0 * glm::dot(direction, normal) * normal, std::nullopt};
        if (!finds_hits_) return sample;
        const auto second = closest_hit_without(scene_, instance, sample.place, sample.direction, kInfinity);
        if (second) sample.hit = sample.place + second->t * sample.direction;
        return sample;
    }

  private:
    /// Whether look-ups are made where rays meet the scene or what stands in for it, not along them.
    static bool finds_hits(MapKind kind) { return kind == MapKind::proxy || keeps_distances(kind); }

    const SceneData& scene_;
    const Reflectors& reflectors_;
    bool finds_hits_;
    const MapView& view_;
};

/// Of the probes of its reflector, the one that a sample's ray passes nearest, as shaders choose.
std::uint32_t nearest_probe(const std::vector<Probe>& probes, const interop::ProbeRange& range,
                            const ReflectedSample& sample) {
    std::uint32_t nearest = range.first;
    double least = kInfinity;
    for (std::uint32_t i = range.first; i < range.first + range.count; ++i) {
        const double passes =
            glm::length(glm::cross(sample.place - probes[i].capture_point, sample.direction));
        if (passes < least) {
            least = passes;
            nearest = i;
        }
    }
    return nearest;
}

/// Unit direction from a point to what a pixel sees.
glm::dvec3 direction_from(const glm::dvec3& point, const ReflectedSample& sample) {
    return sample.hit ? glm::normalize(*sample.hit - point) : sample.direction;
}

/// Root of the solid angle at a point of what a pixel sees, from its neighbours to the right and below.
double angle_at(const glm::dvec3& point, const ReflectedSample& pixel, const ReflectedSample& right,
                const ReflectedSample& below) {
    const glm::dvec3 direction = direction_from(point, pixel);
    return std::sqrt(glm::length(
        glm::cross(direction_from(point, right) - direction, direction_from(point, below) - direction)));
}

std::uint32_t size_for(std::vector<double>& angles, double texel_angle, std::uint32_t most) {
    if (angles.empty()) return std::min(kStep, most);
    const auto chosen = angles.begin() + static_cast<std::ptrdiff_t>(angles.size() / kSharper);
    std::nth_element(angles.begin(), chosen, angles.end());
    const double needed = std::ceil(texel_angle / *chosen / kStep) * kStep;
    return needed < most ? static_cast<std::uint32_t>(needed) : most;
}

}  // namespace

std::vector<std::uint32_t> fit_map_sizes(const SceneData& scene, const Reflectors& reflectors,
                                         const std::vector<Probe>& probes, MapKind kind, const MapView& view,
                                         double texel_angle, std::uint32_t most) {
    const Sights samples(scene, reflectors, kind, view);
    const std::vector<interop::ProbeRange> ranges = probe_ranges(probes, reflectors.instances.size());
    std::vector<std::vector<double>> angles(probes.size());
    const std::uint32_t step = (std::max(view.width, view.height) + kPixels - 1) / kPixels;
    for (std::uint32_t y = 0; y < view.height && !probes.empty(); y += step) {
        // Rows are staggered, so that nothing upright hides between the columns.
        for (std::uint32_t x = y / step % step; x < view.width; x += step) {
            const auto pixel = samples.at(x, y);
            if (!pixel) continue;
            const auto right = samples.at(x + 1, y);
            const auto below = samples.at(x, y + 1);
            if (!right || !below || right->reflector != pixel->reflector ||
                below->reflector != pixel->reflector)
                continue;
            const std::uint32_t probe = nearest_probe(probes, ranges[pixel->reflector], *pixel);
            angles[probe].push_back(angle_at(probes[probe].capture_point, *pixel, *right, *below));
        }
    }
    std::vector<std::uint32_t> sizes;
    sizes.reserve(angles.size());
    for (std::vector<double>& of_probe : angles)
        sizes.push_back(size_for(of_probe, texel_angle, most));
    return sizes;
}

}  // namespace utsuri
