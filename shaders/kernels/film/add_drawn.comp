// SPDX-License-Identifier: Apache-2.0
// Adds a drawn picture to a film as one sample of each pixel, unless it lacks a map: then it is drawn again.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "interop/bindings.h"
#include "interop/raster.h"
#include "interop/workgroup.h"
#include "kernels/film/counters.glsl"
#include "lib/film.glsl"
#include "lib/pixel_state.glsl"
#include "lib/numeric.glsl"

layout(local_size_x = WORKGROUP_SIZE) in;

layout(push_constant, scalar) uniform Push { AddDrawnPush push; };

layout(scalar, set = METHOD_SET, binding = BINDING_FILM) restrict buffer Film { FilmPixel film[]; };
layout(scalar, set = METHOD_SET, binding = BINDING_DRAWN) readonly restrict buffer Drawn { vec4 drawn[]; };
layout(scalar, set = METHOD_SET, binding = BINDING_MAP_STATES) readonly restrict buffer MapStates { uint wanted_maps; };

void main() {
    uint pixel = gl_GlobalInvocationID.x;
    if (pixel >= push.pixels || wanted_maps > 0u) return;
    vec3 radiance = drawn[pixel].rgb;
    float state = drawn[pixel].a;
    uint rays = rays_of(state);
    bool finite = is_finite(radiance);
    count(Counters(rays, finite ? 0u : 1u, reflections_of(state), rays > 0u ? 1u : 0u, is_truncated(state) ? 1u : 0u, 0u));
    if (!finite) return;
    // Only the half that the sample belongs to is read and written.
    uint parity = push.sample_index & 1u;
    FilmSum half_sum = film[pixel].halves[parity];
    add_compensated(half_sum.sum, half_sum.compensation, radiance);
    film[pixel].halves[parity] = half_sum;
}
