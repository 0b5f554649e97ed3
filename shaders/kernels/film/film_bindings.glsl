// SPDX-License-Identifier: Apache-2.0
// What kernels that render into a film share: push constants, film, counters, and which pixel an invocation works on.
#include "interop/bindings.h"
#include "interop/frame.h"
#include "lib/camera.glsl"
#include "lib/film.glsl"

layout(local_size_x = 64) in;  // TILE_SIZE * TILE_SIZE

layout(constant_id = SPEC_PROJECTION) const uint PROJECTION = PROJECTION_PERSPECTIVE;

layout(push_constant, scalar) uniform Push { FramePush push; };

layout(scalar, binding = BINDING_FILM) restrict buffer Film { FilmPixel film[]; };
layout(scalar, binding = BINDING_COUNTERS) restrict buffer CounterBuffer { Counters counters; };

/// Position in a tile of the invocation: neighbours in a subgroup form compact blocks (4x2 of 8, 8x4 of 32), because
/// rays of neighbouring pixels take similar ways.
uvec2 position_in_tile(uint invocation) {
    return uvec2((invocation & 3u) | ((invocation >> 1) & 4u), ((invocation >> 2) & 1u) | ((invocation >> 3) & 6u));
}

/// Pixel of this invocation within the band.
uvec2 pixel_in_band() {
    uint tiles_per_row = (push.width + TILE_SIZE - 1u) / TILE_SIZE;
    uint tile = push.first_tile + gl_WorkGroupID.x;
    return uvec2(tile % tiles_per_row, tile / tiles_per_row) * TILE_SIZE + position_in_tile(gl_LocalInvocationID.x);
}

vec3 camera_direction(vec2 pixels) {
    vec2 p = picture_position(pixels, uvec2(push.width, push.height));
    return PROJECTION == PROJECTION_SPHERE_MAP ? sphere_map_direction(push.camera, p)
                                               : perspective_direction(push.camera, p);
}

void count(Counters totals) {
    atomicAdd(counters.rays, totals.rays);
    if (totals.nonfinite > 0u) atomicAdd(counters.nonfinite, totals.nonfinite);
    if (totals.lookups > 0u) atomicAdd(counters.lookups, totals.lookups);
    if (totals.traced > 0u) atomicAdd(counters.traced, totals.traced);
    if (totals.truncated > 0u) atomicAdd(counters.truncated, totals.truncated);
    if (totals.incomplete > 0u) atomicAdd(counters.incomplete, totals.incomplete);
}
