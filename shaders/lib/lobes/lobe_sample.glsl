// SPDX-License-Identifier: Apache-2.0
// A direction that a lobe was sampled in. Directions wo and wi leave the surface.
#ifndef UTSURI_LIB_LOBES_LOBE_SAMPLE
#define UTSURI_LIB_LOBES_LOBE_SAMPLE

struct LobeSample {
    vec3 direction;
    vec3 throughput;  ///< value times cosine over density; zero where the direction lies below the surface
    float pdf;        ///< over solid angle; 0 for a mirror, whose direction is the only one, and below the surface
};

#endif
