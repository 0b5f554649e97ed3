// SPDX-License-Identifier: Apache-2.0
#include "renderers/device_scene/scene_triangles.h"

#include "renderers/device_scene/scene_change.h"
#include "support/scenes.h"

#include <glm/ext/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <vector>

namespace utsuri::test {
namespace {

/// A ball, an instance without triangles, a wall, and the ball again: triangles of the two balls take turns
/// in device order.
Scene balls_and_a_wall() {
    Scene scene;
    add(scene, icosphere({0, 0, 0}, 1.0f, 2), mirror());
    add(scene, Mesh(), lambert(glm::vec3(0.5f)));
    add(scene, quad({-3, -3, -3}, {6, 0, 0}, {0, 6, 0}), lambert(glm::vec3(0.5f)));
    scene.instances.push_back(scene.instances[0]);
    scene.instances[3].world_from_object = glm::translate(glm::dmat4(1.0), glm::dvec3(0.01, 0, 0));
    return scene;
}

void expect_all_triangles(const SceneData& data) {
    std::vector<std::vector<std::uint32_t>> scanned(data.requirements.instances);
    for (std::uint32_t t = 0; t < data.triangle_infos.size(); ++t)
        scanned[data.triangle_infos[t].instance].push_back(t);
    for (std::uint32_t i = 0; i < scanned.size(); ++i) {
        const std::span<const std::uint32_t> triangles = triangles_of(data, i);
        EXPECT_EQ(std::vector(triangles.begin(), triangles.end()), scanned[i]) << "instance " << i;
        Bounds bounds;
        for (const std::uint32_t t : scanned[i])
            bounds.extend(bounds_of(data.bvh.triangles[t]));
        EXPECT_EQ(bounds_of(data, i).lower, bounds.lower) << "instance " << i;
        EXPECT_EQ(bounds_of(data, i).upper, bounds.upper) << "instance " << i;
    }
}

TEST(SceneTriangles, AreThoseOfTheirInstance) {
    const SceneData data = prepare_scene_data(balls_and_a_wall());
    expect_all_triangles(data);
    EXPECT_EQ(triangles_of(data, 0).size(), 320u);
    EXPECT_TRUE(triangles_of(data, 1).empty());
    EXPECT_EQ(triangles_of(data, 2).size(), 2u);
}

TEST(SceneTriangles, AreThoseOfTheirInstanceAfterEachChange) {
    Scene scene = balls_and_a_wall();
    SceneData data = prepare_scene_data(scene);
    const auto follow = [&](const char* what, bool rebuilds) {
        SCOPED_TRACE(what);
        EXPECT_EQ(update_scene_data(data, scene).rebuilt, rebuilds);
        expect_all_triangles(data);
    };
    scene.materials[1].base_colour = {1, 0, 0};
    follow("a colour", false);
    scene.instances[0].world_from_object = glm::translate(glm::dmat4(1.0), glm::dvec3(0, 1, 0));
    follow("a ball that moved", false);
    scene.meshes[2].normals[0] = {0, 0.6f, 0.8f};
    follow("a normal", false);
    scene.instances.push_back(scene.instances[2]);
    follow("one more wall", true);
    scene.instances.erase(scene.instances.begin());
    follow("a ball less", true);
    scene.instances.clear();
    follow("nothing", true);
}

// The plate of two triangles becomes two of one each: the same vertices, joined in the same way.
TEST(SceneTriangles, AreThoseOfInstancesThatWereParted) {
    Scene scene;
    add(scene, quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), lambert(glm::vec3(0.5f)));
    Mesh& whole = scene.meshes[0];
    whole.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {3, 0, 0}, {2, 1, 0}};
    whole.normals.assign(6, {0, 0, 1});
    whole.texcoords.clear();
    whole.triangles = {{0, 1, 2}, {3, 4, 5}};
    SceneData data = prepare_scene_data(scene);
    EXPECT_EQ(triangles_of(data, 0).size(), 2u);

    Mesh part = whole;
    part.positions.erase(part.positions.begin(), part.positions.begin() + 3);
    part.normals.resize(3);
    part.triangles = {{0, 1, 2}};
    whole.positions.resize(3);
    whole.normals.resize(3);
    whole.triangles.resize(1);
    add(scene, part, lambert(glm::vec3(0.5f)));
    scene.materials.pop_back();
    scene.instances[1].material = 0;
    EXPECT_EQ(update_scene_data(data, scene).reason, "it now has 2 instances where it had 1");
    expect_all_triangles(data);
    EXPECT_EQ(triangles_of(data, 1).size(), 1u);
}

}  // namespace
}  // namespace utsuri::test
