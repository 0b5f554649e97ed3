// SPDX-License-Identifier: Apache-2.0
// hybrid with plane mirrors: their images, maps or rays where mirrors are curved, rays where an image would
// cost more.
#include "renderers/film/aov.h"
#include "renderers/film/frame_camera.h"
#include "renderers/methods/raster_renderer.h"
#include "support/methods.h"
#include "support/test_device.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace utsuri::test {
namespace {

constexpr RenderSettings kPicture{96, 72, 3, 4};
/// The rasteriser places corners to 1/256 of a pixel in each image anew, so that pixels at edges may show
/// what is beside: these are few.
constexpr double kMostEdgePixels = 0.03;
/// Of two kernels that compute the same light.
constexpr float kRounding = 1e-4f;

/// A mirror on the back wall, and a ball before it.
Scene mirror_and_ball(const Material& of_ball) {
    Scene scene;
    add(scene, quad({-1, -1, -1.9f}, {2, 0, 0}, {0, 2, 0}), mirror());
    add(scene, icosphere({0.5f, -0.4f, -0.6f}, 0.45f, 3), of_ball);
    add(scene, room({-2, -2, -2}, {2, 2, 2}), emitter({0.3f, 0.5f, 0.2f}));
    add(scene, quad({-1, 0, 1}, {0.5f, 0, 0}, {0, 1, 0}), emitter({2, 0, 1}));
    add(scene, quad({0.5f, 0, 0.5f}, {0.5f, 0, 0}, {0, 1, 0}), emitter({0, 2, 1}));
    return scene;
}

Camera eye() {
    return look_at({0.3, 0.2, 1.9}, {0, -0.1, -1.9}, 1.0);
}

class HybridViews : public DeviceTest {
  protected:
    struct View {
        Image image;
        std::vector<float> traced;
        std::vector<PredictedError> predicted;
        std::vector<MeasuredError> measured;
        FrameCounts counts;
    };

    static MapSettings settings(float tolerance) {
        MapSettings maps;
        maps.size = 64;
        maps.samples = 4;
        maps.tolerance = {Tolerance::Of::place, tolerance};
        return maps;
    }

    static constexpr std::uint32_t kSamples = 16;

    static View view(const Scene& scene, MapKind kind, float tolerance,
                     const RenderSettings& picture = kPicture) {
        const SceneData data = prepare_scene_data(scene);
        const GpuScene gpu_scene(device(), data);
        KeptLight light = kept_light(device(), data, gpu_scene, evenly_kept(1.0 / 20.0, 1, 0));
        RasterRenderer renderer =
            make_raster(device(), data, gpu_scene, light, eye(), {kind, true}, picture, settings(tolerance));
        Progress progress;
        renderer.prepare(progress);
        Film film(device(), picture.width, picture.height, "film");
        renderer.add_samples(film, kSamples, progress);
        EXPECT_EQ(renderer.statistics().counts.nonfinite, 0u);
        return {film.resolve(), renderer.traced_pixels(), renderer.predict_errors(),
                renderer.measure_errors(), renderer.statistics().counts};
    }

    static Image traced(const Scene& scene, const RenderSettings& picture = kPicture) {
        return trace(device(), scene, eye(), picture, kSamples).image;
    }

