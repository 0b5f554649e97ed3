// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/reflectors/reflectors.h"

#include "base/error.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <unordered_map>
#include <utility>
#include <vector>

namespace utsuri {
namespace {

bool is_too_long(const interop::ReflectorVertex& a, const interop::ReflectorVertex& b,
                 const PolygonRefinement& refinement) {
    if (refinement.edge && glm::distance(glm::dvec3(a.position), glm::dvec3(b.position)) > *refinement.edge)
        return true;
    if (!refinement.error) return false;
    const glm::dvec3 na(a.normal);
    const glm::dvec3 nb(b.normal);
    const double turn = std::atan2(glm::length(glm::cross(na, nb)), glm::dot(na, nb));
    return interpolation_error(turn) > *refinement.error;
}

interop::ReflectorVertex midpoint(const interop::ReflectorVertex& a, const interop::ReflectorVertex& b) {
    const glm::dvec3 sum = glm::dvec3(a.normal) + glm::dvec3(b.normal);
    const double length = glm::length(sum);
    // Opposite normals have no mean; the middle keeps one of them, and stays coarse.
    return {0.5f * (a.position + b.position), length > 0.0 ? glm::vec3(sum / length) : a.normal};
}

/// Halves the edges of polygons that are too long, once.
class Halving {
  public:
    Halving(Reflectors& reflectors, const PolygonRefinement& refinement)
        : reflectors_(reflectors), refinement_(refinement) {}

    /// @returns whether any edge was halved
    bool run() {
        std::vector<interop::ReflectorTriangle> before;
        std::swap(before, reflectors_.triangles);
        for (const interop::ReflectorTriangle& triangle : before)
            split(triangle);
        return !middles_.empty();
    }

  private:
    struct Corner {
        std::uint32_t vertex;
        glm::vec2 place;
    };

    std::optional<Corner> middle(const Corner& a, const Corner& b) {
        const std::uint64_t key =
            (std::uint64_t{std::min(a.vertex, b.vertex)} << 32) | std::max(a.vertex, b.vertex);
        auto found = middles_.find(key);
        if (found == middles_.end()) {
            const interop::ReflectorVertex& va = reflectors_.vertices[a.vertex];
            const interop::ReflectorVertex& vb = reflectors_.vertices[b.vertex];
            if (!is_too_long(va, vb, refinement_)) return std::nullopt;
            found = middles_.emplace(key, static_cast<std::uint32_t>(reflectors_.vertices.size())).first;
            reflectors_.vertices.push_back(midpoint(va, vb));
        }
        return Corner{found->second, 0.5f * (a.place + b.place)};
    }

    void add(const interop::ReflectorTriangle& parent, const Corner& a, const Corner& b, const Corner& c) {
        interop::ReflectorTriangle triangle = parent;
        triangle.vertices = {a.vertex, b.vertex, c.vertex};
        triangle.places[0] = a.place;
        triangle.places[1] = b.place;
        triangle.places[2] = c.place;
        reflectors_.triangles.push_back(triangle);
    }

    void split(const interop::ReflectorTriangle& t) {
        std::array<Corner, 3> c{};
        for (int i = 0; i < 3; ++i)
            c[static_cast<std::size_t>(i)] = {t.vertices[i], t.places[i]};
        std::array<std::optional<Corner>, 3> m = {middle(c[0], c[1]), middle(c[1], c[2]), middle(c[2], c[0])};
        const auto halved = std::count_if(m.begin(), m.end(), [](const auto& x) { return x.has_value(); });
        if (halved == 0) return add(t, c[0], c[1], c[2]);
        if (halved == 3) {
            for (std::size_t i = 0; i < 3; ++i)
                add(t, c[i], *m[i], *m[(i + 2) % 3]);
            return add(t, *m[0], *m[1], *m[2]);
        }
        // Turned so that the first edge is halved and, of two halved ones, the second follows it.
        std::size_t first = 0;
        while (!m[first] || (halved == 2 && !m[(first + 1) % 3]))
            ++first;
        std::rotate(c.begin(), c.begin() + static_cast<std::ptrdiff_t>(first), c.end());
        std::rotate(m.begin(), m.begin() + static_cast<std::ptrdiff_t>(first), m.end());
        if (halved == 1) {
            add(t, c[0], *m[0], c[2]);
            return add(t, *m[0], c[1], c[2]);
        }
        add(t, *m[0], c[1], *m[1]);
        add(t, c[0], *m[0], *m[1]);
        add(t, c[0], *m[1], c[2]);
    }

    Reflectors& reflectors_;
    const PolygonRefinement& refinement_;
    std::unordered_map<std::uint64_t, std::uint32_t> middles_;  ///< vertices, by the two ends of an edge
};

}  // namespace

Reflectors find_reflectors(const SceneData& scene) {
    return find_reflectors(scene, scene.requirements.reflective_instances);
}

Reflectors find_reflectors(const SceneData& scene, const std::vector<std::uint32_t>& instances) {
    Reflectors result;
    result.instances = instances;
    result.instance_reflectors.assign(scene.requirements.instances, interop::NONE);
    for (std::uint32_t i = 0; i < result.instances.size(); ++i)
        result.instance_reflectors[result.instances[i]] = i;
    if (instances.empty()) return result;
    // Of scene vertices: where each is among the result's.
    std::vector<std::uint32_t> slots(scene.normals.size(), interop::NONE);
    for (std::uint32_t t = 0; t < scene.triangle_infos.size(); ++t) {
        const interop::TriangleInfo& info = scene.triangle_infos[t];
        const std::uint32_t reflector = result.instance_reflectors[info.instance];
        if (reflector == interop::NONE) continue;
        const interop::BvhTriangle& corners = scene.bvh.triangles[t];
        const glm::vec3 positions[3] = {corners.v0, corners.v1, corners.v2};
        interop::ReflectorTriangle triangle{{}, t, {{0, 0}, {1, 0}, {0, 1}}, reflector};
        for (int k = 0; k < 3; ++k) {
            std::uint32_t& slot = slots[info.vertices[k]];
            if (slot == interop::NONE) {
                slot = static_cast<std::uint32_t>(result.vertices.size());
                result.vertices.push_back({positions[k], scene.normals[info.vertices[k]]});
            }
            triangle.vertices[k] = slot;
        }
        result.triangles.push_back(triangle);
    }
    return result;
}

double interpolation_error(double turn) {
    if (turn >= 0.5 * std::numbers::pi) return 0.5 * std::numbers::pi;
    const double root = std::sqrt(std::cos(turn));
    return std::atan(1.0 / root) - std::atan(root);
}

void refine(Reflectors& reflectors, const PolygonRefinement& refinement) {
    if (!refinement.edge && !refinement.error) return;
    const std::size_t polygons = reflectors.triangles.size();
    while (Halving(reflectors, refinement).run()) {
        if (reflectors.triangles.size() > kMostReflectorPolygons) {
            throw UsageError("refine the polygons of reflectors", fmt::format("from {} of them", polygons),
                             fmt::format("they would become more than {}; use a larger --polygon-edge or "
                                         "--polygon-error",
                                         kMostReflectorPolygons));
        }
    }
}

}  // namespace utsuri
