// SPDX-License-Identifier: Apache-2.0
// Adds a drawn picture to a film as one sample of each pixel, unless it lacks a map: then it is drawn again.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "interop/bindings.h"
#include "interop/raster.h"
#include "interop/workgroup.h"
#include "lib/film.glsl"
#include "lib/pixel_state.glsl"
#include "lib/numeric.glsl"

layout(local_size_x = WORKGROUP_SIZE) in;

layout(push_constant, scalar) uniform Push { AddDrawnPush push; };

layout(scalar, set = METHOD_SET, binding = BINDING_FILM) restrict buffer Film { FilmPixel film[]; };
layout(scalar, set = METHOD_SET, binding = BINDING_DRAWN) readonly restrict buffer Drawn { vec4 drawn[]; };
layout(scalar, set = METHOD_SET, binding = BINDING_COUNTERS) restrict buffer CounterBuffer { Counters counters; };
layout(scalar, set = METHOD_SET, binding = BINDING_MAP_STATES) readonly restrict buffer MapStates { uint wanted_maps; };

void main() {
    uint pixel = gl_GlobalInvocationID.x;
    if (pixel >= push.pixels || wanted_maps > 0u) return;
    vec3 radiance = drawn[pixel].rgb;
    uint rays = rays_of(drawn[pixel].a);
    if (rays > 0u) {
        atomicAdd(counters.traced, 1u);
        atomicAdd(counters.rays, rays);
    }
    uint reflections = reflections_of(drawn[pixel].a);
    if (reflections > 0u) atomicAdd(counters.lookups, reflections);
    if (is_truncated(drawn[pixel].a)) atomicAdd(counters.truncated, 1u);
    if (!is_finite(radiance)) {
        atomicAdd(counters.nonfinite, 1u);
        return;
    }
    // Only the half that the sample belongs to is read and written.
    uint parity = push.sample_index & 1u;
    FilmSum state = film[pixel].halves[parity];
    add_compensated(state.sum, state.compensation, radiance);
    film[pixel].halves[parity] = state;
}
