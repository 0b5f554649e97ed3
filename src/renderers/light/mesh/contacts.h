// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/scene_data.h"
#include "renderers/device_scene/triangle_frame.h"

#include <glm/vec2.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace utsuri {

/// A line in a triangle's plane along which something touches or crosses it: light on its two sides has
/// nothing to do with each other. In metres, in the plane's own coordinates: TriangleFrame.
struct ContactSegment {
    glm::dvec2 from;
    glm::dvec2 to;
};

/// The part of a segment inside a triangle, grown by `margin`; none if all of it is outside.
/// @param corners counterclockwise
std::optional<ContactSegment> clip_to_triangle(const ContactSegment& segment,
                                               const std::array<glm::dvec2, 3>& corners, double margin);

/// Finds what touches or crosses triangles of a scene. Neighbours in one surface, which share a whole edge
/// with a triangle and nobody else, do not count.
class ContactFinder {
  public:
    /// @param scene must outlive this
    /// @param gap metres: what is no farther from a triangle touches it; less counts on triangles that are
    ///     not much larger
    ContactFinder(const SceneData& scene, double gap);

    /// Lines on a triangle, ordered, each once.
    [[nodiscard]] std::vector<ContactSegment> find(std::uint32_t triangle) const;
    /// How far rounding may put things that were modelled to touch from each other, metres.
    [[nodiscard]] double rounding() const { return rounding_; }

  private:
    const SceneData& scene_;
    double gap_;
    double rounding_;
};

}  // namespace utsuri
