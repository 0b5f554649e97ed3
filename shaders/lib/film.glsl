// SPDX-License-Identifier: Apache-2.0
#ifndef UTSURI_LIB_FILM
#define UTSURI_LIB_FILM

#include "interop/frame.h"

/// Kahan's compensated sum (1965): the error does not grow with the number of samples. Must not be reassociated.
void add_compensated(inout vec3 sum, inout vec3 compensation, vec3 value) {
    precise vec3 corrected = value - compensation;
    precise vec3 total = sum + corrected;
    precise vec3 lost = (total - sum) - corrected;
    compensation = lost;
    sum = total;
}

void add_sample(inout FilmPixel pixel, uint sample_index, vec3 radiance) {
    if ((sample_index & 1u) == 0u) {
        add_compensated(pixel.halves[0].sum, pixel.halves[0].compensation, radiance);
    } else {
        add_compensated(pixel.halves[1].sum, pixel.halves[1].compensation, radiance);
    }
}

#endif
