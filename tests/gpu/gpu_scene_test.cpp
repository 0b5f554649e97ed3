// SPDX-License-Identifier: Apache-2.0
// What it takes to keep a scene on the device as it is on the host: as many bytes as differ, and then it is
// as if it had always been so.
#include "renderers/device_scene/gpu_scene.h"

#include "renderers/device_scene/ray_list.h"
#include "renderers/device_scene/scene_buffers.h"
#include "renderers/device_scene/scene_change.h"
#include "renderers/methods/ray_tracer.h"
#include "support/scenes.h"
#include "support/test_device.h"

#include "base/sampler.h"

#include <glm/ext/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cstring>
#include <limits>

namespace utsuri::test {
namespace {

constexpr std::uint64_t kMebibyte = 1u << 20;
constexpr std::uint64_t kSmall = 64u << 10;

/// Some bytes without order.
Texture noise(std::uint32_t size, std::uint32_t seed) {
    Texture texture{"", size, size, std::vector<std::uint8_t>(std::size_t{4} * size * size)};
    std::uint32_t state = seed;
    for (std::uint8_t& byte : texture.rgba) {
        state = 1664525u * state + 1013904223u;  // Knuth's linear congruence; its high bits are the good ones
        byte = static_cast<std::uint8_t>(state >> 24);
    }
    return texture;
}

/// Textures of 100 MiB and one of 64 x 64 texels on quads, of which one shines; a large ball of 20480
/// triangles and a small one beside it, nowhere near the bounds of the scene, and a lamp.
constexpr std::uint32_t kSmallTexture = 4;
constexpr std::uint32_t kSmallBall = 6;
Scene make_textured_scene() {
    Scene scene;
    scene.textures = {noise(4096, 1), noise(2048, 2), noise(2048, 3), noise(1024, 4), noise(64, 5)};
    for (std::int32_t i = 0; i < 5; ++i) {
        Material material = i == 2 ? glossy_metal(1.0f) : lambert(glm::vec3(0.5f));
        if (i == 2) material.metallic_roughness_texture.texture = 3;
        if (i == 3) material = emitter(glm::vec3(1.0f), glm::vec3(0.5f));
        if (i == 3) material.emissive_texture.texture = i;
        material.base_colour_texture.texture = i;
        add(scene, quad({static_cast<float>(i), 0, 0}, {1, 0, 0}, {0, 3, 0}), material);
    }
    add(scene, icosphere({2.5f, 1.5f, 1.0f}, 1.0f, 5), lambert(glm::vec3(0.75f)));
    add(scene, icosphere({0.75f, 1.5f, 1.25f}, 0.25f, 2), lambert(glm::vec3(0.25f)));
    Light lamp;
    lamp.position = {2.0, 2.0, 3.0};
    lamp.intensity = glm::vec3(5.0f);
    scene.lights.push_back(lamp);
    return scene;
}

const Scene& textured_scene() {
    static const Scene scene = make_textured_scene();
    return scene;
}

class GpuSceneOnDevice : public DeviceTest {
  protected:
    GpuSceneOnDevice()
        : scene_(textured_scene()), data_(prepare_scene_data(scene_)), gpu_scene_(device(), data_) {}

    /// @returns bytes that were uploaded for it
    std::uint64_t follow() {
        change_ = update_scene_data(data_, scene_);
        return update();
    }
    std::uint64_t update() {
        const std::uint64_t before = device().uploaded_bytes();
        gpu_scene_.update(data_);
        return device().uploaded_bytes() - before;
    }

    /// Buffers are rounded up to whole texels.
    void expect_all_of_it(std::uint64_t uploaded) const {
        EXPECT_GE(uploaded, data_.device_bytes());
        EXPECT_LT(uploaded, data_.device_bytes() + kSceneBuffers * kTexelBytes);
    }

    static std::vector<std::byte> content(const Buffer& buffer) {
        std::vector<std::byte> bytes(buffer.size());
        buffer.download(bytes);
        return bytes;
    }

    void expect_as_if_made_of(const SceneData& data) {
        const GpuScene made(device(), data);
        const Bindings expected = made.bindings();
        EXPECT_EQ(gpu_scene_.bindings().size(), expected.size());
        for (const auto& [binding, buffer] : gpu_scene_.bindings())
            EXPECT_TRUE(content(*buffer) == content(*expected.at(binding))) << buffer->name();
        EXPECT_EQ(gpu_scene_.specialization(), made.specialization());
        EXPECT_EQ(gpu_scene_.max_depth(), made.max_depth());
        EXPECT_EQ(gpu_scene_.light_revision(), data_.light_revision);
    }

