// SPDX-License-Identifier: Apache-2.0
// What kernels that render into a film share: push constants, film, and which pixel an invocation works on.
#ifndef UTSURI_KERNELS_FILM_FILM_BINDINGS
#define UTSURI_KERNELS_FILM_FILM_BINDINGS
#extension GL_EXT_scalar_block_layout : require

#include "interop/bindings.h"
#include "interop/frame.h"
#include "interop/specialization.h"
#include "lib/camera.glsl"
#include "lib/film.glsl"
#include "lib/tile.glsl"

layout(local_size_x = TILE_SIZE * TILE_SIZE) in;

layout(constant_id = SPEC_PROJECTION) const uint PROJECTION = PROJECTION_PERSPECTIVE;

layout(push_constant, scalar) uniform Push { FramePush push; };

layout(scalar, set = METHOD_SET, binding = BINDING_FILM) restrict buffer Film { FilmPixel film[]; };

/// Pixel of this invocation within the band.
uvec2 pixel_in_band() {
    return pixel_in_tiles(push.first_tile + gl_WorkGroupID.x, push.width, gl_LocalInvocationID.x);
}

vec3 camera_direction(vec2 pixels) {
    vec2 p = picture_position(pixels, uvec2(push.width, push.height));
    return PROJECTION == PROJECTION_SPHERE_MAP ? sphere_map_direction(push.camera, p)
                                               : perspective_direction(push.camera, p);
}

#endif
