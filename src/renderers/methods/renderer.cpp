// SPDX-License-Identifier: Apache-2.0
#include "renderers/methods/renderer.h"

#include "base/stopwatch.h"

namespace utsuri {

void Renderer::restart_statistics() {
    RenderStatistics statistics;
    statistics.maps = statistics_.maps;
    statistics.captured_maps = statistics_.captured_maps;
    statistics_ = statistics;
}

void Renderer::count_light(const LightCost& cost) {
    statistics_.prepare_seconds += cost.seconds;
    statistics_.compile_seconds += cost.compile_seconds;
    accumulate(statistics_.prepare_counts, cost.counts);
}

void Renderer::add_samples(Film& film, std::uint32_t count, Progress& progress) {
    const Stopwatch stopwatch;
    accumulate(statistics_.counts, render(film, count, progress));
    statistics_.frame_seconds += stopwatch.seconds();
}

}  // namespace utsuri
