// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection_map/self_horizon.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace utsuri {
namespace {

/// Room for the rounding of sines, here and on the device, which has them in float32.
constexpr double kSineRounding = 0x1p-17;

struct Triangle {
    Corners corners;
    glm::dvec3 normal{0.0};  ///< unit; zero where the triangle has no area

    explicit Triangle(const Corners& at) : corners(at) {
        const glm::dvec3 area = doubled_area(at);
        const double length = glm::length(area);
        if (length > 0.0) normal = area / length;
    }
    [[nodiscard]] bool has_area() const { return normal != glm::dvec3(0.0); }
    /// Over its plane.
    [[nodiscard]] double height(const glm::dvec3& point) const {
        return glm::dot(normal, point - corners[0]);
    }
};

struct Box {
    glm::dvec3 lower{std::numeric_limits<double>::infinity()};
    glm::dvec3 upper{-std::numeric_limits<double>::infinity()};

    void extend(const glm::dvec3& point) {
        lower = glm::min(lower, point);
        upper = glm::max(upper, point);
    }
};

double distance_between(const Box& a, const Box& b) {
    return glm::length(glm::max(glm::dvec3(0.0), glm::max(a.lower - b.upper, b.lower - a.upper)));
}

Box box_of(const Corners& corners) {
    Box box;
    for (const glm::dvec3& corner : corners)
        box.extend(corner);
    return box;
}

/// How far rounding can put a corner off its place: half a unit in the last place of the largest coordinate,
/// for the corner and for the plane it is held against.
double rounding_of(const std::vector<Corners>& surface) {
    double largest = 0.0;
    for (const Corners& corners : surface) {
        for (const glm::dvec3& corner : corners)
            largest = std::max({largest, std::abs(corner.x), std::abs(corner.y), std::abs(corner.z)});
    }
    return 8.0 * kUnitRoundoff * largest;
}

/// Sine of an elevation from a height and a bound on the distance.
double steepest(double height, double least_distance) {
    return least_distance > height ? height / least_distance : 1.0;
}

/// Corners of the part of a triangle over the plane of another.
struct RisingPart {
    std::vector<glm::dvec3> corners;
    double height = 0.0;

    RisingPart(const Triangle& ground, const Corners& rising) {
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec3& from = rising[i];
            const glm::dvec3& to = rising[(i + 1) % 3];
            const double h0 = ground.height(from);
            const double h1 = ground.height(to);
            height = std::max(height, h0);
            if (h0 >= 0.0) corners.push_back(from);
            if ((h0 < 0.0) != (h1 < 0.0)) corners.push_back(glm::mix(from, to, h0 / (h0 - h1)));
        }
    }
};

/// How far apart two convex polygons are, at least: the widest gap across one of a few directions, among
/// them those between corners, and from edges within their planes.
double gap_between(const Triangle& a, const std::vector<glm::dvec3>& b, const glm::dvec3& normal_b) {
    double widest = 0.0;
    const auto try_direction = [&](const glm::dvec3& along) {
        const double length = glm::length(along);
        if (!(length > 0.0)) return;
        double begin = std::numeric_limits<double>::infinity();
        double end = -begin;
        for (const glm::dvec3& corner : b)
            begin = std::min(begin, glm::dot(along, corner - a.corners[0]));
        for (const glm::dvec3& corner : a.corners)
            end = std::max(end, glm::dot(along, corner - a.corners[0]));
        widest = std::max(widest, (begin - end) / length);
    };
    for (std::size_t i = 0; i < b.size(); ++i) {
        for (const glm::dvec3& corner : a.corners)
            try_direction(b[i] - corner);
        const glm::dvec3 across = glm::cross(b[(i + 1) % b.size()] - b[i], normal_b);
        try_direction(across);
        try_direction(-across);
    }
    for (std::size_t i = 0; i < 3; ++i)
        try_direction(glm::cross(a.corners[(i + 1) % 3] - a.corners[i], a.normal));
    return widest;
}

