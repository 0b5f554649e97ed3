// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/maps/map_settings.h"

#include "base/error.h"
#include "geometry/convex_region.h"
#include "geometry/half_space.h"

#include "interop/reflection.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace utsuri {
namespace {

/// Planes that bound a solid, at least.
constexpr std::size_t kLeastPlanes = 4;
/// By how much the length of a unit vector may be off: components of float32 pass.
constexpr double kUnitTolerance = 1e-6;

[[noreturn]] void fail(std::string_view setting, std::string_view problem) {
    throw UsageError("use map settings", setting, problem);
}

void check_range(std::uint32_t value, std::uint32_t most, std::string_view setting) {
    if (value < 1 || value > most) fail(setting, fmt::format("is {}; must be from 1 to {}", value, most));
}

void check_planes(const std::vector<HalfSpace>& planes, const std::string& solid) {
    if (planes.size() < kLeastPlanes || planes.size() > interop::MAP_MOST_FACES) {
        fail(solid, fmt::format("has {} planes; must have {} to {}", planes.size(), kLeastPlanes,
                                interop::MAP_MOST_FACES));
    }
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const double length = glm::length(planes[i].normal);
        if (!(std::abs(length - 1.0) <= kUnitTolerance)) {
            fail(fmt::format("{}.planes[{}].normal", solid, i),
                 fmt::format("has length {:g}; must be a unit vector", length));
        }
        if (!std::isfinite(planes[i].offset))
            fail(fmt::format("{}.planes[{}]", solid, i), "is not at a finite distance; must be");
    }
}

void check_polyhedron(const Polyhedron& polyhedron) {
    std::vector<HalfSpace> planes;
    for (const Polyhedron::Plane& plane : polyhedron.planes)
        planes.push_back({plane.normal, plane.distance});
    check_planes(planes, "polyhedron");
    for (std::size_t i = 0; i < planes.size(); ++i) {
        if (planes[i].offset > 0.0) continue;
        fail(fmt::format("polyhedron.planes[{}].distance", i),
             fmt::format("is {:g}; must be above 0: the capture point lies inside", planes[i].offset));
    }
    if (const auto plane = plane_without_face(polyhedron)) {
        fail(fmt::format("polyhedron.planes[{}]", *plane),
             "bounds no face; the planes must enclose the capture point, and each must touch the polyhedron "
             "they enclose");
    }
}

void check_proxy(const GivenProxy& proxy) {
    check_planes(proxy.planes, "proxy");
    const std::optional<ConvexRegion> region = enclosed_region(proxy.planes);
    if (!region) {
        fail("proxy",
             "its planes enclose nothing; they must leave no side open, with normals that point out "
             "of the proxy");
    }
    if (const auto plane = plane_without_face(region->about_inside)) {
        fail(fmt::format("proxy.planes[{}]", *plane),
             "bounds no face; each must touch the polyhedron that all enclose, once");
    }
}

void check_tolerance(const Tolerance& tolerance) {
    const bool is_share = tolerance.of == Tolerance::Of::radiance;
    const double least = is_share ? kLeastRadianceTolerance : 0.0;
    const double most = is_share ? kMostRadianceTolerance : kMostPlaceTolerance;
    if (tolerance.most >= least && tolerance.most <= most) return;
    fail("tolerance.most", fmt::format("is {:g}; must be {} from {:g} to {:g}", tolerance.most,
                                       is_share ? "a share of the radiance" : "pixels", least, most));
}

void check_refinement(const std::optional<double>& value, std::string_view setting, std::string_view unit) {
    if (value && !(*value > 0.0))
        fail(setting, fmt::format("is {:g} {}; must be above 0, or not set", *value, unit));
}

}  // namespace

void check_map_settings(const MapSettings& settings) {
    check_range(settings.size, kLargestMapSize, "size");
    check_range(settings.samples, kMostMapSamples, "samples");
    check_range(settings.most_probes, kMostProbes, "most_probes");
    if (const std::optional<glm::dvec3>& point = settings.capture_point) {
        if (!std::isfinite(point->x) || !std::isfinite(point->y) || !std::isfinite(point->z))
            fail("capture_point", "is not finite; must be, or not set");
    }
    check_polyhedron(settings.polyhedron);
    if (settings.proxy) check_proxy(*settings.proxy);
    check_refinement(settings.refinement.edge, "refinement.edge", "m");
    check_refinement(settings.refinement.error, "refinement.error", "radians");
    if (settings.most_cut_pieces == 0u) fail("most_cut_pieces", "is 0; must be at least 1, or not set");
    check_tolerance(settings.tolerance);
}

}  // namespace utsuri
