// SPDX-License-Identifier: Apache-2.0
// Follows the reflections that drawn pixels left to rays, and adds what they bring to the picture. Of a glossy lobe that is
// one light sample with a shadow ray, and a ray in one direction of the lobe; where rays end, diffuse light is taken from
// where it is kept.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "interop/raster.h"
#include "interop/workgroup.h"
#include "kernels/trace/kept_surface_light.glsl"
#include "lib/pixel_state.glsl"

layout(local_size_x = WORKGROUP_SIZE) in;

layout(push_constant, scalar) uniform Push { DeferredPush push; };

layout(scalar, set = METHOD_SET, binding = BINDING_FRAME) uniform Frame { FrameInfo frame; };
layout(scalar, set = METHOD_SET, binding = BINDING_DRAWN) restrict buffer Drawn { vec4 drawn[]; };
layout(scalar, set = METHOD_SET, binding = BINDING_THROUGHPUT) readonly restrict buffer Throughputs { vec4 throughputs[]; };
layout(scalar, set = METHOD_SET, binding = BINDING_DEFERRED) readonly restrict buffer Reflections {
    DeferredReflection reflections[];
};
layout(scalar, set = METHOD_SET, binding = BINDING_DEFERRED_COUNT) readonly restrict buffer Count { DeferredCount count; };
layout(scalar, set = METHOD_SET, binding = BINDING_DEFERRED_PIXELS) readonly restrict buffer Pixels { uint pixels[]; };
layout(scalar, set = METHOD_SET, binding = BINDING_DEFERRED_VIEWS) readonly restrict buffer Views { DeferredView views[]; };

/// A deferred reflection, and the surface that reflects.
struct Reflection {
    Surface surface;
    vec3 wo;
    uint before;  ///< reflections that lie between the surface and the eye
    bool by_lobe;
};

Reflection find_reflection(DeferredReflection reflection) {
    DeferredView view = views[reflection.request >> DEFERRED_VIEW_SHIFT];
    vec3 place = triangle_point(bvh_triangle(reflection.triangle), reflection.b1, reflection.b2);
    Surface surface = make_surface(Hit(0.0, reflection.triangle, reflection.b1, reflection.b2), place - view.eye);
    return Reflection(surface, normalize_any_scale(view.eye - surface.position), view.reflections,
                      (reflection.request & DEFERRED_KIND) == DEFERRED_LOBE);
}

vec3 follow(Reflection reflection, uint key, inout Counters totals) {
    Surface surface = reflection.surface;
    uint index = frame.sample_index >> 1;
    uint dimension = FIRST_SURFACE_DIMENSION + reflection.before * DIMENSIONS_PER_SURFACE;
    vec3 radiance = vec3(0.0);
    LobeSample lobe = sample_mirror(surface, reflection.wo);
    if (HAS_GLOSSY && reflection.by_lobe) {
        radiance = direct_light(surface, reflection.wo, 1u << LOBE_GLOSSY, key, index, dimension, NONE, totals.rays);
        lobe = sample_glossy(surface, reflection.wo, sample_2d(key, index, dimension + 2u));
    }
    if (lobe.throughput == vec3(0.0)) return radiance;
    Ray ray = make_ray(leave_surface(surface, lobe.direction), lobe.direction, surface.triangle, NONE);
    Chain chain = Chain(ray, reflection.before + 1u, lobe.throughput, reflection.by_lobe, lobe, receiver_of(surface));
    return radiance + follow_chain(chain, frame.max_depth, key, index, totals);
}

/// @returns the state of a pixel whose reflection was followed; see pixel_state.glsl
float state_after(uint kind, uint before, Counters totals) {
    bool cut = totals.truncated > 0u;
    return kind == DEFERRED_PLANE_MIRROR ? traced_at_plane_mirror(before, totals.rays, cut)
                                         : found_by_rays(before, totals.rays, cut);
}

/// How likely it was that the reflection is followed.
float chance_of(uint request) {
    return float((request >> DEFERRED_CHANCE_SHIFT) % DEFERRED_CHANCES + 1u) / float(DEFERRED_CHANCES);
}

void main() {
    if (gl_GlobalInvocationID.x >= count.pixels) return;
    uint slot = pixels[gl_GlobalInvocationID.x];
    uvec2 pixel = uvec2(slot % frame.width, push.first_row + slot / frame.width);
    DeferredReflection deferred = reflections[slot];
    Counters totals = Counters(0u, 0u, 0u, 0u, 0u, 0u);
    Reflection reflection = find_reflection(deferred);
    vec3 radiance = follow(reflection, sampler_key(pixel, frame.seed, frame.sample_index & 1u), totals);
    bool by_eye = deferred.request >> DEFERRED_VIEW_SHIFT == 0u;
    vec3 throughput = by_eye ? vec3(1.0) : throughputs[slot].rgb;
    drawn[slot].rgb += throughput * radiance / chance_of(deferred.request);
    // No ray is needed where no light and no part of a lobe is above the surface.
    if (totals.rays > 0u) drawn[slot].a = state_after(deferred.request & DEFERRED_KIND, reflection.before, totals);
}
