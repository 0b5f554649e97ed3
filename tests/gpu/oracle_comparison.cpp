// SPDX-License-Identifier: Apache-2.0
#include "gpu/oracle_comparison.h"

#include "renderers/device_scene/gpu_scene.h"
#include "renderers/device_scene/ray_list.h"
#include "support/embree_oracle.h"

#include "base/sampler.h"
#include "gpu/hit_judge.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace utsuri::test {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr unsigned kThreads = 2;
/// Failures to print in full.
constexpr int kMostExplanations = 3;

/// Numbers in [0, 1) by stream and index.
glm::vec3 uniform(std::uint32_t stream, std::uint32_t index) {
    return {sample_2d(stream, index, 0), sample_2d(stream, index, 1).x};
}

std::uint32_t pick(std::uint32_t stream, std::uint32_t index, std::size_t count) {
    return hash(hash(index) ^ stream) % static_cast<std::uint32_t>(count);
}

glm::vec3 point_in(const Bounds& bounds, std::uint32_t stream, std::uint32_t index) {
    return bounds.lower + uniform(stream, index) * bounds.extent();
}

interop::RayInfo ray(const glm::vec3& origin, const glm::vec3& direction) {
    return {origin, direction, kInfinity, interop::NONE};
}

/// From one point near a corner of the scene over a square picture.
RaySet camera_rays(const SceneData& data, std::uint32_t edge) {
    RaySet set{"camera", {}};
    const glm::vec3 eye = data.bounds.lower + glm::vec3(0.81f, 0.73f, 0.91f) * data.bounds.extent();
    const glm::vec3 forward = -0.5f * data.bounds.extent();
    for (std::uint32_t i = 0; i < edge * edge; ++i) {
        const glm::vec3 jitter = uniform(1, i);
        const float x = 2.0f * (static_cast<float>(i % edge) + jitter.x) / static_cast<float>(edge) - 1.0f;
        const float y = 2.0f * (static_cast<float>(i / edge) + jitter.y) / static_cast<float>(edge) - 1.0f;
        const glm::vec3 right = glm::cross(forward, glm::vec3(0, 1, 0));
        set.rays.push_back(
            ray(eye, glm::normalize(forward + x * right / glm::length(right) * glm::length(forward) +
                                    y * glm::length(forward) * glm::vec3(0, 1, 0))));
    }
    return set;
}

RaySet random_rays(const SceneData& data, std::uint32_t count) {
    RaySet set{"random", {}};
    for (std::uint32_t i = 0; i < count; ++i) {
        const glm::vec3 direction = 2.0f * uniform(3, i) - 1.0f;
        set.rays.push_back(
            ray(point_in(data.bounds, 2, i), direction == glm::vec3(0.0f) ? glm::vec3(1) : direction));
    }
    return set;
}

/// A node of the tree and a slot of it that holds something.
ChildBox some_box(const Bvh& bvh, std::uint32_t index) {
    const interop::BvhNode& node = bvh.nodes[pick(4, index, bvh.nodes.size())];
    for (std::uint32_t step = 0; step < interop::BVH_WIDTH; ++step) {
        const std::uint32_t slot = (index + step) % interop::BVH_WIDTH;
        const SlotContent content = slot_content(node, slot);
        if (content.is_node || content.triangle_count > 0) return child_box(node, slot);
    }
    return {};
}

/// The 26 directions of a cube's faces, edges and corners, some with negative zeroes.
RaySet axis_rays(const SceneData& data, std::uint32_t count) {
    RaySet set{"axis", {}};
    for (std::uint32_t i = 0; i < count; ++i) {
        glm::vec3 direction(0.0f);
        std::uint32_t code = 1 + pick(5, i, 26);
        if (code >= 14) ++code;  // 13 is the zero vector, and pick + 1 skips 0 = (-1, -1, -1): taken by 27
        code %= 27;
        for (int axis = 0; axis < 3; ++axis, code /= 3) {
            direction[axis] = static_cast<float>(static_cast<int>(code % 3) - 1);
            if (direction[axis] == 0.0f && (i & 1u) != 0) direction[axis] = -0.0f;
        }
        if (direction == glm::vec3(0.0f)) direction.x = 1.0f;
        glm::vec3 origin = point_in(data.bounds, 6, i);
        const ChildBox box = some_box(data.bvh, i);
        const int axis = static_cast<int>(i % 3);
        origin[axis] = static_cast<float>((i & 4u) != 0 ? box.lower[axis] : box.upper[axis]);
        set.rays.push_back(ray(origin, direction));
    }
    return set;
}

