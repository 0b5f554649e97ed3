// SPDX-License-Identifier: Apache-2.0
// Russian roulette (Arvo and Kirk 1990): what brings little is followed by chance, in proportion to what it brings, and
// counts for more in return.
#ifndef UTSURI_LIB_ROULETTE
#define UTSURI_LIB_ROULETTE

#include "lib/numeric.glsl"

/// The chance to go on.
/// @param throughput share of the light met that arrives
/// @param least what goes on brings this share at least, once it is divided by the chance
float survival(vec3 throughput, float least) {
    return min(1.0, max_component(throughput) / least);
}

#endif
