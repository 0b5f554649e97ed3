// SPDX-License-Identifier: Apache-2.0
// What the raster pipeline draws is what rays see.
#include "renderers/reflection/raster/frame_drawer.h"

#include "renderers/film/aov.h"
#include "renderers/film/frame_camera.h"
#include "renderers/light/direct/light_cache.h"
#include "renderers/methods/prepared_maps.h"
#include "renderers/reflection/maps/reflection_maps.h"
#include "renderers/reflection/raster/drawn_samples.h"
#include "renderers/reflection/raster/picture_pixels.h"
#include "support/scenes.h"
#include "support/test_device.h"

#include "base/sampler.h"

#include "interop/bindings.h"
#include "interop/reflection.h"
#include "interop/specialization.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace utsuri::test {
namespace {

constexpr std::uint32_t kWidth = 96;
constexpr std::uint32_t kHeight = 64;
constexpr std::uint32_t kSeed = 7;
constexpr double kSpacing = 0.02;  ///< of the light cache

class DrawnFrames : public DeviceTest {
  protected:
    /// @param samples of each call to add_samples()
    static Image draw(const Scene& scene, const Camera& camera,
                      std::initializer_list<std::uint32_t> samples) {
        const SceneData data = prepare_scene_data(scene);
        const GpuScene gpu_scene(device(), data);
        return draw(data, gpu_scene, camera, samples);
    }

    /// A frame without a film, where no samples are asked for.
    static Image draw(const SceneData& data, const GpuScene& gpu_scene, const Camera& camera,
                      std::initializer_list<std::uint32_t> samples) {
        LightCache cache(device(), data, gpu_scene, {kSpacing, 4, 0});
        Progress progress;
        cache.fill(progress);
        MapSettings settings;
        settings.size = 4;
        std::vector<interop::ProxyPlane> planes;
        const ReflectionMaps maps(device(), data, MapKind::polygon, settings, {camera, kWidth, kHeight},
                                  planes);
        const GlossyMaps glossy_maps(device(), data, glossy_map_settings(MapKind::polygon, settings), planes);
        const Buffer plane_buffer = make_buffer<interop::ProxyPlane>(device(), planes, "planes");
        const Buffer frame(device(), sizeof(interop::FrameInfo), "frame");
        Bindings bindings = gpu_scene.bindings();
        bindings.merge(cache.bindings());
        bindings.merge(maps.bindings());
        bindings.merge(glossy_maps.bindings());
        bindings[interop::BINDING_PROXY_PLANES] = &plane_buffer;
        bindings[interop::BINDING_FRAME] = &frame;
        FrameDrawer drawer(device(), data, MapKind::cube, gpu_scene.specialization(), bindings, nullptr,
                           kWidth, kHeight);
        drawer.warm_up();
        const auto info = make_camera_info(camera, data.origin, kWidth, kHeight);
        interop::FrameInfo shared = frame_info(data, kWidth, kHeight);
        shared.seed = kSeed;
        shared.max_depth = 8;
        const auto record = [&](const vk::raii::CommandBuffer& commands,
                                const interop::FrameInfo& of_sample) {
            drawer.record(commands, info, of_sample);
        };
        if (samples.size() == 0) {
            device().run("draw a frame",
                         [&](const vk::raii::CommandBuffer& commands) { record(commands, shared); });
            return colours_of(picture_pixels(device(), drawer.picture()));
        }
        Film film(device(), kWidth, kHeight, "drawn film");
        DrawnSamples drawn(device(), kWidth, kHeight, *bindings.at(interop::BINDING_MAP_STATES));
        for (const std::uint32_t count : samples) {
            drawn.begin(film);
            for (std::uint32_t done = 0; done < count; ++done) {
                drawn.draw(film, shared, drawer.picture(), record);
                film.note_samples(1);
            }
            EXPECT_EQ(drawn.counts().nonfinite, 0u);
        }
        return film.resolve();
    }

    static Image colours_of(const std::vector<glm::vec4>& pixels) {
        Image image(kWidth, kHeight);
        for (std::size_t i = 0; i < pixels.size(); ++i)
            image.pixels[i] = glm::vec3(pixels[i]);
        return image;
    }

