// SPDX-License-Identifier: Apache-2.0
#include "image/cielab.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>

#include <cmath>

namespace utsuri {
namespace {

/// Where the cube root of L* meets its tangent through the origin (CIE 15).
constexpr float kKnee = 6.0f / 29.0f;

constexpr glm::dvec2 kWhite{0.31271, 0.32902};
constexpr glm::dvec2 kRed{0.640, 0.330};
constexpr glm::dvec2 kGreen{0.300, 0.600};
constexpr glm::dvec2 kBlue{0.150, 0.060};

/// XYZ of chromaticity (x, y) with Y = 1.
glm::dvec3 xyz_from_chromaticity(const glm::dvec2& xy) {
    return {xy.x / xy.y, 1.0, (1.0 - xy.x - xy.y) / xy.y};
}

float compress(float value) {
    return value > kKnee * kKnee * kKnee ? std::cbrt(value) : value / (3.0f * kKnee * kKnee) + 4.0f / 29.0f;
}

float expand(float value) {
    return value > kKnee ? value * value * value : 3.0f * kKnee * kKnee * (value - 4.0f / 29.0f);
}

}  // namespace

XyzSpace::XyzSpace() {
    const glm::dvec3 white_xyz = xyz_from_chromaticity(kWhite);
    const glm::dmat3 primaries(xyz_from_chromaticity(kRed), xyz_from_chromaticity(kGreen),
                               xyz_from_chromaticity(kBlue));
    // The luminance of each primary is what makes their sum the white.
    const glm::dvec3 luminances = glm::inverse(primaries) * white_xyz;
    const glm::dmat3 matrix(primaries[0] * luminances.x, primaries[1] * luminances.y,
                            primaries[2] * luminances.z);
    from_linear = glm::mat3(matrix);
    to_linear = glm::mat3(glm::inverse(matrix));
    white = glm::vec3(white_xyz);
}

glm::vec3 lab_from_relative_xyz(const glm::vec3& relative) {
    const glm::vec3 f(compress(relative.x), compress(relative.y), compress(relative.z));
    return {116.0f * f.y - 16.0f, 500.0f * (f.x - f.y), 200.0f * (f.y - f.z)};
}

glm::vec3 relative_xyz_from_lab(const glm::vec3& lab) {
    const float y = (lab.x + 16.0f) / 116.0f;
    return {expand(y + lab.y / 500.0f), expand(y), expand(y - lab.z / 200.0f)};
}

}  // namespace utsuri
