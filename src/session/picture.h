// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/film/film.h"
#include "renderers/methods/method.h"

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
class Picture {
  public:
    Picture(Picture&& other) noexcept;
    Picture& operator=(Picture&& other) noexcept;
    ~Picture();

    /// All that is done once before the first sample: light, maps, pipelines. Done by the calls below if it
    /// was not done yet, without telling their progress.
    /// @throws Interrupted if progress says so
    void prepare(Progress& progress);
    /// Adds `count` samples to each pixel, or fewer if progress says so.
    void add_samples(std::uint32_t count, Progress& progress);
    void add_samples(std::uint32_t count);
    /// Moves the eye: forgets the samples; what was prepared stays.
    /// @param camera any that keeps what scene/camera.h promises, of the scene's or not
    /// @throws UsageError if it does not; the picture stays as it was
    void set_camera(const Camera& camera);
    /// Forgets the samples.
    void clear();

    [[nodiscard]] std::uint32_t samples() const;
    /// Mean over the samples, cd/m2; black without any.
    [[nodiscard]] Image image() const;
    /// Mean over every other sample, as above: the even ones (0) or the odd ones (1), which are independent.
    /// @throws UsageError if `half` is neither
    [[nodiscard]] Image half_image(std::uint32_t half) const;
    /// @throws UsageError unless the number of samples is even and at least 2
    [[nodiscard]] NoiseEstimate noise() const;
    /// Since the picture was made, or since the scene last changed.
    [[nodiscard]] const RenderStatistics& statistics() const;

    /// See Renderer. Predictions take MapSettings::predicts_errors, where the method keeps no distances.
    bool draw_frame();
    [[nodiscard]] std::vector<PredictedError> predict_errors();
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