    static Image traced(const Scene& scene, const Camera& camera, std::uint32_t samples) {
        RenderSettings settings;
        settings.width = kWidth;
        settings.height = kHeight;
        return trace(device(), scene, camera, settings, samples).image;
    }
};

/// Balls and walls that emit light of their own, each surface another.
Scene coloured_room() {
    Scene scene;
    add(scene, room({-2, -1, -2}, {2, 1, 2}), emitter({0.2f, 0.4f, 0.8f}));
    add(scene, icosphere({0.3f, -0.2f, 0.4f}, 0.5f, 2), emitter({1.0f, 0.0f, 0.0f}));
    add(scene, icosphere({-0.9f, 0.1f, -0.5f}, 0.4f, 2), emitter({0.0f, 1.0f, 0.0f}));
    add(scene, quad({-0.5f, -0.9f, 1.0f}, {0.8f, 0, 0}, {0, 0.5f, 0.1f}), emitter({0.0f, 0.0f, 2.0f}));
    return scene;
}

// Emission alone is drawn exactly; pixels differ where an edge passes between the two places of their sample.
// An edge crosses about as many pixels as the picture is wide, and a sample each moves by less than a pixel.
TEST_F(DrawnFrames, ShowWhatRaysHit) {
    const Scene scene = coloured_room();
    const Camera camera = look_at({1.5, 0.5, 1.7}, {0, 0, 0}, 1.2);
    const Image drawn = draw(scene, camera, {64});
    const Image reference = traced(scene, camera, 64);
    int differ = 0;
    double drawn_sum = 0.0;
    double reference_sum = 0.0;
    for (std::size_t i = 0; i < drawn.pixels.size(); ++i) {
        const glm::vec3 difference = glm::abs(drawn.pixels[i] - reference.pixels[i]);
        if (std::max({difference.x, difference.y, difference.z}) > 1e-5f) ++differ;
        drawn_sum += static_cast<double>(drawn.pixels[i].x + drawn.pixels[i].y);
        reference_sum += static_cast<double>(reference.pixels[i].x + reference.pixels[i].y);
    }
    EXPECT_LE(differ, 8 * static_cast<int>(kWidth + kHeight));
    EXPECT_NEAR(drawn_sum / reference_sum, 1.0, 2e-3);
}

// Without a film a pixel shows what its centre meets; where that is an edge, rounding decides.
TEST_F(DrawnFrames, ShowPixelCentresWithoutAFilm) {
    const Scene scene = coloured_room();
    const Camera camera = look_at({1.5, 0.5, 1.7}, {0, 0, 0}, 1.2);
    const SceneData data = prepare_scene_data(scene);
    const GpuScene gpu_scene(device(), data);
    const Image frame = draw(data, gpu_scene, camera, {});
    const auto hits = render_aovs(device(), gpu_scene, make_camera_info(camera, data.origin, kWidth, kHeight),
                                  kWidth, kHeight);
    int differ = 0;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        ASSERT_NE(hits[i].material, interop::NONE);
        differ += frame.pixels[i] != scene.materials[hits[i].material].emissive ? 1 : 0;
    }
    EXPECT_LE(differ, 3);
}

// A sun on a floor is kept exactly, so away from edges drawing and tracing agree to rounding.
TEST_F(DrawnFrames, AreLitAsByRays) {
    Scene scene;
    add(scene, quad({-50, 0, 50}, {100, 0, 0}, {0, 0, -100}), lambert({0.5f, 0.25f, 0.75f}));
    Light sun;
    sun.type = LightType::directional;
    sun.direction = {0.6, -0.8, 0.0};
    sun.intensity = glm::vec3(10.0f);
    scene.lights.push_back(sun);
    const Camera camera = look_at({0, 3, 1}, {0, 0, 0}, 0.7);
    const Image drawn = draw(scene, camera, {4});
    for (const glm::vec3& pixel : drawn.pixels) {
        for (int c = 0; c < 3; ++c) {
            const double albedo = c == 0 ? 0.5 : (c == 1 ? 0.25 : 0.75);
            const double expected = albedo * 10.0 * 0.8 / std::numbers::pi;
            // Some 20 roundings of float32.
            EXPECT_NEAR(static_cast<double>(pixel[c]), expected, 2e-6 * expected);
        }
    }
}

