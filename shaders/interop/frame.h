// SPDX-License-Identifier: Apache-2.0
// What a kernel is told per dispatch, and what it writes per pixel.
#ifndef UTSURI_INTEROP_FRAME_H
#define UTSURI_INTEROP_FRAME_H
#include "interop/prelude.h"
INTEROP_BEGIN

INTEROP_CONSTANT PROJECTION_PERSPECTIVE = 0u;
/// The fisheye of the OpenGL sphere map: the disc of radius 1/2 holds all directions about `forward`
/// reversed.
INTEROP_CONSTANT PROJECTION_SPHERE_MAP = 1u;

/// Picture position (x, y) in [-1, 1]^2, y upwards, maps to the direction forward + x right + y up
/// (perspective).
struct CameraInfo {
    vec3 origin;
    vec3 right;
    vec3 up;
    vec3 forward;
};

/// Push constants of the kernels that render into a film. At most 128 bytes (the least that Vulkan
/// guarantees).
struct FramePush {
    CameraInfo camera;
    uint width;  ///< of the whole picture
    uint height;
    uint first_row;  ///< of the band that the film buffer holds
    uint rows;
    uint first_tile;    ///< of this dispatch, within the band
    uint sample_begin;  ///< samples of this dispatch: [begin, end)
    uint sample_end;
    uint seed;
    uint max_depth;          ///< most specular reflections followed
    uint excluded_instance;  ///< invisible instance, or NONE
};

/// A compensated sum (Kahan 1965).
struct FilmSum {
    vec3 sum;
    vec3 compensation;
};

/// The samples of a pixel. Even and odd ones are two independent estimates of it, whose difference tells the
/// noise.
struct FilmPixel {
    FilmSum halves[2];
};

/// What an invocation counts, and sums of that over dispatches: kernels/film/counters.glsl.
struct Counters {
    uint rays;        ///< closest-hit and any-hit queries
    uint nonfinite;   ///< samples that were not finite and were left out
    uint lookups;     ///< specular directions resolved
    uint traced;      ///< of those, by following a ray
    uint truncated;   ///< specular chains cut at max_depth
    uint incomplete;  ///< invocations whose loop over the samples the driver ended early
};

/// The first hit through the centre of a pixel.
struct AovPixel {
    float depth;            ///< metres along the viewing direction; infinity where nothing is hit
    vec3 position;          ///< metres, relative to the scene's origin
    vec3 geometric_normal;  ///< unit, towards the viewer
    vec3 shading_normal;
    vec3 albedo;
    vec2 texcoord;
    uint triangle;  ///< device order, or NONE
    uint instance;
    uint material;
    uint mirror;  ///< 1 where the surface is a perfect mirror or smooth dielectric
};

/// Pixels are worked on in square tiles of this edge; a tile is a workgroup (WORKGROUP_SIZE).
INTEROP_CONSTANT TILE_SIZE = 8u;

INTEROP_END
#endif
