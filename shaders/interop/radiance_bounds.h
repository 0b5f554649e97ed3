// SPDX-License-Identifier: Apache-2.0
// Radiance that arrives at the capture point of each reflector, bounded over the blocks that its distances
// are bounded over: see interop/distance_map.h, whose numbers of bounds and push constants these share.
#ifndef UTSURI_INTEROP_RADIANCE_BOUNDS_H
#define UTSURI_INTEROP_RADIANCE_BOUNDS_H
#include "interop/prelude.h"
INTEROP_BEGIN

/// What rays from the capture point meet, in cd/m2 per linear Rec.709 channel. What depends on from where it
/// is seen is left out: distances tell where that is met.
struct RadianceSample {
    vec3 centre;  ///< through the centre of the texel
    vec3 corner;  ///< through its corner of least coordinates
};

INTEROP_END
#endif
