// SPDX-License-Identifier: Apache-2.0
// How a pixel of a drawn picture found what it shows, as its fourth channel keeps it.
// Below zero, by mirrored views: minus the number of reflections that it shows, and half less where they were cut short; or
// minus the number of the view that it waits for, which is VIEW_OF_EYE or more.
// From DRAWN_LOOKED_UP on, by maps or rays: one more for each reflection by mirrored views before, a half more where the last
// mirror was a plane one, a quarter more where rays were cut short, and DRAWN_RAY more for each ray.
#ifndef UTSURI_LIB_PIXEL_STATE
#define UTSURI_LIB_PIXEL_STATE

#include "interop/raster.h"

float complete_after(uint reflections) {
    return -float(reflections);
}

float truncated_at(uint reflections) {
    return -float(reflections) - 0.5;
}

float found_in_map(uint reflections) {
    return DRAWN_LOOKED_UP + float(reflections);
}

/// @param cut whether the rays' chain ended at the max depth
float found_by_rays(uint reflections, uint rays, bool cut) {
    return found_in_map(reflections) + DRAWN_RAY * float(min(rays, DRAWN_MOST_RAYS)) + (cut ? 0.25 : 0.0);
}

float traced_at_plane_mirror(uint reflections, uint rays, bool cut) {
    return found_by_rays(reflections, rays, cut) + 0.5;
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
    return state < 0.0 ? fract(state) != 0.0 : fract(2.0 * state) != 0.0;
}

#endif
