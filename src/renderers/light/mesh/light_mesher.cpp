// SPDX-License-Identifier: Apache-2.0
#include "renderers/light/mesh/light_mesher.h"

#include "renderers/light/mesh/contact_cuts.h"
#include "renderers/light/mesh/packed_mesh.h"

#include "base/check.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace utsuri {
namespace {

/// Places darker than this share of the mean are held to what is tolerated there.
constexpr double kDarkestShare = 1.0 / 8.0;

/// Corners of a leaf may differ by this many tolerances while light is even between them: where they differ
/// more, a shadow may end beside the edge that is looked at.
constexpr double kMostSlope = 8.0;

/// What is no farther from a surface than this share of the coarsest distance touches it.
constexpr double kGap = 1.0 / 64.0;

/// What rounds alike in scenes that differ a little: meshes then differ only where light does.
double power_of_two_below(double value) {
    return value > 0.0 ? std::scalbn(1.0, std::ilogb(value)) : 0.0;
}

double largest(const glm::vec3& light) {
    return static_cast<double>(std::max({light.x, light.y, light.z}));
}

/// Light of one side of a leaf: at the ends of its longest edge, at the third corner, in the middle of the
/// edge.
struct LeafLight {
    std::array<glm::vec3, 3> corners;
    glm::vec3 middle;
};

/// How far the middle is from the mean of both ends, as a share of the light there, or how far corners
/// differ, as a share of what is usual.
double disagreement_of(const LeafLight& light, double mean) {
    const auto& [a, b, c] = light.corners;
    const double brightest = std::max({largest(a), largest(b), largest(c), largest(light.middle)});
    const double bend = largest(glm::abs(light.middle - 0.5f * (a + b)));
    const double slope = largest(glm::max(glm::max(a, b), c) - glm::min(glm::min(a, b), c));
    const double local = std::max(brightest, kDarkestShare * mean);
    if (local == 0.0) return 0.0;
    return std::max(bend / local, slope / (kMostSlope * std::max(brightest, mean)));
}

}  // namespace

MeshBytes predict_mesh_bytes(const SceneData& scene, const MeshSettings& settings) {
    const LightMesher mesher(scene, settings);
    const std::uint64_t points = mesher.places().size();
    const auto bytes = [&](std::uint64_t count) {
        const PackedBytes per_point = packed_bytes_per_point();
        return scene.triangle_infos.size() * sizeof(MeshTexel) + count * (per_point.nodes + per_point.sides);
    };
    return {bytes(points), bytes(std::min(points + settings.most_points, settings.room))};
}

LightMesher::LightMesher(const SceneData& scene, const MeshSettings& settings)
    : settings_(settings), mesh_(scene, settings.finest, settings.room) {
    cut_at_contacts(mesh_, scene, ContactFinder(scene, kGap * settings.coarsest), settings.finest,
                    settings.most_points);
    for (std::uint32_t leaf = 0; leaf < mesh_.leaves().size() && !mesh_.is_full(); ++leaf) {
        if (mesh_.can_split(leaf) && mesh_.longest_edge(mesh_.leaves()[leaf]).length > settings_.coarsest)
            mesh_.bisect(leaf);
    }
    mesh_.close();
    limit_ = std::min(settings.room, mesh_.places().size() + settings.most_points);
    make_tests();
}

std::span<const interop::LightMeshPlace> LightMesher::wanted() const {
    return std::span(mesh_.places()).subspan(light_.size());
}

void LightMesher::tell(std::span<const interop::LightMeshPoint> light) {
    UTSURI_CHECK_EQ(light.size(), wanted().size());
    light_.insert(light_.end(), light.begin(), light.end());
    if (!mean_) mean_ = power_of_two_below(mean_light());
    while (wanted().empty() && !tests_.empty())
        refine();
    expect();
}

void LightMesher::expect() {
    for (std::size_t point = light_.size(); point < mesh_.places().size(); ++point) {
        const auto [a, b] = mesh_.ends(static_cast<std::uint32_t>(point));
        if (std::max(a, b) >= light_.size()) continue;  // NONE, too
        mesh_.expect(static_cast<std::uint32_t>(point), light_[a].lit & light_[b].lit,
                     light_[a].dark & light_[b].dark);
    }
}

void LightMesher::make_tests() {
    struct Candidate {
        double area;
        std::uint32_t leaf;
        std::uint32_t edge;
    };
    std::vector<Candidate> candidates;
    for (; untested_ < mesh_.leaves().size(); ++untested_) {
        const MeshLeaf& leaf = mesh_.leaves()[untested_];
        const MeshTree::LongEdge longest = mesh_.longest_edge(leaf);
        const auto number = static_cast<std::uint32_t>(untested_);
        if (!mesh_.can_split(number) || longest.length <= settings_.finest) continue;
        candidates.push_back({mesh_.area(leaf), number, longest.edge});
    }
    // Where there is no room to test all, first where most of a picture may be wrong.
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.area > b.area; });
    for (const Candidate& candidate : candidates) {
        if (mesh_.places().size() >= limit_) break;
        tests_.push_back({candidate.leaf, candidate.edge, mesh_.midpoint(candidate.leaf, candidate.edge)});
    }
}

void LightMesher::refine() {
    for (const Test& test : tests_) {
        if (disagreement(test) > settings_.tolerance) mesh_.bisect(test.leaf);
    }
    mesh_.close();
    tests_.clear();
    make_tests();
}

double LightMesher::disagreement(const Test& test) const {
    const MeshLeaf& leaf = mesh_.leaves()[test.leaf];
    const auto at = [&](std::uint32_t corner) { return light_[leaf.points[(test.edge + corner) % 3]]; };
    const interop::LightMeshPoint& middle = light_[test.point];
    return std::max(disagreement_of({{at(0).front, at(1).front, at(2).front}, middle.front}, *mean_),
                    disagreement_of({{at(0).back, at(1).back, at(2).back}, middle.back}, *mean_));
}

double LightMesher::mean_light() const {
    double sum = 0.0;
    double area = 0.0;
    for (const MeshLeaf& leaf : mesh_.leaves()) {
        if (leaf.split) continue;
        const double size = mesh_.area(leaf);
        for (const std::uint32_t point : leaf.points)
            sum += size / 3.0 * std::max(largest(light_[point].front), largest(light_[point].back));
        area += size;
    }
    return area > 0.0 ? sum / area : 0.0;
}

LightMesh LightMesher::finish() const {
    LightMesh mesh;
    mesh.nodes = mesh_.nodes();
    std::vector<std::uint32_t> numbers(light_.size(), interop::NONE);
    for (MeshNode& node : mesh.nodes) {
        if (node.split != kMeshLeaf || node.points[0] == interop::NONE) continue;
        for (std::uint32_t& point : node.points) {
            std::uint32_t& number = numbers[point];
            if (number == interop::NONE) {
                number = static_cast<std::uint32_t>(mesh.points.size());
                mesh.points.push_back(light_[point]);
            }
            point = number;
        }
    }
    return mesh;
}

}  // namespace utsuri