/// From the triangle's plane along an edge that both share: as steep as the other's plane, or upright where
/// that leans over the triangle.
double elevation_across_edge(const Triangle& ground, const glm::dvec3& from, const glm::dvec3& to,
                             const glm::dvec3& third, const glm::dvec3& apex) {
    const glm::dvec3 along = glm::normalize(to - from);
    const auto off_edge = [&](const glm::dvec3& point) {
        return point - from - glm::dot(point - from, along) * along;
    };
    if (glm::dot(off_edge(apex), off_edge(third)) >= 0.0) return 1.0;
    return std::min(1.0, ground.height(apex) / glm::length(off_edge(apex)));
}

/// The corner of a triangle as the wedge between its edges there, which holds the triangle.
class Wedge {
  public:
    Wedge(const Triangle& triangle, std::size_t corner)
        : apex_(triangle.corners[corner]),
          normal_(triangle.normal),
          sides_{glm::normalize(triangle.corners[(corner + 1) % 3] - apex_),
                 glm::normalize(triangle.corners[(corner + 2) % 3] - apex_)} {}

    /// Sine of the elevation at which a point over the plane is seen from where in the wedge that is most.
    [[nodiscard]] double elevation(const glm::dvec3& point) const {
        const double height = glm::dot(normal_, point - apex_);
        const glm::dvec3 below = point - apex_ - height * normal_;
        const bool is_within = glm::dot(glm::cross(sides_.first, below), normal_) >= 0.0 &&
                               glm::dot(glm::cross(below, sides_.second), normal_) >= 0.0;
        if (is_within) return 1.0;
        double least = std::numeric_limits<double>::infinity();
        for (const glm::dvec3& side : {sides_.first, sides_.second})
            least = std::min(least, glm::length(below - std::max(0.0, glm::dot(below, side)) * side));
        return height / std::sqrt(height * height + least * least);
    }

  private:
    glm::dvec3 apex_;
    glm::dvec3 normal_;
    std::pair<glm::dvec3, glm::dvec3> sides_;  ///< counter-clockwise about the normal
};

/// From around a corner that both share. All of the other triangle lies on ways from the corner to its
/// opposite edge, along which elevations do not change; along that edge, over the plane, they rise to one
/// maximum (a linear over a convex function), which is found by thirds.
double elevation_around_corner(const Triangle& ground, std::size_t corner, glm::dvec3 from, glm::dvec3 to) {
    const double h0 = ground.height(from);
    const double h1 = ground.height(to);
    if (h0 < 0.0) from = glm::mix(from, to, h0 / (h0 - h1));
    if (h1 < 0.0) to = glm::mix(to, from, h1 / (h1 - std::max(h0, 0.0)));
    const Wedge wedge(ground, corner);
    constexpr int kThirds = 24;  // to a few times 1e-5 of the edge
    double begin = 0.0;
    double end = 1.0;
    for (int i = 0; i < kThirds; ++i) {
        const double third = (end - begin) / 3.0;
        const double a = wedge.elevation(glm::mix(from, to, begin + third));
        const double b = wedge.elevation(glm::mix(from, to, end - third));
        (a < b ? begin : end) = a < b ? begin + third : end - third;
    }
    return wedge.elevation(glm::mix(from, to, 0.5 * (begin + end)));
}

/// Where another triangle has the corners of one: its numbers of them, or 3.
struct SharedCorners {
    std::array<std::size_t, 3> in_other{3, 3, 3};
    int count = 0;

    SharedCorners(const Corners& one, const Corners& other) {
        for (std::size_t i = 0; i < 3; ++i) {
            in_other[i] =
                static_cast<std::size_t>(std::find(other.begin(), other.end(), one[i]) - other.begin());
            count += in_other[i] < 3 ? 1 : 0;
        }
    }
};

double elevation_of(const Triangle& ground, const Triangle& other, double rounding) {
    const RisingPart rising(ground, other.corners);
    if (!(rising.height > rounding) || !other.has_area()) return 0.0;
    const SharedCorners shared(ground.corners, other.corners);
    if (shared.count == 0) return steepest(rising.height, gap_between(ground, rising.corners, other.normal));
    if (shared.count == 3) return 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const std::size_t k = (i + 2) % 3;
        const std::size_t at = shared.in_other[i];
        if (shared.count == 1 && at < 3)
            return elevation_around_corner(ground, i, other.corners[(at + 1) % 3],
                                           other.corners[(at + 2) % 3]);
        if (shared.count == 2 && at == 3)
            return elevation_across_edge(ground, ground.corners[j], ground.corners[k], ground.corners[i],
                                         other.corners[3 - shared.in_other[j] - shared.in_other[k]]);
    }
    return 1.0;
}

