// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/planar/mirrored_views.h"

#include "geometry/clip_polygon.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace utsuri {
namespace {

/// Pixels that windows are widened by on each side: rasterisers place corners to 1/256 of one.
constexpr double kMargin = 1.0;

using Polygon = std::vector<glm::dvec3>;

class Planner {
  public:
    Planner(const std::vector<PlaneMirror>& mirrors, std::uint32_t width, std::uint32_t height,
            double near_plane)
        : mirrors_(mirrors), size_(width, height), near_plane_(near_plane) {}

    /// Mirrors that a view does not draw.
    [[nodiscard]] std::vector<std::uint32_t> unseen_in(const MirroredView& view) const {
        std::vector<std::uint32_t> unseen;
        for (std::uint32_t mirror = 0; mirror < mirrors_.size(); ++mirror) {
            const bool edge_on =
                std::abs(distance_from(mirrors_[mirror], view.eye)) <= mirrors_[mirror].tolerance;
            if (edge_on || mirror == view.mirror) unseen.push_back(mirror);
        }
        return unseen;
    }

    /// The view that shows in a mirror which is seen in `parent`; none where the mirror cannot be seen.
    [[nodiscard]] std::optional<MirroredView> mirrored(const MirroredView& parent,
                                                       std::uint32_t mirror) const {
        const PlaneMirror& plane = mirrors_[mirror];
        const double distance = distance_from(plane, parent.eye);
        const std::optional<PixelRect> window = window_of(plane, parent);
        if (!window) return std::nullopt;
        const double side = distance > 0.0 ? 1.0 : -1.0;
        MirroredView view;
        view.eye = parent.eye;
        view.eye.position -= 2.0 * distance * plane.normal;
        for (glm::dvec3* axis : {&view.eye.right, &view.eye.up, &view.eye.forward})
            *axis -= 2.0 * glm::dot(*axis, plane.normal) * plane.normal;
        view.mirror = mirror;
        view.reflections = parent.reflections + 1;
        view.normal = side * plane.normal;
        // What touches the mirror is seen up to rounding; what it is fixed to is not seen.
        view.offset = side * plane.offset + plane.tolerance;
        view.window = *window;
        return view;
    }

  private:
    static double distance_from(const PlaneMirror& plane, const Camera& eye) {
        return glm::dot(plane.normal, eye.position) - plane.offset;
    }

    /// Pixels of the parent's window that the mirror can cover.
    [[nodiscard]] std::optional<PixelRect> window_of(const PlaneMirror& mirror,
                                                     const MirroredView& parent) const {
        const Camera& eye = parent.eye;
        Polygon seen(mirror.outline.begin(), mirror.outline.end());
        if (parent.mirror != interop::NONE) seen = clip_polygon(seen, parent.normal, parent.offset);
        seen = clip_polygon(seen, eye.forward, glm::dot(eye.forward, eye.position) + near_plane_);
        if (seen.empty()) return std::nullopt;
        glm::dvec2 lower(std::numeric_limits<double>::infinity());
        glm::dvec2 upper(-lower);
        for (const glm::dvec3& corner : seen) {
            const glm::dvec2 pixel = pixel_of(eye, corner);
            lower = glm::min(lower, pixel);
            upper = glm::max(upper, pixel);
        }
        const PixelRect& within = parent.window;
        const glm::dvec2 first(within.x, within.y);
        const glm::dvec2 end = first + glm::dvec2(within.width, within.height);
        lower = glm::clamp(glm::floor(lower - kMargin), first, end);
        upper = glm::clamp(glm::ceil(upper + kMargin), first, end);
        if (!(lower.x < upper.x) || !(lower.y < upper.y)) return std::nullopt;
        return PixelRect{static_cast<std::uint32_t>(lower.x), static_cast<std::uint32_t>(lower.y),
                         static_cast<std::uint32_t>(upper.x - lower.x),
                         static_cast<std::uint32_t>(upper.y - lower.y)};
    }

    [[nodiscard]] glm::dvec2 pixel_of(const Camera& eye, const glm::dvec3& point) const {
        const glm::dvec3 from_eye = point - eye.position;
        const double half_height = std::tan(0.5 * eye.vertical_fov) * glm::dot(from_eye, eye.forward);
        const double half_width = half_height * size_.x / size_.y;
        return 0.5 * size_ *
               glm::dvec2(1.0 + glm::dot(from_eye, eye.right) / half_width,
                          1.0 - glm::dot(from_eye, eye.up) / half_height);
    }

    const std::vector<PlaneMirror>& mirrors_;
    glm::dvec2 size_;
    double near_plane_;
};

}  // namespace

std::vector<MirroredView> plan_mirrored_views(const std::vector<PlaneMirror>& mirrors, const Camera& eye,
                                              std::uint32_t width, std::uint32_t height, double near_plane,
                                              std::uint32_t most_reflections, std::uint64_t least_window,
                                              std::uint32_t most_views) {
    const Planner planner(mirrors, width, height, near_plane);
    MirroredView direct;
    direct.eye = eye;
    direct.window = {0, 0, width, height};
    std::vector<MirroredView> views = {direct};
    for (std::size_t parent = 0; parent < views.size(); ++parent) {
        const std::vector<std::uint32_t> unseen = planner.unseen_in(views[parent]);
        views[parent].unseen = unseen;
        if (views[parent].reflections == most_reflections) continue;
        for (std::uint32_t mirror = 0; mirror < mirrors.size() && views.size() < most_views; ++mirror) {
            if (std::binary_search(unseen.begin(), unseen.end(), mirror)) continue;
            auto view = planner.mirrored(views[parent], mirror);
            if (view && std::uint64_t{view->window.width} * view->window.height >= least_window) {
                views[parent].shown.push_back({mirror, static_cast<std::uint32_t>(views.size())});
                views.push_back(std::move(*view));
            }
        }
    }
    return views;
}

}  // namespace utsuri
