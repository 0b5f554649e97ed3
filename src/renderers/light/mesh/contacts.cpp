// SPDX-License-Identifier: Apache-2.0
#include "renderers/light/mesh/contacts.h"

#include "renderers/device_scene/near_triangles.h"
#include "renderers/device_scene/scene_triangles.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace utsuri {
namespace {

/// Gaps count up to this share of a triangle's longest edge: on fine meshes, neighbours are as near as things
/// that touch coarse ones.
constexpr double kLargestGap = 1.0 / 16.0;

/// Lines are longer than this many roundings: what meets a triangle at a corner only stays within some of
/// them.
constexpr double kLeastLength = 64.0;

/// Vertices that belong in one place are this many rounding errors apart, at most: their own, and those of
/// the corners that make the plane.
constexpr double kRoundings = 8.0;

/// Triangles within the gap lie in the plane if the cosine between the normals is larger; others are rims of
/// what lies there.
constexpr double kFlat = 0.5;

/// Lines along the border of a triangle go at least this share of their length, or of its, with it.
constexpr double kLeastAlong = 1.0 / 64.0;

/// Where a corner of another triangle is with respect to a plane: before it, behind it, or in it.
enum class Side : std::uint8_t { before, behind, within };

/// A corner of a mesh, by its position: meshes split vertices whose normals differ.
using Place = std::tuple<float, float, float>;
using Edge = std::pair<Place, Place>;

Place place_of(const glm::vec3& point) {
    // Zeros of both signs are one place.
    return {point.x + 0.0f, point.y + 0.0f, point.z + 0.0f};
}

Edge edge_between(const glm::vec3& a, const glm::vec3& b) {
    return std::minmax(place_of(a), place_of(b));
}

std::array<glm::vec3, 3> vertices_of(const interop::BvhTriangle& triangle) {
    return {triangle.v0, triangle.v1, triangle.v2};
}

/// How many triangles meet in an edge that lies in a plane.
struct EdgeUse {
    int left = 0;      ///< lie in the plane, too, to the left of the edge as seen from the plane's front
    int right = 0;     ///< the same to its right
    int standing = 0;  ///< leave the plane

    [[nodiscard]] int count() const { return left + right + standing; }
    /// Whether a sheet that lies in the plane goes on over the edge.
    [[nodiscard]] bool inside_sheet() const { return standing == 0 && left == right; }
};
using Edges = std::map<Edge, EdgeUse>;

glm::dvec3 meeting_point(const glm::dvec3& a, double height_a, const glm::dvec3& b, double height_b) {
    return a + (b - a) * (height_a / (height_a - height_b));
}

/// What other triangles do to a plane: lines across it, and edges in it.
class PlaneContact {
  public:
    PlaneContact(const TriangleFrame& frame, double gap) : frame_(frame), gap_(gap) {}

    void add(const std::array<glm::vec3, 3>& other) {
        std::array<double, 3> heights{};
        std::array<Side, 3> sides{};
        for (std::size_t i = 0; i < 3; ++i) {
            heights[i] = frame_.height(other[i]);
            sides[i] = std::abs(heights[i]) <= gap_ ? Side::within
                       : heights[i] > 0.0           ? Side::before
                                                    : Side::behind;
        }
        const auto within = std::count(sides.begin(), sides.end(), Side::within);
        const bool crosses = std::count(sides.begin(), sides.end(), Side::before) > 0 &&
                             std::count(sides.begin(), sides.end(), Side::behind) > 0;
        if (crosses) add_crossing(other, heights);
        if (within < 2) return;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t next = (i + 1) % 3;
            if (sides[i] != Side::within || sides[next] != Side::within) continue;
            add_edge(other[i], other[next], other[(i + 2) % 3], within == 3 && is_flat(other));
        }
    }

    /// @param own edges of the triangle itself
    [[nodiscard]] std::vector<ContactSegment> segments(const std::array<Edge, 3>& own) const {
        std::vector<ContactSegment> result = crossings_;
        for (const auto& [edge, use] : edges_) {
            const bool is_own = std::find(own.begin(), own.end(), edge) != own.end();
            // At an edge with one neighbour the surface goes on.
            if (use.inside_sheet() || (is_own && use.count() < 2)) continue;
            result.push_back({frame_.project(point_at(edge.first)), frame_.project(point_at(edge.second))});
        }
        return result;
    }

  private:
    static glm::dvec3 point_at(const Place& place) {
        return {std::get<0>(place), std::get<1>(place), std::get<2>(place)};
    }

