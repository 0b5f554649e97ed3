// SPDX-License-Identifier: Apache-2.0
// Totals of dispatches. A render can pass 2^32 of most of what is counted, so that carries are counted, too.
#ifndef UTSURI_KERNELS_FILM_COUNTERS
#define UTSURI_KERNELS_FILM_COUNTERS

#extension GL_EXT_scalar_block_layout : require

#include "interop/bindings.h"
#include "interop/frame.h"

layout(scalar, set = METHOD_SET, binding = BINDING_COUNTERS) restrict buffer CounterBuffer {
    Counters counters;  ///< modulo 2^32
    Counters carries;   ///< how often each passed 2^32
};

/// Whether a counter passed 2^32 as it was added to.
/// @param before what it was
bool passed(uint before, uint added) {
    return before + added < before;
}

void count(Counters totals) {
    if (totals.rays > 0u && passed(atomicAdd(counters.rays, totals.rays), totals.rays)) {
        atomicAdd(carries.rays, 1u);
    }
    if (totals.nonfinite > 0u && passed(atomicAdd(counters.nonfinite, totals.nonfinite), totals.nonfinite)) {
        atomicAdd(carries.nonfinite, 1u);
    }
    if (totals.lookups > 0u && passed(atomicAdd(counters.lookups, totals.lookups), totals.lookups)) {
        atomicAdd(carries.lookups, 1u);
    }
    if (totals.traced > 0u && passed(atomicAdd(counters.traced, totals.traced), totals.traced)) {
        atomicAdd(carries.traced, 1u);
    }
    if (totals.truncated > 0u && passed(atomicAdd(counters.truncated, totals.truncated), totals.truncated)) {
        atomicAdd(carries.truncated, 1u);
    }
    if (totals.incomplete > 0u && passed(atomicAdd(counters.incomplete, totals.incomplete), totals.incomplete)) {
        atomicAdd(carries.incomplete, 1u);
    }
}

#endif
