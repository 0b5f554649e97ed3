// SPDX-License-Identifier: Apache-2.0
// From inside a closed mesh no ray gets out, however precisely it is aimed at edges and vertices.
#include "renderers/device_scene/ray_list.h"
#include "support/scenes.h"
#include "support/test_device.h"

#include "base/sampler.h"

#include <glm/geometric.hpp>

#include <limits>
#include <ostream>
#include <string>

namespace utsuri {
namespace {

constexpr std::uint32_t kRaysOfAKind = 100000;

struct Sphere {
    std::string name;
    int level;
    float radius;
    glm::vec3 centre;

    friend void PrintTo(const Sphere& sphere, std::ostream* stream) { *stream << sphere.name; }
};

/// A point within half the radius of the centre, in the coordinates of the scene.
glm::vec3 inner_point(const Sphere& sphere, const glm::vec3& centre, std::uint32_t i) {
    const glm::vec3 u(sample_2d(21, i, 0), sample_2d(21, i, 1).x);
    return centre + 0.5f * sphere.radius * (u - 0.5f);
}

class Watertight : public DeviceTest, public testing::WithParamInterface<Sphere> {
  protected:
    /// The sphere and, as far on the other side of the world's origin, a speck that keeps the scene's origin
    /// there.
    static Scene scene_with_counterweight() {
        const Sphere& sphere = GetParam();
        Scene scene;
        test::add(scene, test::icosphere(sphere.centre, sphere.radius, sphere.level), test::mirror());
        if (sphere.centre != glm::vec3(0.0f)) {
            test::add(scene, test::quad(-sphere.centre, {0.25f, 0, 0}, {0, 0.25f, 0}), test::mirror());
        }
        return scene;
    }
};

std::vector<interop::RayInfo> rays_from_inside(const Sphere& sphere, const SceneData& data,
                                               const glm::vec3& centre) {
    std::vector<interop::RayInfo> rays;
    for (std::uint32_t i = 0; i < 3 * kRaysOfAKind; ++i) {
        const glm::vec3 origin = inner_point(sphere, centre, i);
        glm::vec3 direction = 2.0f * glm::vec3(sample_2d(22, i, 0), sample_2d(22, i, 1).x) - 1.0f;
        if (i % 3 != 2) {
            std::uint32_t index = hash(i) % static_cast<std::uint32_t>(data.bvh.triangles.size());
            while (data.triangle_infos[index].instance != 0)
                index = (index + 1) % data.bvh.triangles.size();
            const interop::BvhTriangle& triangle = data.bvh.triangles[index];
            // Kind 0: along an edge; kind 1: at a vertex.
            const float along = i % 3 == 0 ? sample_2d(23, i, 0).x : 0.0f;
            direction = triangle.v0 + along * (triangle.v1 - triangle.v0) - origin;
        }
        if (direction == glm::vec3(0.0f)) direction = {1, 0, 0};
        rays.push_back({origin, direction, std::numeric_limits<float>::infinity(), interop::NONE});
    }
    return rays;
}

TEST_P(Watertight, LetsNoRayOut) {
    const Scene scene = scene_with_counterweight();
    const SceneData data = prepare_scene_data(scene);
    const glm::vec3 centre(glm::dvec3(GetParam().centre) - data.origin);
    const std::vector<interop::RayInfo> rays = rays_from_inside(GetParam(), data, centre);
    const GpuScene gpu_scene(device(), data);
    for (const RayQuery query : {RayQuery::closest_hit, RayQuery::any_hit}) {
        RayList list(device(), gpu_scene, query);
        list.upload(rays);
        list.trace();
        const std::vector<interop::HitInfo> hits = list.hits();
        int misses[3] = {0, 0, 0};
        for (std::size_t i = 0; i < hits.size(); ++i) {
            bool hit = hits[i].triangle != interop::NONE;
            if (hit && query == RayQuery::closest_hit)
                hit = data.triangle_infos[hits[i].triangle].instance == 0;
            misses[i % 3] += hit ? 0 : 1;
        }
        EXPECT_EQ(misses[0], 0) << "of " << kRaysOfAKind << " rays at edges";
        EXPECT_EQ(misses[1], 0) << "of " << kRaysOfAKind << " rays at vertices";
        EXPECT_EQ(misses[2], 0) << "of " << kRaysOfAKind << " rays anywhere";
    }
}

// Far out, float32 coordinates are 1/64 apart: the sphere is a crumpled but closed mesh.
const glm::vec3 kFar(148376.0f, 1234.0f, -223423.0f);

INSTANTIATE_TEST_SUITE_P(
    Spheres, Watertight,
    testing::Values(Sphere{"near_1280", 3, 1.0f, {0, 0, 0}}, Sphere{"near_20480", 5, 1.0f, {0, 0, 0}},
                    Sphere{"off_1280", 3, 1.0f, {7, -5, 3}}, Sphere{"far_1280", 3, 2.0f, kFar},
                    Sphere{"far_20480", 5, 2.0f, kFar}, Sphere{"tiny_1280", 3, 0x1p-20f, {0, 0, 0}},
                    Sphere{"huge_1280", 3, 0x1p20f, {0, 0, 0}}),
    [](const testing::TestParamInfo<Sphere>& sphere) { return sphere.param.name; });

}  // namespace
}  // namespace utsuri
