// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/image.h"
#include "image/plane.h"

#include <glm/vec3.hpp>

namespace utsuri {

/// The colour of an error of `fraction` (clamped to [0, 1]) of the scale: black, violet, red, orange, pale
/// yellow. CIE L* rises linearly from 0 to 97, so that equal steps of error are equal steps of lightness, in
/// grey print too. The hues are control points in CIELAB of our own, chosen to stay inside the sRGB gamut.
/// Display coded.
[[nodiscard]] glm::vec3 error_colour(float fraction);

/// Each value over `maximum` (> 0) as error_colour. Not-a-number is shown pure green, a colour that the scale
/// does not have. The result is display coded, ready to be written as a PNG without exposure or sRGB coding.
[[nodiscard]] Image error_map(const Plane& errors, float maximum = 1.0f);

/// The colour of pixels that a map leaves out, display coded: a dark grey. All of the scale but its ends has
/// a hue.
inline constexpr glm::vec3 kLeftOutColour{0.22f};

/// Each value as error_colour on a logarithmic scale: up to `least` (> 0) black, from `most` (> least) the
/// lightest. Negative values are left out; not-a-number as above. Display coded.
[[nodiscard]] Image log_error_map(const Plane& errors, float least, float most);

/// Per pixel the mean over the channels of |d| / (|reference| + epsilon) with both pictures normalised as by
/// MetricSettings, so that its mean over the frame is Metrics::mape. Not-a-number where either is not finite.
/// @throws InputError if the sizes differ.
[[nodiscard]] Plane relative_error(const Image& reference, const Image& test, double epsilon = 0.01);

}  // namespace utsuri
