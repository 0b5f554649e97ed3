// SPDX-License-Identifier: Apache-2.0
// Drawing the scene with the raster pipeline, one sample per pixel a time.
#ifndef UTSURI_INTEROP_RASTER_H
#define UTSURI_INTEROP_RASTER_H
#include "interop/frame.h"
INTEROP_BEGIN

/// What is the same for all draws of a frame: a uniform block.
struct FrameInfo {
    vec2 jitter;       ///< where in its pixel a sample lies, in [0, 1)^2
    vec2 pixel_size;   ///< in pictures
    uint width;        ///< of the picture
    float near_plane;  ///< distance along the viewing direction
    uint sample_index;
    uint seed;
    uint max_depth;   ///< most specular reflections followed
    float tolerance;  ///< predicted error up to which maps are looked up: pixels, or share of the radiance
};

/// The fourth channel of a drawn picture tells how a pixel's reflection was found: see lib/pixel_state.glsl.
INTEROP_FLOAT_CONSTANT DRAWN_PLAIN = 0.0f;      ///< there is none
INTEROP_FLOAT_CONSTANT DRAWN_LOOKED_UP = 1.0f;  ///< in a map
INTEROP_FLOAT_CONSTANT DRAWN_RAY = 1024.0f;     ///< or more: by so many rays times this
/// Counted for a pixel, at most: quarters stay exact in float32.
INTEROP_CONSTANT DRAWN_MOST_RAYS = 4095u;

/// Number of the view that the eye has directly; mirrored views follow.
INTEROP_CONSTANT VIEW_OF_EYE = 1024u;
/// In place of a number: a mirror without a view.
INTEROP_CONSTANT VIEW_TRUNCATED = 0u;

/// Push constants of what draws one view of the scene: from the eye, or from the eye mirrored in one mirror
/// after the other. At most 128 bytes (the least that Vulkan guarantees).
struct ViewPush {
    CameraInfo camera;
    vec3 normal;  ///< only what is at dot(normal, x) > offset shows in the last mirror
    float offset;
    uint number;       ///< of this view: only pixels that wait for it are drawn
    uint reflections;  ///< mirrors that it is seen in
    uint next;         ///< number of the view in the mirror that is drawn, or VIEW_TRUNCATED
};

/// A reflection that a drawn pixel leaves to rays: a texel of a second attachment.
struct DeferredReflection {
    uint triangle;  ///< that reflects
    float b1;       ///< barycentric coordinates on it
    float b2;
    uint request;  ///< a DEFERRED_ kind, the chance to be here, the number of the DeferredView
};

INTEROP_CONSTANT DEFERRED_KIND = 3u;  ///< the bits of:
INTEROP_CONSTANT DEFERRED_NONE = 0u;
INTEROP_CONSTANT DEFERRED_LOBE = 1u;          ///< a glossy lobe
INTEROP_CONSTANT DEFERRED_MIRROR = 2u;        ///< a curved mirror
INTEROP_CONSTANT DEFERRED_PLANE_MIRROR = 3u;  ///< a plane mirror whose view is not drawn
/// A chance is stored as a number of this many parts of 1, less one, from a bit on.
INTEROP_CONSTANT DEFERRED_CHANCES = 65536u;
INTEROP_CONSTANT DEFERRED_CHANCE_SHIFT = 2u;
INTEROP_CONSTANT DEFERRED_VIEW_SHIFT = 18u;
INTEROP_CONSTANT DEFERRED_MOST_VIEWS = 4096u;  ///< what one update of a buffer can hold

/// A view of a frame, the eye's first: where its eye is, and the mirrors that it is seen in.
struct DeferredView {
    vec3 eye;
    uint reflections;
};

/// Pixels of a band with deferred reflections, and the dispatch that follows them: VkDispatchIndirectCommand.
struct DeferredCount {
    uint groups_x;
    uint groups_y;
    uint groups_z;
    uint pixels;
};

struct DeferredPush {
    uint first_row;  ///< of the band that the buffers hold
    uint rows;
    uint first_tile;  ///< of this dispatch, in the band
};

struct AddDrawnPush {
    uint pixels;
    uint sample_index;
};

INTEROP_END
#endif
