// SPDX-License-Identifier: Apache-2.0
// hybrid where the triangles of a scene are smaller than pixels: all of it is traced.
#include "renderers/methods/hybrid_tracer.h"

#include "support/methods.h"
#include "support/test_device.h"

#include "base/same_bits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace utsuri::test {
namespace {

constexpr RenderSettings kPicture{49, 33, 3, 4};
constexpr std::size_t kMiddle = 16 * 49 + 24;
constexpr double kWallBehindTheEye = 10.0;

/// A mirror ball of 81,920 triangles, a bright wall behind the eye.
Scene fine_ball() {
    Scene scene;
    add(scene, icosphere(glm::vec3(0.0f), 1.0f, 6), mirror());
    add(scene, quad({-50, -50, static_cast<float>(kWallBehindTheEye)}, {0, 100, 0}, {100, 0, 0}),
        emitter({0.3f, 0.5f, 0.2f}));
    return scene;
}

Camera eye() {
    return look_at({0, 0, 4}, {0, 0, 0}, 1.0);
}

class TracedByHybrid : public DeviceTest {
  protected:
    TracedByHybrid()
        : data_(prepare_scene_data(fine_ball())),
          gpu_scene_(device(), data_),
          light_(kept_light(device(), data_, gpu_scene_, {})) {}

    std::unique_ptr<Renderer> renderer(const char* reflection, const RenderSettings& picture) {
        const Method method = find_method("direct", reflection);
        std::unique_ptr<Renderer> made = make_renderer(
            method, {device(), data_, gpu_scene_, *method.light, light_, eye()}, picture, MapSettings());
        Progress progress;
        made->prepare(progress);
        return made;
    }

    Image image(const char* reflection) {
        const std::unique_ptr<Renderer> made = renderer(reflection, kPicture);
        Film film(device(), kPicture.width, kPicture.height, "film");
        Progress progress;
        made->add_samples(film, 2, progress);
        return film.resolve();
    }

    SceneData data_;
    GpuScene gpu_scene_;
    KeptLight light_;
};

TEST_F(TracedByHybrid, IsTheTracedPictureAndTakesNoPreparation) {
    EXPECT_TRUE(same_bits(image("hybrid").pixels, image("trace").pixels));
    const std::unique_ptr<Renderer> hybrid = renderer("hybrid", kPicture);
    EXPECT_EQ(hybrid->statistics().prepare_counts.rays, 0u);
    EXPECT_EQ(hybrid->statistics().maps, 0u);
}

// 81,922 triangles: the choice depends on the picture's size.
TEST_F(TracedByHybrid, OnlyWhereTrianglesAreSmallerThanPixels) {
    EXPECT_TRUE(costs_less_traced(data_, {256, 256}));
    EXPECT_FALSE(costs_less_traced(data_, {512, 256}));
    SceneData few = prepare_scene_data(everything_scene());
    EXPECT_FALSE(costs_less_traced(few, {1, 1}));
}

// What the nearest point of the ball mirrors is the wall: nothing is off its place.
TEST_F(TracedByHybrid, TellsThatNothingIsOffItsPlace) {
    const std::unique_ptr<Renderer> hybrid = renderer("hybrid", kPicture);
    const std::vector<float> traced = hybrid->traced_pixels();
    const std::vector<PredictedError> predicted = hybrid->predict_errors();
    const std::vector<MeasuredError> measured = hybrid->measure_errors();
    const std::size_t pixels = std::size_t{kPicture.width} * kPicture.height;
    ASSERT_EQ(traced.size(), pixels);
    ASSERT_EQ(predicted.size(), pixels);
    ASSERT_EQ(measured.size(), pixels);
    EXPECT_EQ(traced.front(), -1.0f) << "beside the ball";
    EXPECT_EQ(predicted.front().pixels, -1.0f);
    EXPECT_EQ(measured.front().pixels, -1.0f);
    EXPECT_EQ(traced[kMiddle], 1.0f);
    EXPECT_EQ(predicted[kMiddle].pixels, 0.0f);
    EXPECT_EQ(measured[kMiddle].pixels, 0.0f);
    // A facet's edge is 1.05 / 64 of the radius: its plane is nearer by at most the square of half of it,
    // halved, and smooth normals stay within half an edge of straight.
    constexpr double kSagitta = 1e-4;
    EXPECT_NEAR(static_cast<double>(measured[kMiddle].distance), kWallBehindTheEye - 1.0, 10.0 * kSagitta);
}

}  // namespace
}  // namespace utsuri::test
