// SPDX-License-Identifier: Apache-2.0
#include "renderers/scene/scene_change.h"

#include "support/light_scenes.h"
#include "support/scenes.h"

#include "base/error.h"
#include "geometry/bvh_check.h"

#include <glm/ext/matrix_transform.hpp>
#include <gmock/gmock.h>

namespace utsuri::test {
namespace {

using testing::HasSubstr;

constexpr std::uint32_t kTriangles = 4;  // two to a quad

/// Two quads, one of them a lamp, and a point light.
Scene two_quads() {
    Scene scene;
    add(scene, quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), lambert(glm::vec3(0.5f)));
    add(scene, quad({0, 0, 4}, {1, 0, 0}, {0, 1, 0}), emitter(glm::vec3(3.0f)));
    Light point;
    point.position = {2, 2, 2};
    point.intensity = glm::vec3(1.0f);
    scene.lights.push_back(point);
    scene.environment = glm::vec3(0.1f);
    return scene;
}

std::vector<std::uint32_t> triangles_of(const SceneData& data, std::uint32_t instance) {
    std::vector<std::uint32_t> result;
    for (std::uint32_t t = 0; t < kTriangles; ++t) {
        if (data.triangle_infos[t].instance == instance) result.push_back(t);
    }
    return result;
}

class SceneChanges : public testing::Test {
  protected:
    SceneChange change() { return update_scene_data(data_, scene_); }

    Scene scene_ = two_quads();
    SceneData data_ = prepare_scene_data(scene_);
};

TEST_F(SceneChanges, AreNoneWhereNothingChanged) {
    EXPECT_TRUE(change().empty());
    EXPECT_EQ(data_.light_revision, 0u);
}

TEST_F(SceneChanges, AreTheTrianglesThatMoved) {
    const std::vector<std::uint32_t> moved = triangles_of(data_, 0);
    const SceneData before = data_;
    // Within the bounds of the scene, whose size tells how bright the surroundings are as a whole.
    scene_.instances[0].world_from_object = glm::translate(glm::dmat4(1.0), glm::dvec3(0, 0, 1));
    const SceneChange change = this->change();
    EXPECT_EQ(change.triangles, moved);
    EXPECT_TRUE(change.geometry);
    ASSERT_EQ(change.before.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        const interop::BvhTriangle& now = data_.bvh.triangles[moved[i]];
        EXPECT_EQ(change.before[i].v0, before.bvh.triangles[moved[i]].v0);
        EXPECT_EQ(now.v0, change.before[i].v0 + glm::vec3(0, 0, 1));
    }
    EXPECT_EQ(check_bvh(data_.bvh, kTriangles), "");
    EXPECT_EQ(data_.origin, before.origin);
    EXPECT_EQ(data_.light_revision, 1u);
}

TEST_F(SceneChanges, OfTransformsThatKeepVerticesAndTurnNormals) {
    for (glm::vec3& normal : scene_.meshes[0].normals)
        normal = {0, 0.6f, 0.8f};
    const SceneChange change = this->change();
    EXPECT_EQ(change.triangles, triangles_of(data_, 0));
    EXPECT_TRUE(change.geometry);
}

TEST_F(SceneChanges, OfColoursLeaveLightAlone) {
    scene_.materials[0].base_colour = {1, 0, 0};
    const SceneChange change = this->change();
    EXPECT_EQ(change.triangles, triangles_of(data_, 0));
    EXPECT_FALSE(change.geometry);
    EXPECT_FALSE(change.lights);
    EXPECT_EQ(data_.light_revision, 0u);
}

TEST_F(SceneChanges, OfWhatIsDiffuseChangeLight) {
    scene_.materials[0].base_colour = glm::vec3(0.0f);
    EXPECT_TRUE(change().lights);
    EXPECT_EQ(data_.light_revision, 1u);
}

TEST_F(SceneChanges, OfLightsAreTold) {
    scene_.lights[0].position.x = 3.0;
    SceneChange change = this->change();
    EXPECT_TRUE(change.triangles.empty());
    EXPECT_TRUE(change.lights);
    EXPECT_FALSE(change.surroundings);
    EXPECT_EQ(data_.light_revision, 1u);

    scene_.environment = glm::vec3(0.2f);
    change = this->change();
    EXPECT_TRUE(change.surroundings);
    EXPECT_EQ(data_.light_revision, 2u);

    scene_.materials[1].emissive = glm::vec3(4.0f);
    change = this->change();
    EXPECT_EQ(change.triangles, triangles_of(data_, 1));
    EXPECT_TRUE(change.lights);
    EXPECT_FALSE(change.surroundings);
}

TEST_F(SceneChanges, ThatNeedAnotherRendererAreRefused) {
    const auto problem = [&](const auto& spoil) {
        Scene scene = two_quads();
        spoil(scene);
        try {
            static_cast<void>(update_scene_data(data_, scene));
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string("none");
    };
    EXPECT_THAT(problem([](Scene& s) { s.lights[0].intensity = glm::vec3(0.0f); }),
                HasSubstr("it now has 3 lights that shine where it had 4; prepare it anew"));
    EXPECT_THAT(problem([](Scene& s) {
                    s.environment = glm::vec3(0.0f);
                    s.lights.push_back(s.lights[0]);
                }),
                HasSubstr("its surroundings were switched on or off"));
    EXPECT_THAT(problem([](Scene& s) { s.materials[0] = mirror(); }), HasSubstr("it became rough, a mirror"));
    EXPECT_THAT(problem([](Scene& s) { s.meshes[0] = icosphere(glm::vec3(0), 1, 1); }),
                HasSubstr("it now has 82 triangles where it had 4"));
    EXPECT_THAT(problem([](Scene& s) { s.instances[0].material = 1; }), HasSubstr("lights that shine"));
    EXPECT_THAT(problem([](Scene& s) {
                    add(s, quad({0, 0, 9}, {1, 0, 0}, {0, 1, 0}), mirror());
                }),
                HasSubstr("it now has 6 triangles"));
    EXPECT_TRUE(change().empty()) << "and leave the data as they were";
}

}  // namespace
}  // namespace utsuri::test