    /// Whether a triangle goes along the plane rather than out of it.
    [[nodiscard]] bool is_flat(const std::array<glm::vec3, 3>& other) const {
        const glm::dvec3 area = glm::cross(glm::dvec3(other[1]) - glm::dvec3(other[0]),
                                           glm::dvec3(other[2]) - glm::dvec3(other[0]));
        return std::abs(glm::dot(area, frame_.normal())) > kFlat * glm::length(area);
    }

    void add_edge(const glm::vec3& a, const glm::vec3& b, const glm::vec3& opposite, bool lying) {
        const Edge edge = edge_between(a, b);
        EdgeUse& use = edges_[edge];
        if (!lying) {
            ++use.standing;
            return;
        }
        const glm::dvec2 from = frame_.project(point_at(edge.first));
        const glm::dvec2 along = frame_.project(point_at(edge.second)) - from;
        ++(cross(along, frame_.project(opposite) - from) > 0.0 ? use.left : use.right);
    }

    void add_crossing(const std::array<glm::vec3, 3>& other, const std::array<double, 3>& heights) {
        std::vector<glm::dvec2> ends;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t next = (i + 1) % 3;
            if ((heights[i] > 0.0) == (heights[next] > 0.0)) continue;
            ends.push_back(frame_.project(
                meeting_point(glm::dvec3(other[i]), heights[i], glm::dvec3(other[next]), heights[next])));
        }
        if (ends.size() == 2) crossings_.push_back({ends[0], ends[1]});
    }

    const TriangleFrame& frame_;
    double gap_;
    Edges edges_;
    std::vector<ContactSegment> crossings_;
};

}  // namespace

std::optional<ContactSegment> clip_to_triangle(const ContactSegment& segment,
                                               const std::array<glm::dvec2, 3>& corners, double margin) {
    double begin = 0.0;
    double end = 1.0;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec2 edge = corners[(i + 1) % 3] - corners[i];
        const double length = glm::length(edge);
        const double at_from = cross(edge, segment.from - corners[i]) / length + margin;
        const double at_to = cross(edge, segment.to - corners[i]) / length + margin;
        if (at_from < 0.0 && at_to < 0.0) return std::nullopt;
        if (at_from < 0.0) begin = std::max(begin, at_from / (at_from - at_to));
        if (at_to < 0.0) end = std::min(end, at_from / (at_from - at_to));
    }
    if (begin > end) return std::nullopt;
    const glm::dvec2 along = segment.to - segment.from;
    return ContactSegment{segment.from + begin * along, segment.from + end * along};
}

namespace {

/// The part of a segment that crosses a triangle or runs along its border. At a corner that they share, lines
/// of neighbours stay beside the triangle for a while, the longer the narrower it is.
std::optional<ContactSegment> line_on(const TriangleFrame& frame, const ContactSegment& segment,
                                      double rounding) {
    const auto length = [](const std::optional<ContactSegment>& s) {
        return s ? glm::distance(s->from, s->to) : 0.0;
    };
    const std::optional<ContactSegment> near = clip_to_triangle(segment, frame.corners(), rounding);
    const double least = kLeastLength * rounding;
    const double whole = std::min(length(segment), frame.longest_edge());
    const bool crosses = length(clip_to_triangle(segment, frame.corners(), -kRoundings * rounding)) > least;
    const bool goes_along = length(near) > std::max(least, kLeastAlong * whole);
    return crosses || goes_along ? near : std::nullopt;
}

}  // namespace

ContactFinder::ContactFinder(const SceneData& scene, double gap)
    : scene_(scene), gap_(gap), rounding_(kRoundings * vertex_error(scene)) {}

std::vector<ContactSegment> ContactFinder::find(std::uint32_t triangle) const {
    const std::array<glm::vec3, 3> own = vertices_of(scene_.bvh.triangles[triangle]);
    const Corners corners = corners_of(scene_, triangle);
    if (glm::length(doubled_area(corners)) == 0.0) return {};
    const TriangleFrame frame(corners);
    const double gap = std::max(rounding_, std::min(gap_, kLargestGap * frame.longest_edge()));
    PlaneContact contact(frame, gap);
    for (const std::uint32_t other : triangles_near_plane(scene_, triangle, frame, gap))
        contact.add(vertices_of(scene_.bvh.triangles[other]));
    std::vector<ContactSegment> result;
    for (const ContactSegment& segment : contact.segments(
             {edge_between(own[0], own[1]), edge_between(own[1], own[2]), edge_between(own[2], own[0])})) {
        if (const std::optional<ContactSegment> line = line_on(frame, segment, rounding_))
            result.push_back(*line);
    }
    const auto key = [](const ContactSegment& s) { return std::tie(s.from.x, s.from.y, s.to.x, s.to.y); };
    std::sort(result.begin(), result.end(),
              [&](const ContactSegment& a, const ContactSegment& b) { return key(a) < key(b); });
    return result;
}

}  // namespace utsuri
