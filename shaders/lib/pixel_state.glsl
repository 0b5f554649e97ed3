// SPDX-License-Identifier: Apache-2.0
// How a pixel of a drawn picture found what it shows, as its fourth channel keeps it.
// Below zero, by mirrored views: minus the number of reflections that it shows, and half less where they were cut short; or
// minus the number of the view that it waits for, which is VIEW_OF_EYE or more.
// From DRAWN_LOOKED_UP on, by maps or rays: one more for each reflection by mirrored views before, a half more where the last
// mirror was a plane one, and DRAWN_RAY more for each ray.
#ifndef UTSURI_LIB_PIXEL_STATE
#define UTSURI_LIB_PIXEL_STATE

#include "interop/raster.h"

float complete_after(uint reflections) {
    return -float(reflections);
}

float truncated_at(uint reflections) {
    return -float(reflections) - 0.5;
}

float found_by(uint reflections, uint rays) {
    return DRAWN_LOOKED_UP + float(reflections) + DRAWN_RAY * float(min(rays, DRAWN_MOST_RAYS));
}

float traced_at_plane_mirror(uint reflections, uint rays) {
    return found_by(reflections, rays) + 0.5;
}

float waiting_for(uint number) {
    return -float(number);
}

/// Specular directions that were resolved.
uint reflections_of(float state) {
    if (state >= DRAWN_LOOKED_UP) return uint(mod(state, DRAWN_RAY));
    return state < 0.0 && state > -float(VIEW_OF_EYE) ? uint(-state) : 0u;
}

uint rays_of(float state) {
    return state >= DRAWN_LOOKED_UP ? uint(state / DRAWN_RAY) : 0u;
}

bool is_truncated(float state) {
    return state < 0.0 && fract(state) != 0.0;
}

#endif