// A lamp over a floor: light is interpolated linearly along the rows of the cache and between them. With
// second derivatives of at most M = 3 I / h^4 (straight below the lamp) either errs by at most M L^2 / 8 over
// a distance L of neighbours.
TEST_F(DrawnFrames, InterpolateLightLinearly) {
    constexpr double kLampHeight = 3.0;
    constexpr double kIntensity = 40.0;
    Scene scene;
    add(scene, quad({-4, 0, 4}, {8, 0, 0}, {0, 0, -8}), lambert(glm::vec3(1.0f)));
    Light lamp;
    lamp.type = LightType::point;
    lamp.position = {0.4, kLampHeight, -0.3};
    lamp.intensity = glm::vec3(static_cast<float>(kIntensity));
    scene.lights.push_back(lamp);
    const Camera camera = look_at({1, 4, 2}, {0, 0, 0}, 0.6);
    const Image drawn = draw(scene, camera, {1});
    const double cell = kSpacing * 8.0 * std::sqrt(2.0);
    const double bound = 3.0 * kIntensity / std::pow(kLampHeight, 4.0) * cell * cell / 4.0 / std::numbers::pi;
    const glm::dvec2 jitter = sample_2d(sampler_key({0, 0}, kSeed, 0), 0, 0);
    const double half_height = std::tan(0.5 * camera.vertical_fov);
    const double half_width = half_height * kWidth / kHeight;
    for (std::uint32_t y = 0; y < kHeight; ++y) {
        for (std::uint32_t x = 0; x < kWidth; ++x) {
            const double right = half_width * (2.0 * (x + jitter.x) / kWidth - 1.0);
            const double up = half_height * (1.0 - 2.0 * (y + jitter.y) / kHeight);
            const glm::dvec3 along = camera.forward + right * camera.right + up * camera.up;
            const glm::dvec3 point = camera.position - camera.position.y / along.y * along;
            const double distance = glm::distance(point, lamp.position);
            const double expected =
                kIntensity * kLampHeight / (distance * distance * distance) / std::numbers::pi;
            // Corners are placed to 1/256 of a pixel; light changes by at most a third of itself over a
            // metre, and a pixel shows less than a tenth of one.
            ASSERT_NEAR(static_cast<double>(drawn.at(x, y).x), expected,
                        bound + expected * 0.1 / 3.0 / 256.0 + 1e-5)
                << x << ' ' << y;
        }
    }
}

TEST_F(DrawnFrames, AreTheSameForAnySplitOfTheSamples) {
    const Scene scene = coloured_room();
    const Camera camera = look_at({1.5, 0.5, 1.7}, {0, 0, 0}, 1.2);
    const Image at_once = draw(scene, camera, {7});
    const Image split = draw(scene, camera, {1, 4, 2});
    EXPECT_EQ(at_once.pixels, split.pixels);
}

TEST_F(DrawnFrames, AreTheSameAtAnyScale) {
    const Scene scene = coloured_room();
    const Camera camera = look_at({1.5, 0.5, 1.7}, {0, 0, 0}, 1.2);
    const Image image = draw(scene, camera, {3});
    for (const int k : {-20, -7, 20}) {
        const double factor = std::ldexp(1.0, k);
        Camera moved = camera;
        moved.position *= factor;
        EXPECT_EQ(draw(scaled(scene, factor), moved, {3}).pixels, image.pixels) << k;
    }
}

TEST_F(DrawnFrames, ShowTheSurroundingsWhereNothingIs) {
    Scene scene;
    add(scene, quad({-1, -5, 0}, {2, 0, 0}, {0, 1, 0}), lambert(glm::vec3(0.5f)));
    scene.environment = {3.0f, 2.0f, 1.0f};
    const Image drawn = draw(scene, look_at({0, 3, 4}, {0, 5, 0}), {2});
    for (const glm::vec3& pixel : drawn.pixels)
        EXPECT_EQ(pixel, scene.environment);
}

}  // namespace
}  // namespace utsuri::test
