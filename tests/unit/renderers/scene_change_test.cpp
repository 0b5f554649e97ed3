// SPDX-License-Identifier: Apache-2.0
#include "renderers/device_scene/scene_change.h"

#include "renderers/device_scene/scene_buffers.h"
#include "support/light_scenes.h"
#include "support/scenes.h"

#include "geometry/bvh_check.h"

#include <glm/ext/matrix_transform.hpp>
#include <gmock/gmock.h>

#include <algorithm>
#include <array>

namespace utsuri::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

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

Texture plain_texture(std::uint32_t width, std::uint32_t height, std::uint8_t value) {
    return {"", width, height, std::vector<std::uint8_t>(std::size_t{4} * width * height, value)};
}

/// The quads with a texture each for their colours; that of the lamp is what it sends out, too.
Scene textured_quads() {
    Scene scene = two_quads();
    scene.textures = {plain_texture(64, 64, 10), plain_texture(32, 16, 20)};
    scene.materials[0].base_colour_texture.texture = 0;
    scene.materials[1].base_colour_texture.texture = 1;
    scene.materials[1].emissive_texture.texture = 1;
    return scene;
}

/// Of data whose triangles have the same numbers.
void expect_same_buffers(const SceneData& a, const SceneData& b) {
    const auto buffers_a = scene_buffers(a);
    const auto buffers_b = scene_buffers(b);
    for (std::size_t i = 0; i < kSceneBuffers; ++i) {
        EXPECT_TRUE(std::equal(buffers_a[i].bytes.begin(), buffers_a[i].bytes.end(),
                               buffers_b[i].bytes.begin(), buffers_b[i].bytes.end()))
            << buffers_a[i].name;
    }
    EXPECT_EQ(a.origin, b.origin);
    EXPECT_EQ(a.bounds.lower, b.bounds.lower);
    EXPECT_EQ(a.bounds.upper, b.bounds.upper);
    EXPECT_EQ(a.bvh.order, b.bvh.order);
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

/// A triangle of the scene by what it is made of, whatever its number: its corners, and their normals.
using Corners = std::array<float, 18>;
std::vector<Corners> sorted_corners(const SceneData& data) {
    std::vector<Corners> result;
    for (std::size_t t = 0; t < data.triangle_infos.size(); ++t) {
        const interop::BvhTriangle& triangle = data.bvh.triangles[t];
        Corners corners;
        auto next = corners.begin();
        for (const glm::vec3& place : {triangle.v0, triangle.v1, triangle.v2})
            next = std::copy_n(&place.x, 3, next);
        for (int corner = 0; corner < 3; ++corner)
            next = std::copy_n(&data.normals[data.triangle_infos[t].vertices[corner]].x, 3, next);
        result.push_back(corners);
    }
    std::sort(result.begin(), result.end());
    return result;
}

// Places and normals: a normal that was left behind would be found where things turn, not where they move.
TEST_F(SceneChanges, OfThingsThatTurnLeaveWhatANewSceneHas) {
    // Walls that stay where they are: scene space is about the middle of all.
    add(scene_, room({-4, -4, -4}, {8, 8, 8}), lambert(glm::vec3(0.5f)));
    data_ = prepare_scene_data(scene_);
    const glm::dmat4 turned = glm::rotate(glm::dmat4(1.0), 0.3, glm::normalize(glm::dvec3(1, 2, 3))) *
                              glm::scale(glm::dmat4(1.0), {0.5, 0.75, 1.0});
    scene_.instances[0].world_from_object = glm::translate(glm::dmat4(1.0), glm::dvec3(0, 0.25, 1)) * turned;
    EXPECT_TRUE(change().geometry);
    EXPECT_EQ(check_bvh(data_.bvh, data_.triangle_infos.size()), "");
    const SceneData anew = prepare_scene_data(scene_);
    ASSERT_EQ(data_.origin, anew.origin);
    EXPECT_EQ(sorted_corners(data_), sorted_corners(anew));
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
    EXPECT_FALSE(change.environment);
    EXPECT_EQ(data_.light_revision, 1u);

    scene_.environment = glm::vec3(0.2f);
    change = this->change();
    EXPECT_TRUE(change.environment);
    EXPECT_EQ(data_.light_revision, 2u);

    scene_.materials[1].emissive = glm::vec3(4.0f);
    change = this->change();
    EXPECT_EQ(change.triangles, triangles_of(data_, 1));
    EXPECT_TRUE(change.lights);
    EXPECT_FALSE(change.environment);
}

TEST_F(SceneChanges, OfWhatIsMadeFromTheSceneRebuildIt) {
    const auto reason = [](const auto& spoil) {
        Scene scene = two_quads();
        SceneData data = prepare_scene_data(scene);
        spoil(scene);
        const SceneChange change = update_scene_data(data, scene);
        EXPECT_EQ(change.rebuilt, !change.reason.empty());
        EXPECT_FALSE(change.empty());
        EXPECT_TRUE(change.geometry && change.lights && change.environment);
        EXPECT_THAT(change.triangles, IsEmpty());
        EXPECT_EQ(data.light_revision, 2u) << "light of one change before is never taken for it";
        expect_same_buffers(data, prepare_scene_data(scene));
        return change.reason;
    };
    EXPECT_EQ(reason([](Scene& s) { s.lights[0].intensity = glm::vec3(0.0f); }),
              "it now has 3 lights that shine where it had 4");
    EXPECT_EQ(reason([](Scene& s) {
                  s.environment = glm::vec3(0.0f);
                  s.materials[1].emissive = glm::vec3(0.0f);
              }),
              "it now has 1 light that shines where it had 4");
    EXPECT_EQ(reason([](Scene& s) {
                  s.environment = glm::vec3(0.0f);
                  s.lights.push_back(s.lights[0]);
              }),
              "its environment was switched on or off");
    EXPECT_THAT(reason([](Scene& s) { s.materials[0] = mirror(); }), HasSubstr("it became glossy, a mirror"));
    EXPECT_EQ(reason([](Scene& s) { s.meshes[0] = icosphere(glm::vec3(0), 1, 1); }),
              "it now has 82 triangles where it had 4");
    EXPECT_THAT(reason([](Scene& s) { s.instances[0].material = 1; }), HasSubstr("lights that shine"));
    EXPECT_EQ(reason([](Scene& s) {
                  add(s, quad({0, 0, 9}, {1, 0, 0}, {0, 1, 0}), mirror());
              }),
              "it now has 6 triangles where it had 4");
    EXPECT_EQ(reason([](Scene& s) { s.instances.pop_back(); }), "it now has 2 triangles where it had 4");
    EXPECT_EQ(reason([](Scene& s) { s.instances.clear(); }), "it now has 0 triangles where it had 4");
    EXPECT_EQ(reason([](Scene& s) { s.instances[0].world_from_object[0][0] = -1.0; }),
              "instances have other meshes or materials")
        << "mirrored, its triangles are wound the other way round";
}

TEST_F(SceneChanges, ThatRebuildWithoutTouchingGeometryKeepTheBvh) {
    const interop::BvhNode* const nodes = data_.bvh.nodes.data();
    scene_.lights[0].intensity = glm::vec3(0.0f);
    scene_.materials[0] = mirror();
    EXPECT_TRUE(change().rebuilt);
    EXPECT_EQ(data_.bvh.nodes.data(), nodes) << "not even copied";
    EXPECT_EQ(data_.build_seconds, 0.0);
}

// As many triangles, of which each is another: a refitted BVH would hold together what is far apart.
TEST_F(SceneChanges, OfTrianglesThatJoinOtherVerticesBuildTheBvhAnew) {
    scene_.meshes[0] = icosphere(glm::vec3(0), 1, 1);
    data_ = prepare_scene_data(scene_);
    std::reverse(scene_.meshes[0].triangles.begin(), scene_.meshes[0].triangles.end());
    EXPECT_EQ(change().reason, "instances have other meshes or materials");
    EXPECT_EQ(check_bvh(data_.bvh, data_.bvh.triangles.size()), "");
    expect_same_buffers(data_, prepare_scene_data(scene_));
}

TEST_F(SceneChanges, OfMaterialsOfInstancesRebuild) {
    scene_.materials.push_back(lambert(glm::vec3(0.25f)));
    EXPECT_TRUE(change().rebuilt);
    scene_.instances[0].material = 2;
    EXPECT_EQ(change().reason, "instances have other meshes or materials");
    EXPECT_EQ(data_.triangle_infos[triangles_of(data_, 0)[0]].material, 2u);
    expect_same_buffers(data_, prepare_scene_data(scene_));
}

// The depth of chains is kept where it cannot have changed, and found again where it can.
TEST_F(SceneChanges, LeaveTheMaxDepthThatTheSceneRequires) {
    add(scene_, quad({3, 0, 9}, {1, 0, 0}, {0, 1, 0}), mirror());
    scene_.instances.push_back(scene_.instances[2]);
    scene_.instances[3].world_from_object = glm::translate(glm::dmat4(1.0), glm::dvec3(2, 0, 0));
    data_ = prepare_scene_data(scene_);
    const auto depth_after = [&](const auto& alter) {
        alter(scene_);
        static_cast<void>(change());
        EXPECT_EQ(data_.requirements.max_depth, find_requirements(scene_).max_depth);
        return data_.requirements.max_depth;
    };
    EXPECT_EQ(depth_after([](Scene& s) { s.materials[2].base_colour = {1, 0, 0}; }), 1u);
    EXPECT_EQ(depth_after([](Scene& s) { s.instances[0].material = 2; }), kUnboundedDepth)
        << "a mirror in another plane, of materials that stay as they are";
    EXPECT_EQ(depth_after([](Scene& s) { s.instances[0].material = 0; }), 1u);
    EXPECT_EQ(depth_after([](Scene& s) { s.materials[0] = glossy_metal(0.5f); }), kUnboundedDepth);
    EXPECT_EQ(depth_after([](Scene& s) { s.materials[0] = lambert(glm::vec3(0.5f)); }), 1u);
    EXPECT_EQ(depth_after([](Scene& s) { s.instances[3].world_from_object[3][2] = 1.0; }), kUnboundedDepth);
    EXPECT_EQ(depth_after([](Scene& s) { s.instances[3].world_from_object[3][2] = 0.0; }), 1u);
    EXPECT_EQ(depth_after([](Scene& s) { s.instances.resize(2); }), 0u);
}

TEST_F(SceneChanges, ThatRebuildLeaveASceneThatIsFollowedOn) {
    add(scene_, quad({0, 0, 9}, {1, 0, 0}, {0, 1, 0}), lambert(glm::vec3(0.25f)));
    EXPECT_TRUE(change().rebuilt);
    EXPECT_TRUE(change().empty());
    scene_.materials[2].base_colour = glm::vec3(0.75f);
    EXPECT_THAT(change().triangles, SizeIs(2));
    EXPECT_EQ(data_.light_revision, 2u);
    EXPECT_EQ(data_.revision, 3u);
    expect_same_buffers(data_, prepare_scene_data(scene_));
}

class ChangedTextures : public SceneChanges {
  protected:
    ChangedTextures() {
        scene_ = textured_quads();
        data_ = prepare_scene_data(scene_);
    }
};

TEST_F(ChangedTextures, AreToldByTheTrianglesThatShowThem) {
    const std::uint32_t* const texels = data_.texels.data();
    scene_.textures[0].rgba[100] = 11;
    const SceneChange change = this->change();
    EXPECT_FALSE(change.rebuilt);
    EXPECT_EQ(change.triangles, triangles_of(data_, 0));
    EXPECT_FALSE(change.geometry || change.lights);
    EXPECT_EQ(data_.texels.data(), texels) << "written in place";
    expect_same_buffers(data_, prepare_scene_data(scene_));
}

TEST_F(ChangedTextures, OfLampsChangeLights) {
    scene_.textures[1].rgba.assign(scene_.textures[1].rgba.size(), 200);
    const SceneChange change = this->change();
    EXPECT_EQ(change.triangles, triangles_of(data_, 1));
    EXPECT_TRUE(change.lights);
    expect_same_buffers(data_, prepare_scene_data(scene_));
}

TEST_F(ChangedTextures, AreGoneThroughAgainForWhatTheSceneRequires) {
    scene_.materials[0] = glossy_metal(1.0f);
    scene_.materials[0].metallic_roughness_texture.texture = 0;
    data_ = prepare_scene_data(scene_);
    EXPECT_TRUE(data_.requirements.surfaces[0].glossy);
    EXPECT_FALSE(data_.requirements.surfaces[0].mirror);
    scene_.textures[0].rgba[4 * 17 + 1] = 0;  // green, the roughness of a texel
    EXPECT_THAT(change().reason, HasSubstr("it became glossy, a mirror"));
    EXPECT_TRUE(data_.requirements.surfaces[0].mirror);
    expect_same_buffers(data_, prepare_scene_data(scene_));
}

// Two of one size: their places among the texels stay, what is in them does not.
TEST_F(ChangedTextures, MayBeExchanged) {
    scene_.textures.push_back(plain_texture(64, 64, 30));
    scene_.materials[0].base_colour_texture.texture = 2;
    EXPECT_FALSE(change().rebuilt);
    expect_same_buffers(data_, prepare_scene_data(scene_));
    scene_.materials[0].base_colour_texture.texture = 0;
    EXPECT_THAT(change().triangles, SizeIs(2));
    expect_same_buffers(data_, prepare_scene_data(scene_));
}

TEST_F(ChangedTextures, OfOtherSizesRebuild) {
    scene_.textures[1] = plain_texture(16, 32, 20);
    EXPECT_EQ(change().reason, "its textures have other sizes");
    expect_same_buffers(data_, prepare_scene_data(scene_));
    scene_.materials[0].base_colour_texture = {};
    EXPECT_EQ(change().reason, "it now has 1 texture where it had 2");
    expect_same_buffers(data_, prepare_scene_data(scene_));
    scene_.materials[1].base_colour_texture = scene_.materials[1].emissive_texture = {};
    EXPECT_TRUE(change().rebuilt);
    EXPECT_THAT(data_.texcoords, IsEmpty());
    expect_same_buffers(data_, prepare_scene_data(scene_));
    scene_.materials[0].base_colour_texture.texture = 0;
    EXPECT_TRUE(change().rebuilt);
    expect_same_buffers(data_, prepare_scene_data(scene_));
}

TEST_F(ChangedTextures, ThatArePutOnOtherwiseAreTold) {
    scene_.meshes[0].texcoords[2] = {0.5f, 0.5f};
    const SceneChange change = this->change();
    EXPECT_EQ(change.triangles, triangles_of(data_, 0));
    EXPECT_FALSE(change.geometry || change.lights || change.rebuilt);
    expect_same_buffers(data_, prepare_scene_data(scene_));
}

TEST_F(SceneChanges, OfTexcoordsWithoutTexturesAreNone) {
    scene_.meshes[0].texcoords[2] = {0.5f, 0.5f};
    EXPECT_TRUE(change().empty());
}

// What GpuScene::update() uploads.
TEST_F(ChangedTextures, TellTheBytesThatDiffer) {
    const auto ranges_after = [&](const auto& alter) {
        alter(scene_);
        const SceneData before = data_;
        static_cast<void>(change());
        const auto then = scene_buffers(before);
        const auto now = scene_buffers(data_);
        std::size_t bytes = 0;
        for (std::size_t i = 0; i < kSceneBuffers; ++i) {
            EXPECT_EQ(data_.changed_bytes[i],
                      (ChangedBytes{false, differing_ranges(then[i].bytes, now[i].bytes)}))
                << now[i].name;
            for (const ByteRange& range : data_.changed_bytes[i].ranges)
                bytes += range.size;
        }
        return bytes;
    };
    EXPECT_EQ(ranges_after([](Scene&) {}), 0u);
    const std::size_t of_colour = ranges_after([](Scene& s) { s.materials[0].base_colour = {0, 1, 0}; });
    EXPECT_GT(of_colour, 0u);
    EXPECT_LE(of_colour, sizeof(glm::vec3));
    EXPECT_EQ(ranges_after([](Scene& s) { s.textures[1].rgba[7] = 1; }), 1u);
    EXPECT_GT(ranges_after([](Scene& s) { s.instances[0].world_from_object[3][2] = 1.0; }), 0u);
    EXPECT_GT(ranges_after([](Scene& s) { s.meshes[0].normals[0] = {0, 0.6f, 0.8f}; }), 0u);
    EXPECT_GT(ranges_after([](Scene& s) { s.meshes[0].texcoords[0] = {0.25f, 0.5f}; }), 0u);
    EXPECT_GT(ranges_after([](Scene& s) { s.lights[0].intensity *= 2.0f; }), 0u);
}

}  // namespace
}  // namespace utsuri::test