/// A surface as a binary tree over its list of triangles: a node is followed by its first half, then by its
/// second.
class SurfaceTree {
  public:
    SurfaceTree(const std::vector<Corners>& surface, double rounding)
        : triangles_(surface.begin(), surface.end()), rounding_(rounding) {
        boxes_.reserve(2 * surface.size());
        add(0, surface.size());
    }

    /// @param visits counts down; the horizon is 1 when none is left
    double horizon_of(std::size_t triangle, std::uint64_t& visits) const {
        if (!triangles_[triangle].has_area()) return 0.0;
        double horizon = 0.0;
        raise(triangle, box_of(triangles_[triangle].corners), {0, 0, triangles_.size()}, horizon, visits);
        return horizon;
    }

  private:
    struct Node {
        std::size_t index;
        std::size_t begin;
        std::size_t end;

        [[nodiscard]] std::size_t middle() const { return begin + (end - begin) / 2; }
        [[nodiscard]] Node first() const { return {index + 1, begin, middle()}; }
        [[nodiscard]] Node second() const { return {index + 2 * (middle() - begin), middle(), end}; }
    };

    Box add(std::size_t begin, std::size_t end) {
        const std::size_t index = boxes_.size();
        boxes_.emplace_back();
        Box box = end - begin == 1 ? box_of(triangles_[begin].corners) : Box();
        if (end - begin > 1) {
            const std::size_t middle = begin + (end - begin) / 2;
            for (const Box& half : {add(begin, middle), add(middle, end)}) {
                box.extend(half.lower);
                box.extend(half.upper);
            }
        }
        boxes_[index] = box;
        return box;
    }

    /// Of all that may lie in a box.
    double elevation_of_box(const Triangle& ground, const Box& around_ground, const Box& box) const {
        const glm::dvec3 half = 0.5 * (box.upper - box.lower);
        const double height =
            ground.height(0.5 * (box.lower + box.upper)) + glm::dot(glm::abs(ground.normal), half);
        if (!(height > rounding_)) return 0.0;
        return steepest(height, distance_between(around_ground, box));
    }

    void raise(std::size_t triangle, const Box& around, const Node& node, double& horizon,
               std::uint64_t& visits) const {
        if (visits == 0) {
            horizon = 1.0;
            return;
        }
        --visits;
        const Triangle& ground = triangles_[triangle];
        if (node.end - node.begin == 1) {
            if (node.begin != triangle)
                horizon = std::max(horizon, elevation_of(ground, triangles_[node.begin], rounding_));
            return;
        }
        std::array<Node, 2> halves = {node.first(), node.second()};
        std::array<double, 2> bounds{};
        for (std::size_t i = 0; i < 2; ++i)
            bounds[i] = elevation_of_box(ground, around, boxes_[halves[i].index]);
        if (bounds[1] > bounds[0]) {
            std::swap(halves[0], halves[1]);
            std::swap(bounds[0], bounds[1]);
        }
        for (std::size_t i = 0; i < 2; ++i) {
            if (bounds[i] > horizon) raise(triangle, around, halves[i], horizon, visits);
        }
    }

    std::vector<Triangle> triangles_;
    double rounding_;
    std::vector<Box> boxes_;
};

}  // namespace

std::vector<float> self_horizons(const std::vector<Corners>& surface) {
    std::vector<float> horizons;
    if (surface.empty()) return horizons;
    const SurfaceTree tree(surface, rounding_of(surface));
    std::uint64_t visits = kMostHorizonVisits;
    for (std::size_t i = 0; i < surface.size(); ++i) {
        const double horizon = tree.horizon_of(i, visits);
        horizons.push_back(static_cast<float>(horizon > 0.0 ? std::min(1.0, horizon + kSineRounding) : 0.0));
    }
    return horizons;
}

}  // namespace utsuri
