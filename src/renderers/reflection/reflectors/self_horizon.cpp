// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/reflectors/self_horizon.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace utsuri {
namespace {

/// A bound need not be found more closely than to this factor.
constexpr double kCloseEnough = 1.01;

/// What it costs to look at a pair of triangles, in groups of them.
constexpr std::uint64_t kVisitsOfAPair = 8;

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

/// Room for the rounding of sines on the device, in float32: of a unit direction, and of the normal that is
/// the product of two edges, where these are long beside its length.
double sine_rounding(const Triangle& triangle) {
    const Corners& c = triangle.corners;
    const double edges = glm::distance(c[0], c[1]) * glm::distance(c[0], c[2]);
    return kUnitRoundoff * (16.0 + 8.0 * edges / glm::length(doubled_area(c)));
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

    [[nodiscard]] double height(const glm::dvec3& point) const { return glm::dot(normal_, point - apex_); }
    /// To a point over the plane.
    [[nodiscard]] double distance(const glm::dvec3& point) const {
        const double up = height(point);
        const glm::dvec3 below = point - apex_ - up * normal_;
        const bool is_within = glm::dot(glm::cross(sides_.first, below), normal_) >= 0.0 &&
                               glm::dot(glm::cross(below, sides_.second), normal_) >= 0.0;
        if (is_within) return up;
        double least = std::numeric_limits<double>::infinity();
        for (const glm::dvec3& side : {sides_.first, sides_.second})
            least = std::min(least, glm::length(below - std::max(0.0, glm::dot(below, side)) * side));
        return std::sqrt(up * up + least * least);
    }

  private:
    glm::dvec3 apex_;
    glm::dvec3 normal_;
    std::pair<glm::dvec3, glm::dvec3> sides_;  ///< counter-clockwise about the normal
};

/// Bound on the sines at which points between two are seen from the wedge, by halves: heights are linear in
/// between, and distances no less than that of the middle and how far it is to the ends.
/// @param seen the greatest sine found so far: a bound is good enough if it is hardly above
double elevation_between(const Wedge& wedge, const glm::dvec3& from, const glm::dvec3& to, double& seen,
                         int halvings) {
    const glm::dvec3 middle = glm::mix(from, to, 0.5);
    const double distance = wedge.distance(middle);
    seen = std::max(seen, steepest(wedge.height(middle), distance));
    const double bound =
        steepest(std::max(wedge.height(from), wedge.height(to)), distance - 0.5 * glm::distance(from, to));
    if (halvings == 0 || bound <= kCloseEnough * seen) return bound;
    const double first = elevation_between(wedge, from, middle, seen, halvings - 1);
    return std::max(first, elevation_between(wedge, middle, to, seen, halvings - 1));
}

/// From around a corner that both share: all of the other triangle lies on ways from the corner to its
/// opposite edge, along which elevations do not change.
double elevation_around_corner(const Triangle& ground, std::size_t corner, glm::dvec3 from, glm::dvec3 to) {
    constexpr int kMostHalvings = 20;
    const double h0 = ground.height(from);
    const double h1 = ground.height(to);
    if (h0 < 0.0) from = glm::mix(from, to, h0 / (h0 - h1));
    if (h1 < 0.0) to = glm::mix(to, from, h1 / (h1 - std::max(h0, 0.0)));
    double seen = 0.0;
    return elevation_between(Wedge(ground, corner), from, to, seen, kMostHalvings);
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
    // Facets in one plane rise by rounding, and where they touch, at any angle.
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

/// What a part of a surface lies in: a box, and a ball about its centre cut by two planes across the mean
/// normal. Told by both, a smooth part rises before its neighbours by little more than it does.
struct Part {
    Box box;
    double radius = 0.0;
    glm::dvec3 normal{0.0};  ///< unit, or zero
    double lowest = 0.0;     ///< of what is in it, along the normal from the centre
    double highest = 0.0;

    [[nodiscard]] glm::dvec3 centre() const { return 0.5 * (box.lower + box.upper); }

    /// Bound on the height of what is in it over a plane.
    [[nodiscard]] double height_over(const Triangle& ground) const {
        const double at_centre = ground.height(centre());
        const double in_box = glm::dot(glm::abs(ground.normal), 0.5 * (box.upper - box.lower));
        const double cosine = glm::dot(ground.normal, normal);
        const double sine = glm::length(ground.normal - cosine * normal);
        const double in_ball = std::max(cosine * lowest, cosine * highest) + sine * radius;
        return at_centre + std::min(in_box, in_ball);
    }
};

Part part_of(const std::vector<Triangle>& triangles, std::size_t begin, std::size_t end) {
    Part part;
    glm::dvec3 sum(0.0);
    for (std::size_t i = begin; i < end; ++i) {
        for (const glm::dvec3& corner : triangles[i].corners)
            part.box.extend(corner);
        sum += triangles[i].normal;
    }
    const double length = glm::length(sum);
    if (length > 0.0) part.normal = sum / length;
    part.lowest = std::numeric_limits<double>::infinity();
    part.highest = -part.lowest;
    for (std::size_t i = begin; i < end; ++i) {
        for (const glm::dvec3& corner : triangles[i].corners) {
            const glm::dvec3 offset = corner - part.centre();
            part.radius = std::max(part.radius, glm::length(offset));
            part.lowest = std::min(part.lowest, glm::dot(part.normal, offset));
            part.highest = std::max(part.highest, glm::dot(part.normal, offset));
        }
    }
    return part;
}

/// A surface as a binary tree over its list of triangles: a node is followed by its first half, then by its
/// second.
class SurfaceTree {
  public:
    SurfaceTree(const std::vector<Corners>& surface, double rounding)
        : triangles_(surface.begin(), surface.end()), rounding_(rounding) {
        parts_.reserve(2 * surface.size());
        add(0, surface.size());
    }

    /// @param visits counts down; the horizon is 1 when none is left
    double horizon_of(std::size_t triangle, std::uint64_t& visits) const {
        if (!triangles_[triangle].has_area()) return 0.0;
        Elevation elevation;
        raise(triangle, box_of(triangles_[triangle].corners), {0, 0, triangles_.size()}, elevation, visits);
        return elevation.bound > 0.0 ? elevation.bound + sine_rounding(triangles_[triangle]) : 0.0;
    }

  private:
    struct Elevation {
        double of_pairs = 0.0;  ///< greatest of those looked at
        double bound = 0.0;     ///< of all
    };
    struct Node {
        std::size_t index;
        std::size_t begin;
        std::size_t end;

        [[nodiscard]] std::size_t middle() const { return begin + (end - begin) / 2; }
        [[nodiscard]] Node first() const { return {index + 1, begin, middle()}; }
        [[nodiscard]] Node second() const { return {index + 2 * (middle() - begin), middle(), end}; }
    };

    void add(std::size_t begin, std::size_t end) {
        parts_.push_back(part_of(triangles_, begin, end));
        if (end - begin == 1) return;
        const std::size_t middle = begin + (end - begin) / 2;
        add(begin, middle);
        add(middle, end);
    }

    void raise(std::size_t triangle, const Box& around, const Node& node, Elevation& elevation,
               std::uint64_t& visits) const {
        const Triangle& ground = triangles_[triangle];
        const bool is_leaf = node.end - node.begin == 1;
        const std::uint64_t cost = is_leaf ? kVisitsOfAPair : 1;
        if (visits < cost) {
            elevation = {1.0, 1.0};
            return;
        }
        visits -= cost;
        if (is_leaf) {
            if (node.begin == triangle) return;
            elevation.of_pairs =
                std::max(elevation.of_pairs, elevation_of(ground, triangles_[node.begin], rounding_));
            elevation.bound = std::max(elevation.bound, elevation.of_pairs);
            return;
        }
        std::array<Node, 2> halves = {node.first(), node.second()};
        std::array<double, 2> bounds{};
        for (std::size_t i = 0; i < 2; ++i) {
            const Part& part = parts_[halves[i].index];
            const double height = part.height_over(ground);
            bounds[i] = height > 0.0 ? steepest(height, distance_between(around, part.box)) : 0.0;
        }
        if (bounds[1] > bounds[0]) {
            std::swap(halves[0], halves[1]);
            std::swap(bounds[0], bounds[1]);
        }
        for (std::size_t i = 0; i < 2; ++i) {
            if (bounds[i] > kCloseEnough * elevation.of_pairs) {
                raise(triangle, around, halves[i], elevation, visits);
            } else {
                elevation.bound = std::max(elevation.bound, bounds[i]);
            }
        }
    }

    std::vector<Triangle> triangles_;
    double rounding_;
    std::vector<Part> parts_;
};

}  // namespace

std::vector<float> self_horizons(const std::vector<Corners>& surface) {
    std::vector<float> horizons;
    if (surface.empty()) return horizons;
    const SurfaceTree tree(surface, rounding_of(surface));
    std::uint64_t visits = kMostHorizonVisits;
    for (std::size_t i = 0; i < surface.size(); ++i)
        horizons.push_back(static_cast<float>(std::min(1.0, tree.horizon_of(i, visits))));
    return horizons;
}

}  // namespace utsuri
