// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/scene_change.h"

#include "geometry/bounds.h"

#include "interop/frame.h"

#include <glm/vec3.hpp>

#include <algorithm>
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
    /// False only if nothing in a box can be seen.
    [[nodiscard]] bool may_show(const Bounds& box) const;
};

/// Entries of a list of triangles, sorted by instance, with boxes about them. Views are held against boxes
/// first: there may be as many views as instances, and far more triangles.
class TriangleGroups {
  public:
    /// @param instances of the scene
    explicit TriangleGroups(std::uint32_t instances);

    /// @param entry number by which its list knows the triangle
    /// @param box about the places of the triangle that count
    void add(std::uint32_t instance, std::uint32_t entry, const Bounds& box);

    /// Whether a view may show some entry.
    /// @param without the instance that the view leaves out
    /// @param shows (entry): whether the view may show it
    template <typename Shows>
    [[nodiscard]] bool any_in(const ViewPyramid& view, std::uint32_t without, const Shows& shows) const {
        return view.may_show(bounds_) && std::any_of(groups_.begin(), groups_.end(), [&](const Group& group) {
                   return group.instance != without && view.may_show(group.bounds) &&
                          std::any_of(group.entries.begin(), group.entries.end(), shows);
               });
    }

  private:
    struct Group {
        std::uint32_t instance;
        Bounds bounds;
        std::vector<std::uint32_t> entries;
    };
    std::vector<std::uint32_t> group_of_;  ///< of each instance, or interop::NONE
    std::vector<Group> groups_;
    Bounds bounds_;  ///< of all of them
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
    [[nodiscard]] bool has_moved(std::uint32_t instance) const { return moved_[instance]; }
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
    std::vector<bool> moved_;        ///< of each instance
    TriangleGroups changed_groups_;  ///< of SceneChange::triangles, where they were and where they are
    TriangleGroups lit_groups_;      ///< of lit_
    std::vector<std::uint32_t> reflecting_;  ///< instances with a mirror or glossy lobe
};

}  // namespace utsuri
