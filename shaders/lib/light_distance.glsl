// SPDX-License-Identifier: Apache-2.0
// From how far away light comes, in the mean.
#ifndef UTSURI_LIB_LIGHT_DISTANCE
#define UTSURI_LIB_LIGHT_DISTANCE

#include "lib/numeric.glsl"

struct LightDistance {
    float inverse;  ///< mean of one over metres; 0 without light
    float light;    ///< that it is the mean of, its brightest channel
};

/// Means instead of sums, as a product of radiance and inverse distance may be too large for a float.
void add_light(inout LightDistance distance, vec3 light, float inverse) {
    float brightest = max_component(light);
    if (!(brightest > 0.0)) return;
    distance.light += brightest;
    distance.inverse += brightest / distance.light * (inverse - distance.inverse);
}

#endif
