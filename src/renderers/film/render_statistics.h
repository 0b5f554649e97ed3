// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/film/frame_counts.h"

namespace utsuri {

/// What a picture took so far.
struct RenderStatistics {
    double prepare_seconds = 0.0;  ///< light kept on surfaces, maps and the like, pipelines excluded
    double compile_seconds = 0.0;  ///< pipelines
    double frame_seconds = 0.0;    ///< wall time of the samples
    FrameCounts counts;            ///< of the samples, preparation excluded
    FrameCounts prepare_counts;
    std::uint32_t maps = 0;            ///< of reflections, captured or not
    std::uint32_t captured_maps = 0;   ///< of those, looked up by some pixel
    std::uint32_t least_map_size = 0;  ///< texels along an edge
    std::uint32_t largest_map_size = 0;
};

}  // namespace utsuri
