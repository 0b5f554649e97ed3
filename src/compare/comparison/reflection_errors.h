// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/progress.h"
#include "image/plane.h"

#include "session/session.h"

#include <cstdint>
#include <string>

namespace utsuri {

/// By how many pixels the reflections that a method shows are off their places, at the pixel centres of a
/// view; -1 where no mirror is seen. A traced reflection is off by nothing.
struct ReflectionErrors {
    Plane predicted;       ///< at most; infinity where nothing is known
    Plane measured;        ///< told by rays
    Plane traced;          ///< Renderer::traced_pixels(); empty for methods that do the same everywhere
    double seconds = 0.0;  ///< wall time of finding them, no part of what the method takes
    // Names of the .png in the output folder; the last is empty as its plane is.
    std::string predicted_file;
    std::string measured_file;
    std::string traced_file;
};

/// Of displacements in pixels; 0 where no mirror is seen.
struct DisplacementSummary {
    double median = 0.0;
    double p95 = 0.0;  ///< 95 of 100 pixels are off by no more
};

struct ReflectionErrorSummary {
    std::uint64_t pixels = 0;  ///< that show a mirror
    std::uint64_t traced = 0;  ///< of those
    DisplacementSummary predicted;
    DisplacementSummary measured;
    double exceeded = 0.0;  ///< share of the pixels that are off by more than predicted
};

/// Tells them with a picture of its own, since most methods keep no distances, which predictions take.
/// @param settings of a method with ReflectionTraits::predicts_errors
/// @throws UsageError if the distance maps cannot fit into one buffer of the device
ReflectionErrors find_reflection_errors(Session& session, PictureSettings settings, Progress& progress);

ReflectionErrorSummary summarise(const ReflectionErrors& errors);

}  // namespace utsuri
