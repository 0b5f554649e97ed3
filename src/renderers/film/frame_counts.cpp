// SPDX-License-Identifier: Apache-2.0
#include "renderers/film/frame_counts.h"

namespace utsuri {

void accumulate(FrameCounts& a, const FrameCounts& b) {
    a.rays += b.rays;
    a.nonfinite += b.nonfinite;
    a.lookups += b.lookups;
    a.traced += b.traced;
    a.truncated += b.truncated;
    a.gpu_seconds += b.gpu_seconds;
}

}  // namespace utsuri
