// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/comparison/run_comparison.h"
#include "renderers/film/film.h"

namespace utsuri {

/// The picture that methods are held against. It gets more samples as they are asked for.
class Reference {
  public:
    /// Without samples yet.
    Reference(Session& session, const Camera& camera, const ComparisonSettings& settings);

    /// Adds samples up to `wanted`, which is even, or fewer where ComparisonSettings::reference_seconds end
    /// before or progress says so. There is always time for two, by which noise and time of a sample are
    /// told.
    /// @returns whether it added any
    bool grow(std::uint32_t wanted, Progress& progress);
    /// Writes picture, noise and exposure into a comparison.
    /// @throws Interrupted if there are no samples
    void tell(Comparison& comparison) const;

    [[nodiscard]] std::uint32_t samples() const { return picture_.samples(); }
    /// Device memory that it keeps while methods are measured.
    [[nodiscard]] std::uint64_t held_bytes() const {
        return Film::bytes(picture_settings_.render.width, picture_settings_.render.height);
    }

  private:
    /// Of `wanted` samples, those that there is time for.
    [[nodiscard]] std::uint32_t affordable(std::uint32_t wanted) const;

    Session& session_;
    const ComparisonSettings& settings_;
    PictureSettings picture_settings_;
    Picture picture_;
    MemoryUsage memory_;
};

/// How many samples the reference is to have at first: as many as asked for; else enough for an exact method
/// with the samples that methods get.
std::uint32_t first_reference_samples(const ComparisonSettings& settings);

/// How many samples it takes until the mean squared error of the reference is at most kReferenceShare of the
/// least that is reported; as many as it has where it is.
/// @param least_error that is reported, as Metrics::mse; infinite if none is
std::uint32_t needed_reference_samples(const Comparison& comparison, double least_error);

/// Of the least mean squared error that is reported.
inline constexpr double kReferenceShare = 0.1;

/// Methods whose error is so small that the reference's noise is more than kReferenceShare of it.
std::vector<Method> methods_near_noise(const Comparison& comparison);

}  // namespace utsuri
