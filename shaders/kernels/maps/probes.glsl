// SPDX-License-Identifier: Apache-2.0
// The capture points of reflectors, and which of them a look-up takes.
#ifndef UTSURI_KERNELS_MAPS_PROBES
#define UTSURI_KERNELS_MAPS_PROBES

#extension GL_EXT_scalar_block_layout : require

#include "interop/bindings.h"
#include "lib/map_constants.glsl"
#include "lib/numeric.glsl"

layout(scalar, set = METHOD_SET, binding = BINDING_PROBES) readonly restrict buffer Probes { ProbeInfo probes[]; };
layout(scalar, set = METHOD_SET, binding = BINDING_PROBE_RANGES) readonly restrict buffer ProbeRanges { ProbeRange probe_ranges[]; };

/// The probe that a reflected ray passes nearest, the first of equals: its parallax is least, however far the ray goes.
/// @param direction of any length
uint nearest_probe(uint reflector, vec3 position, vec3 direction) {
    if (MOST_PROBES == 1u) return reflector;
    ProbeRange range = probe_ranges[reflector];
    vec3 unit = normalize_any_scale(direction);
    uint nearest = range.first;
    float least = INFINITY;
    for (uint i = range.first; i < range.first + range.count; ++i) {
        vec3 across = cross(position - probes[i].capture_point, unit);
        float distance2 = dot(across, across);
        if (distance2 >= least) continue;
        least = distance2;
        nearest = i;
    }
    return nearest;
}

#endif
