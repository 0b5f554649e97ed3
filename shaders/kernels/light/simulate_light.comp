// SPDX-License-Identifier: Apache-2.0
// Direct light at places on surfaces, on both sides of each, unless what is kept there is known to be right.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "interop/light_mesh.h"
#include "interop/workgroup.h"
#include "kernels/film/counters.glsl"
#include "kernels/scene/direct_light.glsl"
#include "lib/light_reach.glsl"
#include "kernels/light/unshadowed_light.glsl"

layout(local_size_x = WORKGROUP_SIZE) in;

layout(push_constant, scalar) uniform Push { LightPush push; };

layout(scalar, set = METHOD_SET, binding = BINDING_LIGHT_BOUNDS) readonly restrict buffer LightBoundsBuffer { LightBounds light_bounds[]; };
layout(scalar, set = METHOD_SET, binding = BINDING_CHANGED_BOXES) readonly restrict buffer ChangedBoxes { ChangedBox changed_boxes[]; };
layout(scalar, set = METHOD_SET, binding = BINDING_LIGHT_PLACES) readonly restrict buffer Places { LightMeshPlace places[]; };
layout(scalar, set = METHOD_SET, binding = BINDING_LIGHT_MESH_POINTS) writeonly restrict buffer Points { LightMeshPoint points[]; };

/// The surface there, made white and diffuse.
Surface white_surface(uint triangle, vec2 b, bool front) {
    vec3 normal = triangle_cross(bvh_triangle(triangle));
    Surface surface = make_surface(Hit(0.0, triangle, b.x, b.y), front ? -normal : normal);
    surface.base_colour = vec3(1.0);
    surface.metallic = 0.0;
    surface.alpha = 0.0;
    surface.f0 = vec3(0.0);
    surface.f90 = 0.0;
    return surface;
}

/// Samples after which a point in no shadow so far counts as lit for good, and one in full shadow as dark: a little light
/// missed there shows more than a little shadow missed in full light.
const uint LIT_AFTER_SAMPLES = 16u;
const uint DARK_AFTER_SAMPLES = 32u;

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
        bool is_lit = SUMS_LIGHTS && s == LIT_AFTER_SAMPLES && lit == rays && lit > 0u;
        bool is_dark = s == DARK_AFTER_SAMPLES && lit == 0u && rays > 0u;
        if (is_lit || is_dark) {
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
    LightMeshPlace place = places[point];
    vec2 b = vec2(place.b1, place.b2);
    Surface front = white_surface(place.triangle, b, true);
    if (place.known == 1u && !is_reached(front.position)) return;
    points[point] = LightMeshPoint(simulate_light(front, 0u), simulate_light(white_surface(place.triangle, b, false), 1u));
}
