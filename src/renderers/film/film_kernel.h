// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/film/device_counters.h"
#include "renderers/film/film.h"
#include "renderers/film/frame_counts.h"

#include "base/progress.h"
#include "gpu/dispatch_budget.h"
#include "gpu/kernel.h"

#include <cstdint>
#include <span>

namespace utsuri {

/// What one call of FilmKernel::add_samples() renders.
struct FrameSettings {
    interop::CameraInfo camera;
    std::uint32_t seed = 0;
    std::uint32_t max_depth = 8;
    std::uint32_t excluded_instance = interop::NONE;
};

/// A kernel that adds samples to a film. Its work is cut into dispatches that adapt to a time budget; how it
/// is cut never changes the picture.
class FilmKernel {
  public:
    FilmKernel(Device& device, const std::string& name, std::span<const std::uint32_t> spirv,
               const Specialization& specialization, Bindings bindings);
    FilmKernel(const FilmKernel&) = delete;
    FilmKernel& operator=(const FilmKernel&) = delete;

    /// Compiles the pipeline for real (drivers put that off until the first dispatch), without adding
    /// samples.
    /// @return seconds on the host
    double warm_up(Film& film);

    /// Adds samples number film.samples() to film.samples() + count - 1 to every pixel. Stops early, at a
    /// whole number of samples, if progress says so.
    /// @param progress told about this call's samples; `begin` is left to the caller
    /// @return totals of this call
    FrameCounts add_samples(Film& film, const FrameSettings& settings, std::uint32_t count,
                            Progress& progress);

  private:
    void add_band(const Film& film, const Film::Band& band, const BindingSet& bindings,
                  interop::FramePush push, FrameCounts& counts);

    Device* device_;
    Kernel kernel_;
    Bindings bindings_;
    DeviceCounters counters_;
    DispatchBudget budget_;
};

/// Tiles of a band.
std::uint32_t tile_count(std::uint32_t width, std::uint32_t rows);

}  // namespace utsuri
