// SPDX-License-Identifier: Apache-2.0
// Drawing the scene with the raster pipeline, one sample per pixel a time.
#ifndef UTSURI_INTEROP_RASTER_H
#define UTSURI_INTEROP_RASTER_H
#include "interop/frame.h"
INTEROP_BEGIN

struct RasterPush {
    CameraInfo camera;
    vec2 jitter;       ///< where in its pixel a sample lies, in [0, 1)^2
    float near_plane;  ///< distance along the viewing direction
    uint sample_index;
    uint seed;
    vec2 pixel;              ///< size of a pixel, in pictures
    uint specular_depth;     ///< most specular reflections followed
    uint excluded_instance;  ///< NONE
    float tolerance;         ///< predicted displacement up to which maps are looked up, in pixels
};

/// The fourth channel of a drawn picture tells how a pixel's reflection was found. Above DRAWN_LOOKED_UP: by
/// that many rays more.
INTEROP_FLOAT_CONSTANT DRAWN_PLAIN = 0.0f;      ///< there is none
INTEROP_FLOAT_CONSTANT DRAWN_LOOKED_UP = 1.0f;  ///< in a map

struct AddDrawnPush {
    uint pixels;
    uint sample_index;
};

INTEROP_END
#endif