    static double share_that_differs(const Image& a, const Image& b, float tolerance) {
        std::size_t different = 0;
        for (std::size_t i = 0; i < a.pixels.size(); ++i) {
            const glm::vec3 difference = glm::abs(a.pixels[i] - b.pixels[i]);
            const float largest = std::max({difference.x, difference.y, difference.z});
            different += largest > tolerance ? 1 : 0;
        }
        return static_cast<double>(different) / static_cast<double>(a.pixels.size());
    }
};

TEST_F(HybridViews, ShowPlaneMirrorsAsThePlanarMethodDoes) {
    const Scene scene = mirror_and_ball(lambert(glm::vec3(0.5f)));
    const View hybrid = view(scene, MapKind::hybrid, 1.0f);
    const View planar = view(scene, MapKind::proxy, 1.0f);
    EXPECT_EQ(share_that_differs(hybrid.image, planar.image, kRounding), 0.0);
    EXPECT_EQ(hybrid.counts.lookups, planar.counts.lookups);
    EXPECT_EQ(hybrid.counts.traced, 0u);
    EXPECT_TRUE(planar.traced.empty());
    EXPECT_TRUE(planar.predicted.empty());
}

// With no tolerance all that is curved is traced, wherever it is seen: what is left are the edges.
TEST_F(HybridViews, FollowRaysOffCurvedMirrorsSeenInPlaneOnes) {
    const Scene scene = mirror_and_ball(mirror());
    const View hybrid = view(scene, MapKind::hybrid, 0.0f);
    EXPECT_LT(share_that_differs(hybrid.image, traced(scene), 0.15f), kMostEdgePixels);
    EXPECT_GT(hybrid.counts.traced, 0u);
    EXPECT_GT(hybrid.counts.lookups, hybrid.counts.traced);
    const View loose = view(scene, MapKind::hybrid, 1e6f);
    EXPECT_EQ(loose.counts.traced, 0u);
    EXPECT_EQ(loose.counts.lookups, hybrid.counts.lookups);
}

TEST_F(HybridViews, TellWhereRaysWereFollowedAndWhatIsOff) {
    const Scene scene = mirror_and_ball(mirror());
    const SceneData data = prepare_scene_data(scene);
    const GpuScene gpu_scene(device(), data);
    const auto aovs = render_aovs(device(), gpu_scene,
                                  make_camera_info(eye(), data.origin, kPicture.width, kPicture.height),
                                  kPicture.width, kPicture.height);
    const View hybrid = view(scene, MapKind::hybrid, 2.0f);
    std::size_t balls = 0;
    std::size_t images = 0;
    std::size_t others = 0;
    for (std::size_t i = 0; i < aovs.size(); ++i) {
        const PredictedError& predicted = hybrid.predicted[i];
        const MeasuredError& measured = hybrid.measured[i];
        ASSERT_EQ(hybrid.traced[i] < 0.0f, predicted.pixels < 0.0f);
        ASSERT_EQ(hybrid.traced[i] < 0.0f, measured.pixels < 0.0f);
        const bool is_mirror = aovs[i].triangle != interop::NONE && aovs[i].mirror != 0;
        if (is_mirror != (hybrid.traced[i] >= 0.0f)) {
            ++others;
        } else if (is_mirror && aovs[i].instance == 0) {
            ++images;
            EXPECT_EQ(predicted.pixels, 0.0f);
            EXPECT_EQ(measured.pixels, 0.0f);
            // From the mirror to what is before it: at most across the room.
            EXPECT_GT(measured.distance, 0.0f);
            EXPECT_LT(measured.distance, 7.0f);
        } else if (is_mirror) {
            ++balls;
            EXPECT_EQ(hybrid.traced[i] == 1.0f, predicted.pixels > 2.0f) << "pixel " << i;
        }
    }
    EXPECT_GT(images, 500u);
    EXPECT_GT(balls, 100u);
    EXPECT_LE(others, static_cast<std::size_t>(kMostEdgePixels * static_cast<double>(aovs.size())));
}

// More triangles than eight a pixel of the mirror's window, which is a few dozen pixels here.
TEST_F(HybridViews, FollowRaysWhereAnImageCostsMore) {
    constexpr RenderSettings kSmall{16, 12, 3, 4};
    const Scene scene = mirror_and_ball(lambert(glm::vec3(0.5f)));  // 1280 triangles and a few
    const View hybrid = view(scene, MapKind::hybrid, 1.0f, kSmall);
    EXPECT_GT(hybrid.counts.traced, 0u);
    EXPECT_EQ(hybrid.counts.traced, hybrid.counts.lookups);
    for (std::size_t i = 0; i < hybrid.traced.size(); ++i) {
        if (hybrid.traced[i] < 0.0f) continue;
        EXPECT_EQ(hybrid.traced[i], 1.0f);
        EXPECT_TRUE(std::isinf(hybrid.predicted[i].pixels));
        EXPECT_EQ(hybrid.measured[i].pixels, 0.0f);
    }
    EXPECT_LT(share_that_differs(hybrid.image, traced(scene, kSmall), 0.3f), kMostEdgePixels);
}

// Chains in facing mirrors are cut at the same depth, by images and by rays.
TEST_F(HybridViews, AreCutWhereChainsAre) {
    Scene scene;
    add(scene, quad({-1, -1, -1.9f}, {2, 0, 0}, {0, 2, 0}), mirror());
    add(scene, quad({1.5f, -1.5f, 1.95f}, {-3, 0, 0}, {0, 3, 0}), mirror());
    add(scene, room({-2, -2, -2}, {2, 2, 2}), emitter({0.3f, 0.5f, 0.2f}));
    RenderSettings shallow = kPicture;
    shallow.max_depth = 2;
    const View hybrid = view(scene, MapKind::hybrid, 1.0f, shallow);
    const View planar = view(scene, MapKind::proxy, 1.0f, shallow);
    EXPECT_GT(hybrid.counts.truncated, 0u);
    EXPECT_EQ(hybrid.counts.truncated, planar.counts.truncated);
    EXPECT_EQ(share_that_differs(hybrid.image, planar.image, kRounding), 0.0);
}

// A ball seen in a mirror is the second reflection: there may be one.
TEST_F(HybridViews, OfCurvedMirrorsAreCutWhereChainsAre) {
    RenderSettings shallow = kPicture;
    shallow.max_depth = 1;
    const Scene scene = mirror_and_ball(mirror());
    const View hybrid = view(scene, MapKind::hybrid, 0.0f, shallow);
    EXPECT_GT(hybrid.counts.truncated, 0u);
    EXPECT_LT(share_that_differs(hybrid.image, traced(scene, shallow), 0.15f), kMostEdgePixels);
}

// Where a view costs more than rays, these are cut: what shows the ball in the mirror is, and lacks what
// the ball reflects. Of the samples of a pixel one or all may be cut.
TEST_F(HybridViews, CountTheChainsOfRaysThatAreCut) {
    RenderSettings shallow{16, 12, 3, 4};
    shallow.max_depth = 1;
    const Scene scene = mirror_and_ball(mirror());
    const View hybrid = view(scene, MapKind::hybrid, 0.0f, shallow);
    EXPECT_EQ(hybrid.counts.lookups, hybrid.counts.traced);
    const View deeper = view(scene, MapKind::hybrid, 0.0f, {16, 12, 3, 8});
    std::uint64_t darker = 0;
    for (std::size_t i = 0; i < hybrid.image.pixels.size(); ++i)
        darker += hybrid.image.pixels[i] != deeper.image.pixels[i] ? 1 : 0;
    EXPECT_GT(darker, 0u);
    EXPECT_GE(hybrid.counts.truncated, darker);
    EXPECT_LE(hybrid.counts.truncated, darker * kSamples);
    EXPECT_LT(deeper.counts.truncated, hybrid.counts.truncated);
}

// Without a reflection allowed, what is not looked up is dark, with mirrored views and without.
TEST_F(HybridViews, NoRayIsFollowedAtADepthOfNothing) {
    RenderSettings flat = kPicture;
    flat.max_depth = 0;
    const Scene scene = mirror_and_ball(mirror());
    for (const bool draws_mirrored_views : {false, true}) {
        const Traced picture =
            render_with_maps(device(), scene, eye(), flat, DrawnMethod(MapKind::hybrid, draws_mirrored_views),
                             settings(0.0f), 2);
        EXPECT_EQ(picture.statistics.counts.rays, 0u);
        EXPECT_EQ(picture.statistics.counts.traced, 0u);
        EXPECT_GT(picture.statistics.counts.truncated, 0u);
    }
}

}  // namespace
}  // namespace utsuri::test
