// SPDX-License-Identifier: Apache-2.0
// Totals of a dispatch.
#ifndef UTSURI_KERNELS_FILM_COUNTERS
#define UTSURI_KERNELS_FILM_COUNTERS

#extension GL_EXT_scalar_block_layout : require

#include "interop/bindings.h"
#include "interop/frame.h"

layout(scalar, set = METHOD_SET, binding = BINDING_COUNTERS) restrict buffer CounterBuffer { Counters counters; };

void count(Counters totals) {
    if (totals.rays > 0u) atomicAdd(counters.rays, totals.rays);
    if (totals.nonfinite > 0u) atomicAdd(counters.nonfinite, totals.nonfinite);
    if (totals.lookups > 0u) atomicAdd(counters.lookups, totals.lookups);
    if (totals.traced > 0u) atomicAdd(counters.traced, totals.traced);
    if (totals.truncated > 0u) atomicAdd(counters.truncated, totals.truncated);
    if (totals.incomplete > 0u) atomicAdd(counters.incomplete, totals.incomplete);
}

#endif
