// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/scene_change.h"
#include "renderers/film/film.h"
#include "renderers/film/render_settings.h"
#include "renderers/film/render_statistics.h"
#include "renderers/light/surface_light.h"
#include "renderers/reflection/raster/reflection_error.h"

#include "base/progress.h"
#include "scene/camera.h"

#include <cstdint>
#include <string>
#include <vector>

namespace utsuri {

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
    /// Takes over a change of the scene, after update_scene_data() and GpuScene::update(): makes anew what
    /// was prepared and the change touches. Pictures are then those of a renderer made for the scene as it
    /// is. statistics() start anew with what that took. prepare() comes first; every renderer is told of
    /// every change.
    /// @throws Interrupted if progress says so; after this and any other exception the renderer must not be
    /// used
    virtual void update(const SceneChange& change, Progress& progress) = 0;
    /// Moves the eye; what was prepared stays.
    virtual void set_camera(const Camera& camera) = 0;
    /// Adds `count` samples to each pixel of the film, or fewer if progress says so. The same picture results
    /// from any split of the samples over calls. prepare() comes first.
    void add_samples(Film& film, std::uint32_t count, Progress& progress);

    /// Draws the present view, a sample at the centre of each pixel, without a film: what a window would
    /// show, and what it costs to move the eye.
    /// @returns whether the method draws; others can only add samples to a film
    virtual bool draw_frame() { return false; }

    /// Errors of what the method shows instead of traced reflections, at the pixel centres of the present
    /// view, row-major, top row first; empty for methods that tell none. prepare() comes first.
    [[nodiscard]] virtual std::vector<PredictedError> predict_errors() { return {}; }
    [[nodiscard]] virtual std::vector<MeasuredError> measure_errors() { return {}; }
    /// Whether a ray was followed for the reflection at each pixel's centre, 1, or a map looked up, 0; -1
    /// where no mirror is seen. Order as above; empty for methods that do the same everywhere.
    [[nodiscard]] virtual std::vector<float> traced_pixels() { return {}; }

    [[nodiscard]] const RenderStatistics& statistics() const { return statistics_; }

  protected:
    /// Of the maps only, until something adds to the rest.
    void restart_statistics();
    /// As if the light had been simulated for this renderer alone.
    void count_light(const LightCost& cost);
    virtual FrameCounts render(Film& film, std::uint32_t count, Progress& progress) = 0;

    RenderStatistics statistics_;
};

}  // namespace utsuri
