// SPDX-License-Identifier: Apache-2.0
// references.md C0: scaling all lengths by 2^k, and point lights by 4^k, changes no bit of the picture. One
// absolute epsilon anywhere, one overflow or one denormal would.
#include "support/methods.h"
#include "support/test_device.h"

#include <gmock/gmock.h>

#include <cmath>
#include <map>

namespace utsuri::test {
namespace {

constexpr RenderSettings kSettings{48, 36, 7, 8};
constexpr std::uint32_t kSamples = 4;
constexpr int kExponents[] = {-20, -13, -1, 1, 10, 20};

Camera scaled_camera(double factor) {
    Camera camera = everything_camera();
    camera.position *= factor;
    return camera;
}

/// All light times `factor`.
Scene brighter(Scene scene, float factor) {
    for (Material& material : scene.materials)
        material.emissive *= factor;
    for (Light& light : scene.lights)
        light.intensity *= factor;
    return scene;
}

class Scale : public DeviceTest {};
class ScaleOfMaps : public DeviceTest {};

TEST_F(Scale, TracedPictureIsTheSameBits) {
    const Image original =
        trace(device(), everything_scene(), everything_camera(), kSettings, kSamples).image;
    for (const int k : kExponents) {
        const double factor = std::ldexp(1.0, k);
        const Traced result =
            trace(device(), scaled(everything_scene(), factor), scaled_camera(factor), kSettings, kSamples);
        EXPECT_EQ(result.statistics.counts.nonfinite, 0u) << "k = " << k;
        EXPECT_TRUE(result.image.pixels == original.pixels) << "k = " << k;
    }
}

TEST_F(ScaleOfMaps, AreTheSameBits) {
    const MapSettings maps{24, 2, {}, 3};
    DrawnScene original(device(), everything_scene());
    std::map<int, DrawnScene> others;
    for (const int k : {-20, 20})
        others.try_emplace(k, device(), scaled(everything_scene(), std::ldexp(1.0, k)));
    for (const DrawnMethod& method : drawn_methods()) {
        const Image expected = original.render(method, everything_camera(), kSettings, maps, 2).image;
        for (auto& [k, scene] : others) {
            const Camera camera = scaled_camera(std::ldexp(1.0, k));
            EXPECT_TRUE(scene.render(method, camera, kSettings, maps, 2).image.pixels == expected.pixels)
                << method << ", k = " << k;
        }
    }
}

TEST_F(Scale, AFactorThatIsNoPowerOfTwoDiffers) {
    // What the tests above would miss if pictures were equal for a trivial reason.
    const Image original =
        trace(device(), everything_scene(), everything_camera(), kSettings, kSamples).image;
    const Image image =
        trace(device(), scaled(everything_scene(), 3.0), scaled_camera(3.0), kSettings, kSamples).image;
    EXPECT_FALSE(image.pixels == original.pixels);
}

TEST_F(Scale, LightTimesAPowerOfTwoScalesThePictureExactly) {
    const Image original =
        trace(device(), everything_scene(), everything_camera(), kSettings, kSamples).image;
    for (const int k : {-33, 40}) {  // 1e-10 and 1e12
        const float factor = std::ldexp(1.0f, k);
        const Traced result =
            trace(device(), brighter(everything_scene(), factor), everything_camera(), kSettings, kSamples);
        EXPECT_EQ(result.statistics.counts.nonfinite, 0u);
        for (std::size_t i = 0; i < original.pixels.size(); ++i) {
            ASSERT_EQ(result.image.pixels[i], original.pixels[i] * factor) << "k = " << k << ", pixel " << i;
        }
    }
}

TEST_F(ScaleOfMaps, FollowsLightTimesAPowerOfTwoExactly) {
    const MapSettings maps{16, 2, {}};
    const Camera camera = everything_camera();
    DrawnScene original(device(), everything_scene());
    std::map<int, DrawnScene> others;
    for (const int k : {-33, 40})
        others.try_emplace(k, device(), brighter(everything_scene(), std::ldexp(1.0f, k)));
    for (const DrawnMethod& method : drawn_methods()) {
        const Image expected = original.render(method, camera, kSettings, maps, 1).image;
        for (auto& [k, scene] : others) {
            const Traced result = scene.render(method, camera, kSettings, maps, 1);
            EXPECT_EQ(result.statistics.counts.nonfinite + result.statistics.prepare_counts.nonfinite, 0u);
            for (std::size_t i = 0; i < expected.pixels.size(); ++i) {
                ASSERT_EQ(result.image.pixels[i], expected.pixels[i] * std::ldexp(1.0f, k))
                    << method << ", k = " << k << ", pixel " << i;
            }
        }
    }
}

TEST_F(Scale, FarFromTheOriginIsTheSameScene) {
    // A translation by a multiple of a large power of two is exact in float64, and the scene is re-based.
    const glm::dvec3 offset = std::ldexp(1.0, 20) * glm::dvec3(1, -2, 3);
    Scene scene = everything_scene();
    for (Instance& instance : scene.instances)
        instance.world_from_object[3] += glm::dvec4(offset, 0.0);
    for (Light& light : scene.lights)
        light.position += offset;
    Camera camera = everything_camera();
    camera.position += offset;
    const Image original =
        trace(device(), everything_scene(), everything_camera(), kSettings, kSamples).image;
    const Image image = trace(device(), scene, camera, kSettings, kSamples).image;
    // Re-based vertices differ by the rounding of float64 at 3e6 m, 5e-10 m, which can turn a float32 by one
    // unit: a few samples may then fall on the other side of an edge, so the mean is held, and most pixels.
    double difference = 0.0;
    double sum = 0.0;
    for (std::size_t i = 0; i < original.pixels.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            difference += std::abs(static_cast<double>(image.pixels[i][c]) -
                                   static_cast<double>(original.pixels[i][c]));
            sum += static_cast<double>(original.pixels[i][c]);
        }
    }
    EXPECT_LT(difference / sum, 1e-3);
}

}  // namespace
}  // namespace utsuri::test
