// SPDX-License-Identifier: Apache-2.0
// Direct light at the points of the light cache, on both sides of each triangle, where a change can reach it.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "interop/light_cache.h"
#include "interop/workgroup.h"
#include "kernels/film/counters.glsl"
#include "kernels/light/light_records.glsl"
#include "kernels/scene/direct_light.glsl"
#include "lib/lattice.glsl"
#include "lib/light_reach.glsl"
#include "kernels/scene/unshadowed_light.glsl"

layout(local_size_x = WORKGROUP_SIZE) in;

layout(constant_id = SPEC_SUMS_LIGHTS) const bool SUMS_LIGHTS = false;

layout(push_constant, scalar) uniform Push { LightCachePush push; };

layout(scalar, set = METHOD_SET, binding = BINDING_LIGHT_BOUNDS) readonly restrict buffer LightBoundsBuffer { LightBounds light_bounds[]; };
layout(scalar, set = METHOD_SET, binding = BINDING_CHANGED_BOXES) readonly restrict buffer ChangedBoxes { ChangedBox changed_boxes[]; };
layout(scalar, set = METHOD_SET, binding = BINDING_LIGHT_CACHE_POINTS) writeonly restrict buffer CachePoints { LightCachePoint cache_points[]; };

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

/// Shadow rays after which a point in no shadow so far counts as lit for good. Points in full shadow get all: a little
/// light missed there shows, a little shadow missed in full light does not.
const uint PROBING_RAYS = 16u;

/// What a white surface sends out. Where the lights can be summed in closed form, samples only tell what share of that
/// is not in shadow (Heitz, Hill and McGuire 2018): no noise where nothing or all is in shadow.
vec3 simulate_light(Surface surface, uint side) {
    if (LIGHT_COUNT == 0u) return vec3(0.0);
    vec3 unshadowed = vec3(0.0);
    if (SUMS_LIGHTS) {
        unshadowed = unshadowed_irradiance(surface) / PI;
        if (unshadowed == vec3(0.0)) return unshadowed;
    }
    // All points share their samples: what error these leave then changes smoothly over a surface, where samples of their
    // own would leave blotches.
    uint key = sampler_key(uvec2(0u, side), push.seed, 0u);
    vec3 sampled = vec3(0.0);
    vec3 visible = vec3(0.0);
    uint rays = 0u;
    uint lit = 0u;
    uint s = 0u;
    uint samples = push.samples;
    for (; s < samples; ++s) {
        if (SUMS_LIGHTS && s == PROBING_RAYS && lit == rays) {
            samples = s;
            break;
        }
        Candidate taken = resample_lights(surface, surface.ns, 1u << LOBE_DIFFUSE, sample_2d(key, s, 0u), sample_2d(key, s, 1u));
        if (taken.value == vec3(0.0)) continue;
        sampled += taken.value;
        ++rays;
        if (!is_light_visible(surface, taken.light, NONE)) continue;
        visible += taken.value;
        ++lit;
    }
    // That samples are left cannot be, and is where the driver ended the loop: see film_main.glsl.
    count(Counters(rays, 0u, 0u, 0u, 0u, s < samples ? 1u : 0u));
    if (!SUMS_LIGHTS) return visible / float(s);
    return mix(unshadowed * visible / sampled, vec3(0.0), equal(sampled, vec3(0.0)));
}

bool is_reached(vec3 position) {
    for (uint l = 0u; l < push.light_bounds; ++l) {
        for (uint c = 0u; c < push.changed_boxes; ++c) {
            if (may_block_light(changed_boxes[c], position, light_bounds[l])) return true;
        }
    }
    return false;
}

void main() {
    uint point = push.first_point + gl_GlobalInvocationID.x;
    if (point >= push.end_point) return;
    uint triangle = triangle_of(point);
    LightCacheTriangle lattice = cache_triangles[triangle];
    vec2 b = lattice_point(lattice, point - lattice.first_point).yz;
    Surface front = white_surface(triangle, b, true);
    if (!is_reached(front.position)) return;
    cache_points[point] = LightCachePoint(simulate_light(front, 0u),
                                          simulate_light(white_surface(triangle, b, false), 1u));
}
