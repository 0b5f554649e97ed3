// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/film/film.h"
#include "renderers/film/render_settings.h"
#include "renderers/film/render_statistics.h"
#include "renderers/methods/method.h"
#include "renderers/methods/reflection.h"
#include "renderers/methods/renderer.h"

#include "base/progress.h"
#include "image/image.h"
#include "scene/camera.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace utsuri {

struct SessionState;
struct PictureState;

/// What a picture is made with. Ranges are those of the members' own headers.
struct PictureSettings {
    Method method;
    Camera camera;
    RenderSettings render;
    MapSettings maps;               ///< of methods that look reflections up
    std::string title = "picture";  ///< shown in messages
};

/// A view of a session's scene by one method, rendered sample by sample. It follows the scene: after
/// Session::set_scene() it holds no samples, and the next ones are of the scene as it is. It keeps alive what
/// it needs of its session. Move-only; one that was moved from may only be assigned to or destroyed.
///
/// Calls that need light, maps or pipelines make them first, where they are not there. They throw DeviceError
/// if that does not fit or the device fails, and UsageError if the session has no scene any more or the scene
/// has become one that the settings do not fit. After these errors and Interrupted the picture has no
/// samples; what it lacks is made when it is next needed.
class Picture {
  public:
    Picture(Picture&& other) noexcept;
    Picture& operator=(Picture&& other) noexcept;
    ~Picture();

    /// All that is done once before the first sample: light, maps, pipelines. Nothing if it is there.
    /// @throws Interrupted if progress says so
    void prepare(Progress& progress);
    /// Adds `count` samples to each pixel, or fewer if progress says so. Prepares first, if prepare() did
    /// not, which progress may stop but is not told of.
    /// @throws Interrupted if cancelled before the first sample, while it prepares
    void add_samples(std::uint32_t count, Progress& progress);
    void add_samples(std::uint32_t count);
    /// Moves the eye: forgets the samples; what was prepared stays.
    /// @param camera any that keeps what scene/camera.h promises, of the scene's or not
    /// @throws UsageError if it does not; the picture stays as it was
    void set_camera(const Camera& camera);
    /// Forgets the samples.
    void clear();

    /// Of each pixel.
    [[nodiscard]] std::uint32_t samples() const;
    /// Mean over the samples, cd/m2 per linear Rec.709 channel; black without any.
    [[nodiscard]] Image image() const;
    /// Mean over every other sample, as above: the even ones (0) or the odd ones (1), which are independent.
    /// @throws UsageError if `half` is neither
    [[nodiscard]] Image half_image(std::uint32_t half) const;
    /// @throws UsageError unless the number of samples is even and at least 2
    [[nodiscard]] NoiseEstimate noise() const;
    /// Since the picture was made, or since the scene last changed. Valid until the next call that is not
    /// const, of the picture or its session.
    [[nodiscard]] const RenderStatistics& statistics() const;

    /// Draws the view without adding a sample, as a window would. See Renderer, also for the three below.
    /// @returns false for methods that do not draw
    bool draw_frame();
    /// @throws UsageError of methods whose maps have no distances, without MapSettings::predicts_errors
    [[nodiscard]] std::vector<PredictedError> predict_errors();
    /// @throws UsageError as above
    [[nodiscard]] std::vector<MeasuredError> measure_errors();
    [[nodiscard]] std::vector<float> traced_pixels();

  private:
    friend class Session;
    Picture(std::shared_ptr<SessionState> session, const PictureSettings& settings);
    /// The renderer, made and prepared.
    Renderer& renderer();

    std::shared_ptr<SessionState> session_;
    std::shared_ptr<PictureState> state_;
};

}  // namespace utsuri
