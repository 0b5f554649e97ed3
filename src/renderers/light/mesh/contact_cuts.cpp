// SPDX-License-Identifier: Apache-2.0
#include "renderers/light/mesh/contact_cuts.h"

#include "renderers/device_scene/scene_triangles.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace utsuri {
namespace {

/// A leaf is not cut along a line that is shorter than this share of its longest edge, but split until the
/// line is longer in it. Cuts go on beyond the ends of their lines, to the border of the leaf.
constexpr double kLeastShare = 1.0 / 32.0;

/// Leaves whose edges are no longer than this share of the finest distance of points are cut along any line.
constexpr double kFinestCut = 0.25;

/// Cuts above each other: as many levels are left for light.
constexpr std::uint32_t kMostCuts = kMeshDepth / 2;

/// How far a point beside a contact is moved off it: this share of the way to the middle of its leaf, and no
/// farther than this share of the finest distance.
constexpr double kWayInside = 1.0 / 16.0;
constexpr double kMostInside = 1.0 / 16.0;

double distance_to(const ContactSegment& segment, const glm::dvec2& point) {
    const glm::dvec2 along = segment.to - segment.from;
    const double square = glm::dot(along, along);
    const double share =
        square > 0.0 ? std::clamp(glm::dot(point - segment.from, along) / square, 0.0, 1.0) : 0.0;
    return glm::distance(point, segment.from + share * along);
}

/// The contacts of one triangle of the scene.
class TriangleCuts {
  public:
    TriangleCuts(MeshTree& mesh, const Corners& corners, std::vector<ContactSegment> segments,
                 double rounding, double finest)
        : mesh_(mesh),
          frame_(corners),
          segments_(std::move(segments)),
          rounding_(rounding),
          finest_(finest) {}

    /// @param leaf the whole triangle
    void cut(std::uint32_t leaf) {
        std::vector<Work> work = {{leaf, {}}};
        for (std::uint32_t i = 0; i < segments_.size(); ++i)
            work.front().segments.push_back(i);
        while (!work.empty()) {
            Work next = std::move(work.back());
            work.pop_back();
            const std::optional<Cut> cut =
                mesh_.can_split(next.leaf) && mesh_.leaves()[next.leaf].depth < kMostCuts ? find_cut(next)
                                                                                          : std::nullopt;
            if (!cut) {
                finish(next);
                continue;
            }
            const std::uint32_t child = cut->bisects
                                            ? mesh_.bisect(next.leaf)
                                            : mesh_.split(next.leaf, cut->edge, cut->share, interop::NONE);
            work.push_back({child, next.segments});
            work.push_back({child + 1, std::move(next.segments)});
        }
    }

  private:
    /// A leaf and the lines that may meet it.
    struct Work {
        std::uint32_t leaf;
        std::vector<std::uint32_t> segments;
    };
    struct Cut {
        bool bisects = true;
        std::uint32_t edge = 0;
        float share = 0.5f;
    };
    using Triangle2 = std::array<glm::dvec2, 3>;

    [[nodiscard]] glm::dvec2 in_plane(const glm::dvec2& b) const {
        const Triangle2& c = frame_.corners();
        return c[0] + b.x * (c[1] - c[0]) + b.y * (c[2] - c[0]);
    }
    [[nodiscard]] Triangle2 corners_of_leaf(std::uint32_t leaf) const {
        const std::array<glm::dvec2, 3>& b = mesh_.leaves()[leaf].corners;
        return {in_plane(b[0]), in_plane(b[1]), in_plane(b[2])};
    }

    /// How to split a leaf that some line crosses; drops lines that do not meet it.
    std::optional<Cut> find_cut(Work& work) const {
        const Triangle2 corners = corners_of_leaf(work.leaf);
        double longest_inside = 0.0;
        std::optional<Cut> found;
        std::vector<std::uint32_t> meeting;
        for (const std::uint32_t s : work.segments) {
            const std::optional<ContactSegment> inside = clip_to_triangle(segments_[s], corners, rounding_);
            if (!inside) continue;
            meeting.push_back(s);
            const double length = glm::distance(inside->from, inside->to);
            const std::optional<Cut> cut = cut_along(segments_[s], corners);
            if (!cut || length <= std::max(longest_inside, rounding_)) continue;
            longest_inside = length;
            found = cut;
        }
        work.segments = std::move(meeting);
        if (!found) return std::nullopt;
        const double edge = mesh_.longest_edge(mesh_.leaves()[work.leaf]).length;
        const bool bisects = longest_inside < kLeastShare * edge && edge > kFinestCut * finest_;
        return bisects ? Cut{} : found;
    }

