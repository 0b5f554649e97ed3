// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/image.h"
#include "image/plane.h"

#include <glm/vec3.hpp>

namespace utsuri {

/// Ends of the one scale of displacements, in pixels. Less than a tenth of a pixel is not seen; more than a
/// hundred is somewhere else.
inline constexpr float kLeastDisplacement = 0.1f;
inline constexpr float kMostDisplacement = 100.0f;

/// Colours of ReflectionErrors::traced, display coded; where no mirror is seen: kLeftOutColour.
[[nodiscard]] glm::vec3 looked_up_colour();
[[nodiscard]] glm::vec3 traced_colour();

/// Displacements in colour, display coded; pixels without a mirror are kLeftOutColour.
[[nodiscard]] Image displacement_picture(const Plane& displacements);

/// Which pixels were traced, display coded.
[[nodiscard]] Image traced_picture(const Plane& traced);

}  // namespace utsuri
