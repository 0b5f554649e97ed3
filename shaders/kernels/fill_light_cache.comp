// SPDX-License-Identifier: Apache-2.0
// Direct light at the points of the light cache, on both sides of each triangle.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/scene_bindings.glsl"
#include "interop/frame.h"
#include "interop/light_cache.h"
#include "lib/direct_light.glsl"
#include "lib/lattice.glsl"

layout(local_size_x = 64) in;

layout(push_constant, scalar) uniform Push { LightCachePush push; };

layout(scalar, binding = BINDING_LIGHT_CACHE_TRIANGLES) readonly restrict buffer CacheTriangles {
    LightCacheTriangle cache_triangles[];
};
layout(scalar, binding = BINDING_COUNTERS) restrict buffer CounterBuffer { Counters counters; };
layout(scalar, binding = BINDING_LIGHT_CACHE_POINTS) restrict buffer CachePoints { LightCachePoint cache_points[]; };

/// The triangle whose lattice holds a point: the last that begins at or before it.
uint triangle_of(uint point) {
    uint first = 0u;
    uint count = push.triangles;
    while (count > 1u) {
        uint half_count = count / 2u;
        if (cache_triangles[first + half_count].first_point <= point) {
            first += half_count;
            count -= half_count;
        } else {
            count = half_count;
        }
    }
    return first;
}

/// The surface there, made white and diffuse.
Surface white_surface(uint triangle, vec2 b, bool front) {
    vec3 normal = triangle_cross(bvh_triangles[triangle]);
    Surface surface = make_surface(Hit(0.0, triangle, b.x, b.y), front ? -normal : normal);
    surface.base_colour = vec3(1.0);
    surface.metallic = 0.0;
    surface.alpha = 0.0;
    surface.f0 = 0.0;
    surface.f90 = 0.0;
    return surface;
}

vec3 add_samples(vec3 sum, uint point, Surface surface, uint side) {
    uint key = sampler_key(uvec2(point, side), push.seed, 0u);
    uint rays = 0u;
    uint s = push.sample_begin;
    for (; s < push.sample_end; ++s) {
        sum += direct_light(surface, surface.ns, key, s, 0u, NONE, rays);
    }
    atomicAdd(counters.rays, rays);
    if (s < push.sample_end) atomicAdd(counters.incomplete, 1u);
    return push.sample_end == push.samples ? sum / float(push.samples) : sum;
}

void main() {
    uint point = push.first_point + gl_GlobalInvocationID.x;
    if (point >= push.end_point) return;
    uint triangle = triangle_of(point);
    LightCacheTriangle lattice = cache_triangles[triangle];
    vec2 b = vec2(lattice_point(lattice.edge, point - lattice.first_point)) / float(lattice.edge);
    LightCachePoint sums = cache_points[point];
    sums.front = add_samples(sums.front, point, white_surface(triangle, b, true), 0u);
    sums.back = add_samples(sums.back, point, white_surface(triangle, b, false), 1u);
    cache_points[point] = sums;
}
