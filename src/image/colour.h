// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace utsuri {

/// Weights of the linear Rec.709 channels in luminance (ITU-R BT.709-6, table 3); their sum is one.
inline constexpr glm::vec3 kLuminanceWeights{0.2126f, 0.7152f, 0.0722f};

/// Luminance of a linear Rec.709 colour, in the unit of its channels.
[[nodiscard]] inline float luminance(const glm::vec3& linear) {
    return kLuminanceWeights.x * linear.x + kLuminanceWeights.y * linear.y + kLuminanceWeights.z * linear.z;
}

/// Linear light to the sRGB code value (IEC 61966-2-1), display white = 1. Not clamped: values below zero
/// follow the linear segment, values above one the power segment.
[[nodiscard]] inline float srgb_encode(float linear) {
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

/// The inverse of srgb_encode.
[[nodiscard]] inline float srgb_decode(float coded) {
    return coded <= 0.04045f ? coded / 12.92f : std::pow((coded + 0.055f) / 1.055f, 2.4f);
}

[[nodiscard]] inline glm::vec3 srgb_encode(const glm::vec3& linear) {
    return {srgb_encode(linear.x), srgb_encode(linear.y), srgb_encode(linear.z)};
}

[[nodiscard]] inline glm::vec3 srgb_decode(const glm::vec3& coded) {
    return {srgb_decode(coded.x), srgb_decode(coded.y), srgb_decode(coded.z)};
}

/// The factor of an exposure in stops: 2^stops.
[[nodiscard]] inline double exposure_scale(double stops) {
    return std::exp2(stops);
}

[[nodiscard]] inline bool is_finite(const glm::vec3& value) {
    return std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z);
}

/// What a display shows of a linear value: scaled, clamped to [0, 1], sRGB coded. The value must be finite.
/// The product is in double, so that no exposure overflows or flushes a float value.
[[nodiscard]] inline glm::vec3 display_code(const glm::vec3& linear, double scale) {
    const auto shown = [scale](float value) {
        return srgb_encode(static_cast<float>(std::clamp(static_cast<double>(value) * scale, 0.0, 1.0)));
    };
    return {shown(linear.x), shown(linear.y), shown(linear.z)};
}

}  // namespace utsuri
