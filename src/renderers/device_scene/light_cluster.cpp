// SPDX-License-Identifier: Apache-2.0
#include "renderers/device_scene/light_cluster.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace utsuri {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kAxisScale = 32767.0;

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// Lights that shine to both sides may turn their normals towards the others'.
DirectionCone turned_towards(DirectionCone cone, bool may_turn, const DirectionCone& other) {
    if (may_turn && glm::dot(cone.axis, other.axis) < 0.0) cone.axis = -cone.axis;
    return cone;
}

float rounded_up(double value) {
    return std::nextafter(static_cast<float>(value), std::numeric_limits<float>::infinity());
}

}  // namespace

DirectionCone joined(const DirectionCone& a, const DirectionCone& b) {
    if (a.angle < 0.0) return b;
    if (b.angle < 0.0) return a;
    const double between = angle_between(a.axis, b.axis);
    if (between + b.angle <= a.angle) return a;
    if (between + a.angle <= b.angle) return b;
    const double angle = 0.5 * (a.angle + between + b.angle);
    const glm::dvec3 side = glm::cross(glm::cross(a.axis, b.axis), a.axis);
    if (angle >= kPi || glm::length(side) == 0.0) return {a.axis, kPi};
    const double turn = angle - a.angle;
    return {std::cos(turn) * a.axis + std::sin(turn) * glm::normalize(side), angle};
}

double LightSummary::cost() const {
    // Conty Estevez and Kulla 2018, equation 1, for lights that shine by the cosine.
    const double spread = std::clamp(normals.angle, 0.0, kPi);
    const double reach = std::min(spread + 0.5 * kPi, kPi);
    const double solid_angle = 2.0 * kPi * (1.0 - std::cos(spread)) +
                               0.5 * kPi *
                                   (2.0 * reach * std::sin(spread) - std::cos(spread - 2.0 * reach) -
                                    2.0 * spread * std::sin(spread) + std::cos(spread));
    const glm::dvec3 size = upper - lower;
    return power * solid_angle * glm::dot(size, size);
}

LightSummary joined(const LightSummary& a, const LightSummary& b) {
    if (a.power == 0.0) return b;
    if (b.power == 0.0) return a;
    LightSummary both{glm::min(a.lower, b.lower),
                      glm::max(a.upper, b.upper),
                      {},
                      a.both_sides || b.both_sides,
                      a.power + b.power};
    both.normals = joined(a.normals, turned_towards(b.normals, b.both_sides || a.both_sides, a.normals));
    return both;
}

std::uint32_t pack_axis(const glm::dvec3& axis) {
    const double sum = std::abs(axis.x) + std::abs(axis.y) + std::abs(axis.z);
    glm::dvec2 p = glm::dvec2(axis) / sum;
    if (axis.z < 0.0) {
        const glm::dvec2 sign(p.x >= 0.0 ? 1.0 : -1.0, p.y >= 0.0 ? 1.0 : -1.0);
        p = (1.0 - glm::abs(glm::dvec2(p.y, p.x))) * sign;
    }
    const auto word = [](double x) {
        return static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lround(x * kAxisScale))) & 0xffffu;
    };
    return word(p.x) | word(p.y) << 16;
}

glm::dvec3 unpack_axis(std::uint32_t packed) {
    const auto coordinate = [](std::uint32_t word) {
        return static_cast<double>(static_cast<std::int16_t>(word & 0xffffu)) / kAxisScale;
    };
    glm::dvec3 axis(coordinate(packed), coordinate(packed >> 16), 0.0);
    axis.z = 1.0 - std::abs(axis.x) - std::abs(axis.y);
    const double folded = std::max(-axis.z, 0.0);
    axis.x += axis.x >= 0.0 ? -folded : folded;
    axis.y += axis.y >= 0.0 ? -folded : folded;
    return glm::normalize(axis);
}

interop::LightCluster pack_cluster(const LightSummary& lights, double total, std::uint32_t child) {
    interop::LightCluster cluster{};
    const glm::dvec3 centre = 0.5 * (lights.lower + lights.upper);
    cluster.centre = glm::vec3(centre);
    const glm::dvec3 far = glm::max(glm::abs(lights.lower - glm::dvec3(cluster.centre)),
                                    glm::abs(lights.upper - glm::dvec3(cluster.centre)));
    cluster.radius = lights.lower == lights.upper ? 0.0f : rounded_up(glm::length(far));
    cluster.power = static_cast<float>(lights.power / total);
    cluster.axis = pack_axis(lights.normals.axis);
    const double off = angle_between(unpack_axis(cluster.axis), lights.normals.axis);
    const double spread = std::min(lights.normals.angle + off, kPi);
    cluster.cos_spread = std::max(-rounded_up(-std::cos(spread)), -1.0f);
    cluster.child = child | (lights.both_sides ? interop::LIGHT_CLUSTER_BOTH_SIDES : 0);
    return cluster;
}

}  // namespace utsuri
