// SPDX-License-Identifier: Apache-2.0
// How far a pixel of a drawn picture with plane mirrors is, as its fourth channel keeps it below zero: the number of
// reflections that it shows, and a half where they were cut short; or the number of the image that it waits for, which is
// IMAGE_OF_EYE or more. Without a plane mirror the channel is as elsewhere: see DRAWN_PLAIN.
#ifndef UTSURI_LIB_IMAGE_STATE
#define UTSURI_LIB_IMAGE_STATE

#include "interop/raster.h"

float complete_after(uint reflections) {
    return -float(reflections);
}

float truncated_at(uint reflections) {
    return -float(reflections) - 0.5;
}

float waiting_for(uint number) {
    return -float(number);
}

uint reflections_of(float state) {
    return state < 0.0 && state > -float(IMAGE_OF_EYE) ? uint(-state) : 0u;
}

bool is_truncated(float state) {
    return state < 0.0 && fract(state) != 0.0;
}

#endif
