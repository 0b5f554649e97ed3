// SPDX-License-Identifier: Apache-2.0
// What users of the library hand in, checked before anything is made from it: each function returns what it
// is given, or throws UsageError with the value that is out of its range, and the range.
#pragma once

#include "renderers/light/light_settings.h"

#include "scene/camera.h"

#include "session/picture.h"

#include <cstdint>

namespace utsuri {

const LightSettings& checked(const LightSettings& light);
const Camera& checked(const Camera& camera);
const PictureSettings& checked(const PictureSettings& settings);

/// Edges of a picture, pixels: each in [1, kLargestPictureEdge].
/// @throws UsageError if one is not
void check_picture_size(std::uint32_t width, std::uint32_t height);

}  // namespace utsuri