    /// The split at which the line of a segment crosses an edge, or leads from a corner to one; none if the
    /// line passes by or along an edge.
    [[nodiscard]] std::optional<Cut> cut_along(const ContactSegment& segment,
                                               const Triangle2& corners) const {
        const glm::dvec2 along = glm::normalize(segment.to - segment.from);
        std::array<double, 3> beside{};
        for (std::size_t i = 0; i < 3; ++i) {
            beside[i] = cross(along, corners[i] - segment.from);
            if (std::abs(beside[i]) <= rounding_) beside[i] = 0.0;
        }
        std::optional<Cut> best;
        double longest = 0.0;
        for (std::uint32_t edge = 0; edge < 3; ++edge) {
            const std::size_t next = (edge + 1) % 3;
            if (beside[edge] * beside[next] >= 0.0) continue;
            const double length = glm::distance(corners[edge], corners[next]);
            if (length <= longest) continue;
            longest = length;
            auto share = static_cast<float>(beside[edge] / (beside[edge] - beside[next]));
            // Half is the share of splits that are not cuts: MeshNode.
            if (share == 0.5f) share = std::nextafter(0.5f, 1.0f);
            best = Cut{false, edge, share};
        }
        return best && best->share > 0.0f && best->share < 1.0f ? best : std::nullopt;
    }

    /// Gives a leaf that is not cut any more its points.
    void finish(const Work& work) {
        if (work.segments.empty() && !lacks_points(work.leaf)) return;
        const Triangle2 corners = corners_of_leaf(work.leaf);
        const MeshLeaf leaf = mesh_.leaves()[work.leaf];
        const glm::dvec2 middle = (leaf.corners[0] + leaf.corners[1] + leaf.corners[2]) / 3.0;
        for (std::uint32_t corner = 0; corner < 3; ++corner) {
            const glm::dvec2 b = leaf.corners[corner];
            if (touches(work, corners[corner])) {
                const double way = glm::distance(in_plane(middle), corners[corner]);
                const double share = std::min(kWayInside, kMostInside * finest_ / way);
                const glm::dvec2 place = b + share * (middle - b);
                mesh_.set_point(work.leaf, corner, mesh_.add_point(leaf.triangle, place), place);
            } else if (leaf.points[corner] == interop::NONE) {
                std::uint32_t& point = made_.try_emplace({b.x, b.y}, interop::NONE).first->second;
                if (point == interop::NONE) point = mesh_.add_point(leaf.triangle, b);
                mesh_.set_point(work.leaf, corner, point, b);
            }
        }
    }

    [[nodiscard]] bool lacks_points(std::uint32_t leaf) const {
        const std::array<std::uint32_t, 3>& points = mesh_.leaves()[leaf].points;
        return std::find(points.begin(), points.end(), interop::NONE) != points.end();
    }
    [[nodiscard]] bool touches(const Work& work, const glm::dvec2& corner) const {
        return std::any_of(work.segments.begin(), work.segments.end(), [&](std::uint32_t s) {
            return distance_to(segments_[s], corner) <= 2.0 * rounding_;
        });
    }

    MeshTree& mesh_;
    TriangleFrame frame_;
    std::vector<ContactSegment> segments_;
    double rounding_;
    double finest_;
    /// Points off all contacts that cuts have made, by their barycentric coordinates.
    std::map<std::pair<double, double>, std::uint32_t> made_;
};

}  // namespace

void cut_at_contacts(MeshTree& mesh, const SceneData& scene, const ContactFinder& finder, double finest,
                     std::uint64_t most_points) {
    // Large triangles first: on small ones light cannot leak far.
    std::vector<std::uint32_t> roots(mesh.leaves().size());
    std::iota(roots.begin(), roots.end(), 0u);
    std::vector<double> areas;
    for (const MeshLeaf& leaf : mesh.leaves())
        areas.push_back(mesh.area(leaf));
    std::stable_sort(roots.begin(), roots.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return areas[a] > areas[b]; });
    const std::uint64_t limit = mesh.places().size() + most_points;
    for (const std::uint32_t leaf : roots) {
        if (mesh.places().size() >= limit || mesh.is_full()) break;
        const std::uint32_t triangle = mesh.leaves()[leaf].triangle;
        std::vector<ContactSegment> segments = finder.find(triangle);
        if (segments.empty()) continue;
        TriangleCuts(mesh, corners_of(scene, triangle), std::move(segments), finder.rounding(), finest)
            .cut(leaf);
    }
}

}  // namespace utsuri
