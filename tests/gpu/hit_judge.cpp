// SPDX-License-Identifier: Apache-2.0
#include "gpu/hit_judge.h"

#include "geometry/reference_intersection.h"

#include <fmt/format.h>
#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace utsuri::test {
namespace {

constexpr double kUnitRoundoff = 0x1p-24;
/// Terms of higher order in the unit roundoff, and the float64 arithmetic itself.
constexpr double kHigherOrder = 1.001;

/// A vertex moved into the space where the ray is the z axis, with bounds on the float32 errors.
struct ShearedVertex {
    double x, y, z;
    double x_error, y_error;
};

/// Two components of the direction over the third, and which is the third.
struct Shear {
    int axis;
    double x, y, z;
};

Shear shear_of(const glm::vec3& direction) {
    const glm::dvec3 d(direction);
    const glm::dvec3 a = glm::abs(d);
    const int axis = a.x >= a.y ? (a.x >= a.z ? 0 : 2) : (a.y >= a.z ? 1 : 2);
    const double longest = d[axis];
    return {axis, d[(axis + 1) % 3] / longest, d[(axis + 2) % 3] / longest, longest};
}

ShearedVertex shear_vertex(const glm::vec3& vertex, const glm::vec3& origin, const Shear& shear) {
    const glm::dvec3 r = glm::dvec3(vertex) - glm::dvec3(origin);
    const double rx = r[(shear.axis + 1) % 3];
    const double ry = r[(shear.axis + 2) % 3];
    const double rz = r[shear.axis];
    // Roundings of r: 1. Of shear * z: r.z 1, reciprocal 5 (2.5 ulp on a GPU), shear 1, product 1. Of the
    // difference: 1.
    const auto error = [&](double xy, double slope) {
        return kUnitRoundoff * kHigherOrder * (2.0 * std::abs(xy) + 9.0 * std::abs(slope * rz));
    };
    return {rx - shear.x * rz, ry - shear.y * rz, rz, error(rx, shear.x), error(ry, shear.y)};
}

struct Bounded {
    double value;
    double error;
};

/// p.x q.y - p.y q.x with two products and a difference rounded.
Bounded edge_function(const ShearedVertex& p, const ShearedVertex& q) {
    const double px = std::abs(p.x) + p.x_error;
    const double py = std::abs(p.y) + p.y_error;
    const double qx = std::abs(q.x) + q.x_error;
    const double qy = std::abs(q.y) + q.y_error;
    const double from_operands = p.x_error * qy + px * q.y_error + p.y_error * qx + py * q.x_error;
    const double from_rounding = 2.0 * kUnitRoundoff * (px * qy + py * qx);
    return {p.x * q.y - p.y * q.x, kHigherOrder * (from_operands + from_rounding)};
}

bool is_excluded(const interop::RayInfo& ray, std::uint32_t triangle) {
    return ray.excluded == triangle;
}

}  // namespace

TriangleDecision decide(const interop::BvhTriangle& triangle, const interop::RayInfo& ray) {
    const Shear shear = shear_of(ray.direction);
    const ShearedVertex a = shear_vertex(triangle.v0, ray.origin, shear);
    const ShearedVertex b = shear_vertex(triangle.v1, ray.origin, shear);
    const ShearedVertex c = shear_vertex(triangle.v2, ray.origin, shear);
    const std::array<Bounded, 3> edges = {edge_function(c, b), edge_function(a, c), edge_function(b, a)};
    const std::array<double, 3> depths = {a.z, b.z, c.z};

    TriangleDecision decision;
    const auto all = [&](const auto& predicate) {
        return std::all_of(edges.begin(), edges.end(), predicate);
    };
    decision.possible = all([](const Bounded& e) { return e.value >= -e.error; }) ||
                        all([](const Bounded& e) { return e.value <= e.error; });
    decision.certain = all([](const Bounded& e) { return e.value > e.error; }) ||
                       all([](const Bounded& e) { return e.value < -e.error; });

    double determinant = 0.0;
    double magnitude = 0.0;
    double determinant_error = 0.0;
    for (const Bounded& edge : edges) {
        determinant += edge.value;
        magnitude += std::abs(edge.value);
        determinant_error += edge.error;
    }
    determinant_error += 2.0 * kUnitRoundoff * magnitude;
    const double safe = std::abs(determinant) - determinant_error;
    if (!(safe > 0.0)) {
        decision.t_error = std::numeric_limits<double>::infinity();
        decision.certain = false;
        return decision;
    }
    double depth = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
        depth += edges[i].value * depths[i] / determinant;
    // Errors of the edge functions move the weighted mean of the depths by their distance from it. Depths are
    // rounded once, products once, their sum twice, the determinant's sum twice; then two reciprocals of 2.5
    // ulp, two products.
    double error = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        error += edges[i].error * std::abs(depths[i] - depth) / safe;
        error += kUnitRoundoff * std::abs(edges[i].value) *
                 (4.0 * std::abs(depths[i]) + 2.0 * std::abs(depth)) / safe;
    }
    error += 12.0 * kUnitRoundoff * (std::abs(depth) + error);
    decision.t = depth / shear.z;
    decision.t_error = kHigherOrder * error / std::abs(shear.z);
    return decision;
}

Verdict judge(const Bvh& bvh, const interop::RayInfo& ray, const interop::HitInfo& hit,
              std::string& explanation) {
    const bool found = hit.triangle != interop::NONE;
    const auto t = static_cast<double>(hit.t);
    if (found) {
        if (hit.triangle >= bvh.triangles.size() || is_excluded(ray, hit.triangle)) {
            explanation = fmt::format("triangle {} cannot be hit", hit.triangle);
            return Verdict::wrong;
        }
        const TriangleDecision own = decide(bvh.triangles[hit.triangle], ray);
        const bool in_range = hit.t > 0.0f && hit.t <= ray.t_max;
        // Written so that a NaN is wrong; an infinite bound lets every number pass.
        if (!own.possible || !in_range || !(std::abs(t - own.t) <= own.t_error || std::isinf(own.t_error))) {
            explanation =
                fmt::format("triangle {} is hit at t = {}, not at {} +- {} (possible: {}, in range: {})",
                            hit.triangle, t, own.t, own.t_error, own.possible, in_range);
            return Verdict::wrong;
        }
    }
    const double limit = found ? t : static_cast<double>(ray.t_max);
    const glm::dvec3 origin(ray.origin);
    const glm::dvec3 direction(ray.direction);
    const auto certain = closest_hit_reference(bvh, origin, direction, limit, [&](std::uint32_t triangle) {
        if (is_excluded(ray, triangle)) return false;
        const TriangleDecision decision = decide(bvh.triangles[triangle], ray);
        return decision.certain && decision.t > decision.t_error && decision.t + decision.t_error < limit;
    });
    if (certain) {
        explanation =
            fmt::format("triangle {} at t = {} is passed through; found {} at {}", certain->triangle,
                        certain->t, found ? fmt::format("{}", hit.triangle) : "nothing", t);
        return Verdict::wrong;
    }
    const auto truth =
        closest_hit_reference(bvh, origin, direction, static_cast<double>(ray.t_max),
                              [&](std::uint32_t triangle) { return !is_excluded(ray, triangle); });
    const std::uint32_t true_triangle = truth ? truth->triangle : interop::NONE;
    return true_triangle == hit.triangle ? Verdict::exact : Verdict::within_rounding;
}

}  // namespace utsuri::test
