// SPDX-License-Identifier: Apache-2.0
// Light kept on surfaces.
#ifndef UTSURI_KERNELS_LIGHT_KEPT_LIGHT
#define UTSURI_KERNELS_LIGHT_KEPT_LIGHT
#include "kernels/light/light_records.glsl"
#include "lib/lattice.glsl"

layout(scalar, set = METHOD_SET, binding = BINDING_LIGHT_CACHE_POINTS) readonly restrict buffer CachePoints {
    LightCachePoint cache_points[];
};

/// What a white diffuse surface would send out at a point of a triangle, to one side, cd/m2.
/// @param record light_record() of the triangle
/// @param b barycentric coordinates b1, b2
vec3 kept_light(uvec4 record, vec2 b, bool front) {
    LightCacheTriangle lattice = LightCacheTriangle(record.x, record.y, record.z, record.w);
    if (lattice.intervals == 0u) return vec3(0.0);
    LatticeCell cell = lattice_cell(lattice, vec3(1.0 - b.x - b.y, b));
    uvec4 points = lattice.first_point + cell.points;
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        sum += cell.weights[i] * (front ? cache_points[points[i]].front : cache_points[points[i]].back);
    }
    return sum;
}

#endif