/// At points that several triangles share; every other one at a vertex.
RaySet edge_rays(const SceneData& data, std::uint32_t count) {
    RaySet set{"edges", {}};
    for (std::uint32_t i = 0; i < count; ++i) {
        const interop::BvhTriangle& triangle = data.bvh.triangles[pick(7, i, data.bvh.triangles.size())];
        const float along = (i & 1u) != 0 ? 0.0f : uniform(8, i).x;
        const glm::vec3 target = triangle.v0 + along * (triangle.v1 - triangle.v0);
        const glm::vec3 origin = point_in(data.bounds, 9, i);
        set.rays.push_back(ray(origin, target == origin ? glm::vec3(1, 0, 0) : target - origin));
    }
    return set;
}

struct Tally {
    int agree = 0;
    int exact = 0;
    int within_rounding = 0;
    int wrong = 0;
    int oracle_wrong = 0;
};

Tally compare(const Bvh& bvh, const RaySet& set, const std::vector<interop::HitInfo>& ours,
              const std::vector<interop::HitInfo>& theirs) {
    Tally tally;
    for (std::size_t i = 0; i < set.rays.size(); ++i) {
        std::string explanation;
        if (ours[i].triangle == theirs[i].triangle) {
            // What both find is there; what is left to see is that it is at the right distance.
            if (ours[i].triangle != interop::NONE) {
                const TriangleDecision own = decide(bvh.triangles[ours[i].triangle], set.rays[i]);
                const double difference = std::abs(static_cast<double>(ours[i].t) - own.t);
                if (!(difference <= own.t_error)) {
                    explanation = fmt::format("t = {} is not {} +- {}", ours[i].t, own.t, own.t_error);
                }
            }
            ++(explanation.empty() ? tally.agree : tally.wrong);
        } else {
            const Verdict verdict = judge(bvh, set.rays[i], ours[i], explanation);
            tally.exact += verdict == Verdict::exact ? 1 : 0;
            tally.within_rounding += verdict == Verdict::within_rounding ? 1 : 0;
            tally.wrong += verdict == Verdict::wrong ? 1 : 0;
            std::string oracle;
            if (judge(bvh, set.rays[i], theirs[i], oracle) == Verdict::wrong) ++tally.oracle_wrong;
        }
        if (!explanation.empty() && tally.wrong <= kMostExplanations) {
            const interop::RayInfo& r = set.rays[i];
            ADD_FAILURE() << fmt::format("{} ray {}, origin ({}, {}, {}), direction ({}, {}, {}): {}",
                                         set.kind, i, r.origin.x, r.origin.y, r.origin.z, r.direction.x,
                                         r.direction.y, r.direction.z, explanation);
        }
    }
    return tally;
}

}  // namespace

void compare_with_embree(Device& device, const Scene& scene) {
    const SceneData data = prepare_scene_data(scene);
    const GpuScene gpu_scene(device, data);
    const EmbreeOracle oracle(data.bvh.triangles, EmbreeOracle::Mode::robust);
    RayList list(device, gpu_scene, RayQuery::closest_hit);
    constexpr std::uint32_t kEdge = 320;
    constexpr std::uint32_t kFew = 1u << 15;
    const std::vector<RaySet> sets = {camera_rays(data, kEdge),
                                      random_rays(data, (1u << 18) - kEdge * kEdge - 2 * kFew),
                                      axis_rays(data, kFew), edge_rays(data, kFew)};
    for (const RaySet& set : sets) {
        list.upload(set.rays);
        list.trace();
        const Tally tally = compare(data.bvh, set, list.hits(), oracle.closest_hits(set.rays, kThreads));
        EXPECT_EQ(tally.wrong, 0) << set.kind << " rays that no rounding explains";
        const auto record = [&](const char* what, int value) {
            testing::Test::RecordProperty(fmt::format("{}_{}", set.kind, what), value);
        };
        record("agree", tally.agree);
        record("exact_against_oracle", tally.exact);
        record("within_rounding", tally.within_rounding);
        record("oracle_wrong", tally.oracle_wrong);
    }
}

}  // namespace utsuri::test
