// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/reflection/planar/plane_mirrors.h"

#include "gpu/raster_pipeline.h"
#include "scene/camera.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace utsuri {

/// An view that shows in a mirror.
struct ShownView {
    std::uint32_t mirror;
    std::uint32_t view;
};

/// The scene as seen from the eye, or from the eye mirrored in one plane mirror after the other.
struct MirroredView {
    Camera eye;                            ///< scene space; mirrored, so its axes may be left-handed
    std::uint32_t mirror = interop::NONE;  ///< the last one
    std::uint32_t reflections = 0;
    glm::dvec3 normal{0.0};  ///< what is at dot(normal, x) > offset shows in the last mirror
    double offset = 0.0;
    PixelRect window;              ///< pixels that the last mirror can cover, seen in those before it
    std::vector<ShownView> shown;  ///< in mirrors that are seen in this view; mirrors ascending
    /// Mirrors that are not drawn, ascending: the last one, which does not see itself, and those that the eye
    /// sees from within their plane, as a line.
    std::vector<std::uint32_t> unseen;
};

/// Mirrored views of a frame, at most: facing mirrors show each other without end.
inline constexpr std::uint32_t kMostMirroredViews = 256;

/// The views that may be seen, in the order of reflections: the eye's own view first.
/// @param eye scene space
/// @param near_plane nothing nearer is seen, > 0
/// @param most_reflections deeper views are left out
/// @param least_window likewise those that show in fewer pixels
/// @param most_views likewise, those of the most reflections first; > 0
std::vector<MirroredView> plan_mirrored_views(const std::vector<PlaneMirror>& mirrors, const Camera& eye,
                                              std::uint32_t width, std::uint32_t height, double near_plane,
                                              std::uint32_t most_reflections, std::uint64_t least_window = 0,
                                              std::uint32_t most_views = kMostMirroredViews);

}  // namespace utsuri
