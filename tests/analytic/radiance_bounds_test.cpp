// SPDX-License-Identifier: Apache-2.0
// Bounds on the radiance that capture points see, beside the distances that are measured by the same rays.
#include "renderers/reflection/distances/radiance_bounds.h"

#include "renderers/reflection/distances/distance_levels.h"
#include "renderers/reflection/distances/distance_maps.h"
#include "support/light_scenes.h"
#include "support/methods.h"
#include "support/test_device.h"

#include <glm/ext/matrix_transform.hpp>

namespace utsuri::test {
namespace {

constexpr std::uint32_t kSize = 64;
const glm::vec3 kDim(0.25f, 0.5f, 0.125f);
const glm::vec3 kBright(2.0f, 4.0f, 8.0f);
/// As lib/cube.glsl numbers faces.
constexpr std::uint32_t kTowardsPlusX = 0;

std::vector<interop::ProbeInfo> probe_at(const glm::vec3& capture_point) {
    interop::ProbeInfo probe{};
    probe.capture_point = capture_point;
    return {probe};
}

/// The distances and the bounds of one capture point of the first instance.
struct Measured {
    DistanceMaps distances;
    RadianceBounds bounds;

    Measured(Device& device, const SceneData& data, const glm::vec3& capture_point)
        : distances(device, data, {0}, probe_at(capture_point), kSize, Tolerance::Of::radiance),
          bounds(device, distances.faces()) {}

    void capture(const GpuScene& scene, const SurfaceLight& light) {
        Progress silent;
        double compile_seconds = 0.0;
        distances.capture(scene, compile_seconds, silent);
        bounds.capture(scene, light, compile_seconds, silent);
    }
};

class RadianceBoundsOf : public DeviceTest {
  protected:
    static constexpr LightSettings kCoarse = evenly_kept(1.0 / 10.0, 1, 0);
};

// A plate far from the face towards +x moves: what bounded that face is as it was, in all its blocks.
TEST_F(RadianceBoundsOf, FacesThatAChangeCannotReachStay) {
    Scene scene;
    add(scene, icosphere({0, 0, 0}, 0.5f, 1), mirror());
    add(scene, room({-3, -3, -3}, {3, 3, 3}), emitter(kDim));
    add(scene, quad({-2.9f, -0.5f, -0.5f}, {0, 1, 0}, {0, 0, 1}), emitter(kBright));
    // Along the edge of the face, where its first blocks are.
    add(scene, quad({2.9f, 2.0f, -2.9f}, {0, 0, 5.8f}, {0, 0.9f, 0}), emitter(kBright));
    add(scene, quad({2.9f, -2.9f, -2.9f}, {0, 0, 5.8f}, {0, 0.9f, 0}), emitter(kBright));
    SceneData data = prepare_scene_data(scene);
    GpuScene gpu_scene(device(), data);
    KeptLight light = kept_light(device(), data, gpu_scene, kCoarse);
    Progress silent;
    light.get()->fill(silent);
    Measured before(device(), data, glm::vec3(-data.origin));
    before.capture(gpu_scene, *light.get());

    glm::dmat4& place = scene.instances[2].world_from_object;
    place = glm::translate(glm::dmat4(1.0), {0.0, 0.25, 0.0}) * place;
    const SceneChange change = update_scene_data(data, scene);
    gpu_scene.update(data);
    light.update(change, silent);
    const SeenChanges changes(data, change, light.get()->changed());
    Measured after(device(), data, glm::vec3(-data.origin));
    after.distances.reuse_from(before.distances);
    after.bounds.reuse_from(before.bounds);
    after.distances.forget(changes);
    after.bounds.forget(changes);
    after.capture(gpu_scene, *light.get());

    Measured anew(device(), data, glm::vec3(-data.origin));
    anew.capture(gpu_scene, *light.get());
    for (std::uint32_t face = 0; face < interop::DISTANCE_FACES; ++face) {
        for (std::uint32_t level = 0; level < bound_levels(kSize); ++level)
            EXPECT_EQ(after.bounds.blocks(0, face, level), anew.bounds.blocks(0, face, level))
                << "face " << face << ", level " << level;
    }
}

// A frame stands out from a mirror by less than any ray of a texel would see: it is measured by rays that are
// lifted to just before the mirror's plane. What they meet is as bright as the frame, not as what is behind
// the mirror.
TEST_F(RadianceBoundsOf, FramesOfPlaneMirrorsCount) {
    Scene scene;
    constexpr float kHigh = 2e-3f;  // metres: of a texel, which is 3 cm wide there, a fifteenth
    add(scene, quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), mirror());
    add(scene, quad({1.001f, -1, 0}, {0, 0, kHigh}, {0, 2, 0}), emitter(kBright));
    add(scene, room({-3, -3, -2}, {3, 3, 4}), emitter(kDim));
    const SceneData data = prepare_scene_data(scene);
    const GpuScene gpu_scene(device(), data);
    KeptLight light = kept_light(device(), data, gpu_scene, kCoarse);
    Progress silent;
    light.get()->fill(silent);
    Measured measured(device(), data, glm::vec3(-data.origin));
    measured.capture(gpu_scene, *light.get());
    const auto samples = measured.distances.samples(0, kTowardsPlusX);
    const auto blocks = measured.bounds.blocks(0, kTowardsPlusX, 0);
    constexpr std::uint32_t kStride = kSize + 2 * interop::DISTANCE_BORDER;
    std::size_t frames = 0;
    for (std::uint32_t y = 0; y < kSize; ++y) {
        for (std::uint32_t x = 0; x < kSize; ++x) {
            const float distance =
                samples[(y + interop::DISTANCE_BORDER) * kStride + x + interop::DISTANCE_BORDER].centre;
            // The frame is at most sqrt(2) away, the room 3.
            if (!(distance > 0.0f && distance < 2.0f)) continue;
            ++frames;
            EXPECT_EQ(blocks[y * kSize + x].brightest, kBright) << "texel " << x << ", " << y;
        }
    }
    EXPECT_GE(frames, kSize / 2) << "the frame is seen along half of the face or more";
}

}  // namespace
}  // namespace utsuri::test
