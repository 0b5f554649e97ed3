// SPDX-License-Identifier: Apache-2.0
// What a kernel is told of reflection maps before it is compiled.
#ifndef UTSURI_LIB_MAP_CONSTANTS
#define UTSURI_LIB_MAP_CONSTANTS

#include "interop/reflection.h"
#include "interop/specialization.h"

layout(constant_id = SPEC_MAP_KIND) const uint MAP_KIND = MAP_KIND_POLYGON;
layout(constant_id = SPEC_FACE_COUNT) const uint FACE_COUNT = CUBE_FACES;
layout(constant_id = SPEC_MOST_PROBES) const uint MOST_PROBES = 1u;
layout(constant_id = SPEC_HAS_PROXY_PLANES) const uint HAS_PROXY_PLANES = 0u;

#endif
