// SPDX-License-Identifier: Apache-2.0
#include "renderers/common/renderer.h"

#include <chrono>

namespace utsuri {

void accumulate(FrameCounts& a, const FrameCounts& b) {
    a.rays += b.rays;
    a.nonfinite += b.nonfinite;
    a.lookups += b.lookups;
    a.traced += b.traced;
    a.truncated += b.truncated;
    a.gpu_seconds += b.gpu_seconds;
}

void Renderer::restart_statistics() {
    RenderStatistics statistics;
    statistics.maps = statistics_.maps;
    statistics.captured_maps = statistics_.captured_maps;
    statistics_ = statistics;
}

void Renderer::add_samples(Film& film, std::uint32_t count, Progress& progress) {
    const auto start = std::chrono::steady_clock::now();
    accumulate(statistics_.counts, render(film, count, progress));
    statistics_.frame_seconds +=
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace utsuri
