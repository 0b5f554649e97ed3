// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/common/aov.h"
#include "renderers/common/scene_data.h"

#include "image_io/image_io.h"

#include <string>
#include <vector>

namespace utsuri {

/// Names of the channels a user asked for.
using AovSelection = std::vector<std::string>;

/// All names, separated by commas, for help texts.
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

/// Positions are in world space, triangle numbers those of the scene; pixels that hit nothing have depth
/// infinity and numbers -1.
AovPlanes extract_aovs(const std::vector<interop::AovPixel>& pixels, const AovSelection& selection,
                       const SceneData& scene);

}  // namespace utsuri
