// SPDX-License-Identifier: Apache-2.0
// Direct light at places on surfaces, on both sides of each, unless what is kept there is known to be right.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "interop/light_mesh.h"
#include "interop/workgroup.h"
#include "kernels/film/counters.glsl"
#include "kernels/scene/direct_light.glsl"
#include "lib/light_reach.glsl"
#include "kernels/light/light_shadows.glsl"

layout(local_size_x = WORKGROUP_SIZE) in;

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

struct SideLight {
    vec3 light;          ///< of a white surface, cd/m2
    GroupStates states;
};

/// @param expected of its groups
SideLight simulate_light(Surface surface, uint side, GroupStates expected) {
    SideLight result = SideLight(vec3(0.0), GroupStates(0u, 0u));
    if (LIGHT_COUNT == 0u) return result;
    // All points share their samples: what error these leave then changes smoothly over a surface, where samples of their
    // own would leave blotches.
    uint key = sampler_key(uvec2(0u, side), push.seed, 0u);
    Counters counters = Counters(0u, 0u, 0u, 0u, 0u, 0u);
    if (SUMS_LIGHTS) {
        result.light = shadowed_irradiance(surface, key, expected, result.states, counters) / PI;
    } else {
        uint s = 0u;
        for (; s < push.samples; ++s) {
            result.light += direct_light(surface, surface.ns, 1u << LOBE_DIFFUSE, key, s, 0u, NONE, counters.rays);
        }
        result.light /= float(push.samples);
        if (s < push.samples) counters.incomplete = 1u;
    }
    count(counters);
    return result;
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
    LightMeshPoint result = LightMeshPoint(vec3(0.0), vec3(0.0), 0u, 0u);
    // A loop, so that drivers compile one copy of all that is in it.
    for (uint side = 0u; side < 2u; ++side) {
        Surface surface = white_surface(place.triangle, b, side == 0u);
        if (place.known == 1u && !is_reached(surface.position)) return;
        uint shift = side * MOST_LIGHT_GROUPS;
        GroupStates expected = GroupStates(place.lit >> shift & ALL_LIGHT_GROUPS, place.dark >> shift & ALL_LIGHT_GROUPS);
        SideLight found = simulate_light(surface, side, expected);
        if (side == 0u) {
            result.front = found.light;
        } else {
            result.back = found.light;
        }
        result.lit |= found.states.lit << shift;
        result.dark |= found.states.dark << shift;
    }
    points[point] = result;
}
