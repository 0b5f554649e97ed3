// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image_io/image_io.h"

#include "session/session.h"

#include <string>
#include <vector>

namespace utsuri {

/// Names of the channels a user asked for.
using AovSelection = std::vector<std::string>;

/// All names of first-hit data, and those of data of reflections, separated by commas, for help texts.
std::string aov_names();

/// @throws UsageError that lists the names there are
AovSelection parse_aovs(const std::string& text);

/// First-hit data taken apart into channels, as OpenEXR stores them.
struct AovPlanes {
    struct Plane {
        std::vector<std::string> names;
        std::vector<float> values;  ///< interleaved
    };
    std::vector<Plane> planes;

    /// Views of the planes; valid as long as they are.
    [[nodiscard]] std::vector<ExrChannels> channels() const;
};

/// Whether errors of reflections are among what a user asked for: MapSettings::predicts_errors.
bool wants_reflection_errors(const AovSelection& selection);

/// Whether how reflections were found is among it: Picture::traced_pixels().
bool wants_traced_pixels(const AovSelection& selection);

/// Adds both; values are -1 where no mirror is seen.
void add_reflection_data(AovPlanes& planes, Picture& picture, const AovSelection& selection);

/// Positions are in world space, triangle numbers those of the scene; pixels that hit nothing have depth
/// infinity and numbers -1.
AovPlanes extract_aovs(const std::vector<interop::AovPixel>& pixels, const AovSelection& selection,
                       const SceneData& scene);

}  // namespace utsuri
