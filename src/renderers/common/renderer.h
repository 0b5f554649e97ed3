// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/common/film_kernel.h"

#include "base/progress.h"
#include "scene/camera.h"

#include <cstdint>
#include <string>

namespace utsuri {

/// What every method is told.
struct RenderSettings {
    std::uint32_t width = 512;
    std::uint32_t height = 384;
    std::uint32_t seed = 0;
    std::uint32_t specular_depth = 8;  ///< most specular reflections followed
};

/// What a picture took so far.
struct RenderStatistics {
    double prepare_seconds = 0.0;  ///< maps and the like, pipelines excluded
    double compile_seconds = 0.0;  ///< pipelines
    double frame_seconds = 0.0;    ///< wall time of the samples
    FrameCounts counts;            ///< of the samples, preparation excluded
    FrameCounts prepare_counts;
};

/// A point on the two axes light and reflection, which renders one view of one scene sample by sample.
class Renderer {
  public:
    Renderer() = default;
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;
    virtual ~Renderer() = default;

    /// Captures maps, compiles pipelines: all that is done once before the first sample.
    /// @throws Interrupted if progress says so
    virtual void prepare(Progress& progress) = 0;
    /// Moves the eye; what was prepared stays.
    virtual void look_from(const Camera& camera) = 0;
    /// Adds `count` samples to each pixel of the film, or fewer if progress says so. The same picture results
    /// from any split of the samples over calls. prepare() comes first.
    void add_samples(Film& film, std::uint32_t count, Progress& progress);

    [[nodiscard]] const RenderStatistics& statistics() const { return statistics_; }

  protected:
    virtual FrameCounts render(Film& film, std::uint32_t count, Progress& progress) = 0;

    RenderStatistics statistics_;
};

/// Adds b to a.
void accumulate(FrameCounts& a, const FrameCounts& b);

}  // namespace utsuri
