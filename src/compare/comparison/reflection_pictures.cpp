// SPDX-License-Identifier: Apache-2.0
#include "compare/comparison/reflection_pictures.h"

#include "image/error_map.h"

#include <algorithm>

namespace utsuri {
namespace {

/// Places on the scale of error_colour() that are far apart in hue and lightness, and from kLeftOutColour.
constexpr float kLookedUp = 0.35f;
constexpr float kTraced = 0.85f;

}  // namespace

glm::vec3 looked_up_colour() {
    return error_colour(kLookedUp);
}

glm::vec3 traced_colour() {
    return error_colour(kTraced);
}

Image displacement_picture(const Plane& displacements) {
    return log_error_map(displacements, kLeastDisplacement, kMostDisplacement);
}

Image traced_picture(const Plane& traced) {
    Image picture(traced.width, traced.height);
    std::transform(traced.values.begin(), traced.values.end(), picture.pixels.begin(), [](float value) {
        if (value < 0.0f) return kLeftOutColour;
        return value > 0.0f ? traced_colour() : looked_up_colour();
    });
    return picture;
}

}  // namespace utsuri
