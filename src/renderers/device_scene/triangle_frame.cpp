// SPDX-License-Identifier: Apache-2.0
#include "renderers/device_scene/triangle_frame.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace utsuri {

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

TriangleFrame::TriangleFrame(const std::array<glm::dvec3, 3>& corners) : origin_(corners[0]) {
    right_ = glm::normalize(corners[1] - corners[0]);
    normal_ = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    up_ = glm::cross(normal_, right_);
    for (std::size_t i = 0; i < 3; ++i)
        corners_[i] = project(corners[i]);
}

glm::dvec2 TriangleFrame::project(const glm::dvec3& point) const {
    return {glm::dot(point - origin_, right_), glm::dot(point - origin_, up_)};
}

double TriangleFrame::height(const glm::dvec3& point) const {
    return glm::dot(point - origin_, normal_);
}

double TriangleFrame::longest_edge() const {
    return std::max({glm::distance(corners_[0], corners_[1]), glm::distance(corners_[1], corners_[2]),
                     glm::distance(corners_[2], corners_[0])});
}

}  // namespace utsuri
