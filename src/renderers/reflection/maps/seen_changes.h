// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/scene/scene_change.h"

#include "interop/frame.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace utsuri {

/// All that a picture in perspective may show: directions forward + x right + y up, with x and y in [-1, 1].
/// `right` and `up` are at right angles; `forward` need not be the normal of their plane.
struct ViewPyramid {
    glm::dvec3 apex;  ///< scene space
    glm::dvec3 right;
    glm::dvec3 up;
    glm::dvec3 forward;

    explicit ViewPyramid(const interop::CameraInfo& camera);
    /// A face of a cube about a point, wider by a share of its edge.
    /// @param face in the order of lib/cube.glsl
    ViewPyramid(const glm::dvec3& apex, std::uint32_t face, double wider);

    /// False only if a triangle cannot be seen: all of it lies beyond one side, told with room for the
    /// rounding of rays in float32.
    [[nodiscard]] bool may_show(const interop::BvhTriangle& triangle) const;
};

/// Which views of a scene a change may have changed: what it touches lies in them, in front of something or
/// behind it.
class SeenChanges {
  public:
    /// `data` and `change` must outlive this.
    /// @param data after the change
    /// @param lit triangles whose light changed
    SeenChanges(const SceneData& data, const SceneChange& change, std::vector<std::uint32_t> lit);

    [[nodiscard]] bool empty() const { return change_.empty() && lit_.empty(); }
    /// Whether some triangle of an instance is elsewhere.
    [[nodiscard]] bool has_moved(std::uint32_t instance) const;
    /// Whether the surfaces in a view may be others, elsewhere, or of another look.
    /// @param without the instance that the view leaves out
    [[nodiscard]] bool surfaces_may_change_in(const ViewPyramid& view, std::uint32_t without) const;
    /// Whether a picture that traces what mirrors and glossy lobes in it reflect may look otherwise.
    [[nodiscard]] bool appearance_may_change_in(const ViewPyramid& view, std::uint32_t without) const;

  private:
    [[nodiscard]] bool shows_reflections(const ViewPyramid& view, std::uint32_t without) const;

    const SceneData& data_;
    const SceneChange& change_;
    std::vector<std::uint32_t> lit_;
    std::vector<std::uint32_t> reflecting_;  ///< triangles with a mirror or glossy lobe
};

}  // namespace utsuri