    static std::vector<glm::vec3> picture(const SceneData& data, const GpuScene& gpu_scene) {
        constexpr RenderSettings kSettings{16, 12, 3, 4};
        const auto tracer =
            make_tracer(device(), data, gpu_scene, look_at({2.5, 1.5, 6}, {2.5, 1.5, 0}), kSettings);
        Progress silent;
        tracer->prepare(silent);
        Film film(device(), kSettings.width, kSettings.height, "film");
        tracer->add_samples(film, 2, silent);
        return film.resolve().pixels;
    }

    /// Whether what is on the device looks as a scene that was always so, and not as before.
    void expect_new_picture(const std::vector<glm::vec3>& before) {
        const std::vector<glm::vec3> now = picture(data_, gpu_scene_);
        EXPECT_NE(now, before);
        const SceneData made = prepare_scene_data(scene_);
        EXPECT_EQ(now, picture(made, GpuScene(device(), made)));
    }

    Scene scene_;
    SceneData data_;
    GpuScene gpu_scene_;
    SceneChange change_;
};

TEST_F(GpuSceneOnDevice, UploadsAllOfItOnce) {
    EXPECT_GE(data_.device_bytes(), 100 * kMebibyte);
    const std::uint64_t before = device().uploaded_bytes();
    const GpuScene another(device(), data_);
    expect_all_of_it(device().uploaded_bytes() - before);
}

TEST_F(GpuSceneOnDevice, UploadsNothingWhereNothingChanged) {
    EXPECT_EQ(follow(), 0u);
    expect_as_if_made_of(data_);
}

TEST_F(GpuSceneOnDevice, UploadsAColourAlone) {
    const std::vector<glm::vec3> before = picture(data_, gpu_scene_);
    scene_.materials[0].base_colour = {0.25f, 0.5f, 0.75f};
    const std::uint64_t bytes = follow();
    EXPECT_GT(bytes, 0u);
    EXPECT_LE(bytes, sizeof(glm::vec3));
    expect_as_if_made_of(prepare_scene_data(scene_));
    expect_new_picture(before);
}

TEST_F(GpuSceneOnDevice, UploadsASmallTextureAlone) {
    const std::vector<glm::vec3> before = picture(data_, gpu_scene_);
    scene_.textures[kSmallTexture] = noise(64, 99);
    const std::uint64_t bytes = follow();
    EXPECT_GT(bytes, 0u);
    EXPECT_LE(bytes, scene_.textures[kSmallTexture].rgba.size());
    EXPECT_LT(bytes, kSmall);
    expect_as_if_made_of(prepare_scene_data(scene_));
    expect_new_picture(before);
}

// Its triangles, its vertices' normals, and a node for each of its triangles, which is more than it has:
// what may be uploaded. That much again is for the nodes above it and for what lies between.
TEST_F(GpuSceneOnDevice, UploadsTheShareOfWhatMoved) {
    const std::vector<glm::vec3> before = picture(data_, gpu_scene_);
    glm::dmat4& place = scene_.instances[kSmallBall].world_from_object;
    place = glm::rotate(glm::dmat4(1.0), -0.25, glm::dvec3(0, 0, 1));
    const std::uint64_t bytes = follow();
    const Mesh& ball = scene_.meshes[kSmallBall];
    const std::uint64_t share =
        ball.triangles.size() * (sizeof(interop::BvhTriangle) + sizeof(interop::BvhNode)) +
        ball.normals.size() * sizeof(glm::vec3);
    EXPECT_GT(bytes, ball.triangles.size() * sizeof(interop::BvhTriangle));
    EXPECT_LE(bytes, 2 * share);
    EXPECT_LT(2 * share, kMebibyte / 8);
    EXPECT_TRUE(change_.geometry);
    expect_as_if_made_of(data_);
    expect_new_picture(before);
}

TEST_F(GpuSceneOnDevice, ShowsRaysWhatMoved) {
    std::vector<interop::RayInfo> rays;
    for (std::uint32_t i = 0; i < 4096; ++i) {
        const glm::vec2 at = sample_2d(41, i, 0);
        rays.push_back({glm::vec3(5.0f * at.x, 3.0f * at.y, 4.0f) - glm::vec3(data_.origin),
                        {0, 0, -1},
                        std::numeric_limits<float>::infinity(),
                        interop::NONE});
    }
    RayList list(device(), gpu_scene_, RayQuery::closest_hit);
    list.upload(rays);
    list.trace();
    const std::vector<interop::HitInfo> before = list.hits();
    scene_.instances[kSmallBall].world_from_object =
        glm::translate(glm::dmat4(1.0), glm::dvec3(0.25, 0.25, 0.25));
    static_cast<void>(follow());
    list.trace();
    const std::vector<interop::HitInfo> hits = list.hits();
    const SceneData made = prepare_scene_data(scene_);
    EXPECT_EQ(made.origin, data_.origin);
    const GpuScene made_scene(device(), made);
    RayList anew(device(), made_scene, RayQuery::closest_hit);
    anew.upload(rays);
    anew.trace();
    const std::vector<interop::HitInfo> expected = anew.hits();
    int differ = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        ASSERT_EQ(hits[i].t, expected[i].t) << i;
        ASSERT_EQ(hits[i].triangle == interop::NONE, expected[i].triangle == interop::NONE);
        differ += hits[i].t != before[i].t ? 1 : 0;
        if (hits[i].triangle == interop::NONE) continue;
        ASSERT_EQ(data_.bvh.order[hits[i].triangle], made.bvh.order[expected[i].triangle]) << i;
    }
    EXPECT_GT(differ, 10);
}

TEST_F(GpuSceneOnDevice, IsRebuiltWhereALampGoesOut) {
    const std::vector<glm::vec3> before = picture(data_, gpu_scene_);
    scene_.lights.clear();
    const std::uint64_t bytes = follow();
    EXPECT_TRUE(change_.rebuilt);
    EXPECT_LT(bytes, kSmall) << "textures and geometry stay";
    expect_as_if_made_of(data_);
    expect_new_picture(before);
}

TEST_F(GpuSceneOnDevice, IsRebuiltWithOtherObjects) {
    const std::vector<glm::vec3> before = picture(data_, gpu_scene_);
    add(scene_, icosphere({3.5f, 1.5f, 1.25f}, 0.25f, 1), mirror());
    const std::uint64_t bytes = follow();
    EXPECT_TRUE(change_.rebuilt);
    EXPECT_LT(bytes, 8 * kMebibyte) << "textures stay";
    expect_as_if_made_of(data_);
    expect_new_picture(before);
}

TEST_F(GpuSceneOnDevice, IsRebuiltWithoutTexturesAndWithThem) {
    for (Material& material : scene_.materials)
        material.base_colour_texture = material.metallic_roughness_texture = material.emissive_texture = {};
    const std::uint64_t memory = device().memory().current;
    EXPECT_LT(follow(), kMebibyte);
    EXPECT_LE(device().memory().current + 100 * kMebibyte, memory);
    expect_as_if_made_of(data_);
    scene_ = textured_scene();
    EXPECT_GE(follow(), 100 * kMebibyte);
    expect_as_if_made_of(data_);
}

// As many texels, but elsewhere.
TEST_F(GpuSceneOnDevice, IsRebuiltWithTexturesOfOtherSizes) {
    std::swap(scene_.textures[0], scene_.textures[kSmallTexture]);
    const std::uint64_t bytes = follow();
    EXPECT_TRUE(change_.rebuilt);
    EXPECT_GE(bytes, 100 * kMebibyte);
    EXPECT_LT(bytes, 101 * kMebibyte);
    expect_as_if_made_of(prepare_scene_data(scene_));
}

// What changed since is not known from the last change alone.
TEST_F(GpuSceneOnDevice, UploadsAllAfterAChangeThatWasLeftOut) {
    scene_.materials[0].base_colour = {0.25f, 0.5f, 0.75f};
    static_cast<void>(update_scene_data(data_, scene_));
    scene_.materials[1].base_colour = {0.5f, 0.25f, 0.75f};
    expect_all_of_it(follow());
    expect_as_if_made_of(data_);
    EXPECT_EQ(follow(), 0u);
}

}  // namespace
}  // namespace utsuri::test
