// SPDX-License-Identifier: Apache-2.0
// What a kernel is told of distance maps before it is compiled.
#ifndef UTSURI_LIB_DISTANCE_CONSTANTS
#define UTSURI_LIB_DISTANCE_CONSTANTS

#include "interop/distance_map.h"
#include "interop/specialization.h"

layout(constant_id = SPEC_DISTANCE_SIZE) const uint DISTANCE_SIZE = 256u;
/// Texels along an edge of a face with its border.
const uint DISTANCE_STRIDE = DISTANCE_SIZE + 2u * DISTANCE_BORDER;

#endif
