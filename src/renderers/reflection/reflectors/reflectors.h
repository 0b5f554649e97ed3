// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/scene_data.h"

#include "interop/reflection.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace utsuri {

/// The reflective instances of a scene and the polygons of their surfaces.
struct Reflectors {
    std::vector<std::uint32_t> instances;            ///< scene instance of each reflector
    std::vector<std::uint32_t> instance_reflectors;  ///< one per scene instance: its reflector, or NONE
    std::vector<interop::ReflectorVertex> vertices;
    std::vector<interop::ReflectorTriangle> triangles;
};

/// @param instances that count as reflective, ascending
Reflectors find_reflectors(const SceneData& scene, const std::vector<std::uint32_t>& instances);
/// All reflective instances of a scene.
Reflectors find_reflectors(const SceneData& scene);

/// How fine the polygons of reflectors have to be.
struct PolygonRefinement {
    std::optional<double> edge;  ///< longest edge, metres, > 0
    std::optional<double>
        error;  ///< largest interpolation error of reflection vectors seen from afar, radians, > 0
};

/// Largest error of interpolating unit reflection vectors between two vertices whose normals are `turn`
/// apart, in radians, for a far eye: the general case, across the plane of incidence. About turn^2 / 4.
double interpolation_error(double turn);

/// Halves edges until every polygon is fine enough: an edge's fate depends on the edge alone, so that no gap
/// opens between neighbours. New vertices lie on the old polygons; their normals are the mean of their
/// neighbours'.
/// @throws UsageError if that takes more polygons than kMostReflectorPolygons
void refine(Reflectors& reflectors, const PolygonRefinement& refinement);

/// Polygons that the kernels which cut them can count: Mesa's software driver ends all loops of an invocation
/// after 65535 iterations together, and each of the 64 invocations of a prefix sum goes over its share of the
/// polygons twice.
inline constexpr std::size_t kMostReflectorPolygons = 2'000'000;

}  // namespace utsuri
