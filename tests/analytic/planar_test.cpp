// SPDX-License-Identifier: Apache-2.0
// direct/planar: what plane mirrors show is known from plane geometry (references.md A6.1, A6.4).
#include "renderers/methods/raster_renderer.h"
#include "support/coded_room.h"
#include "support/estimate.h"
#include "support/light_scenes.h"
#include "support/methods.h"
#include "support/test_device.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace utsuri::test {
namespace {

constexpr unsigned kLowerZ = 1u << 4;
constexpr RenderSettings kPicture{48, 36, 7, 8};

class Planar : public DeviceTest {
  protected:
    /// @param portions samples of each call to add_samples()
    static Traced drawn(const Scene& scene, const Camera& camera, const RenderSettings& settings,
                        const std::vector<std::uint32_t>& portions) {
        const SceneData data = prepare_scene_data(scene);
        const GpuScene gpu_scene(device(), data);
        KeptLight light = kept_light(device(), data, gpu_scene, evenly_kept(1.0 / 60.0, 4, 0));
        RasterRenderer renderer = make_raster(device(), data, gpu_scene, light, camera,
                                              {MapKind::proxy, true}, settings, MapSettings{24, 2, {}});
        Film film(device(), settings.width, settings.height, "test film");
        Progress progress;
        renderer.prepare(progress);
        for (const std::uint32_t samples : portions)
            renderer.add_samples(film, samples, progress);
        EXPECT_EQ(renderer.statistics().counts.nonfinite, 0u);
        return {film.resolve(), renderer.statistics()};
    }

    /// A look that shows one point in all pixels: see Observer::look().
    static Traced look(const Scene& scene, glm::dvec3 eye, glm::dvec3 target, std::uint32_t depth = 8) {
        return drawn(scene, look_at(eye, target, kCloseUpAngle), {kCloseUpSize, kCloseUpSize, 0, depth}, {2});
    }
};

// The view in a plane mirror is the direct view of the mirrored eye, to the bit: the same cameras draw the
// same triangles at the same places of the samples, and a mirror of reflectance 1 adds no rounding.
TEST_F(Planar, MirrorShowsTheViewOfTheMirroredEye) {
    const CodedRoom coded({-4, -3, -3}, {4, 3, 5});
    Scene open;
    coded.add_to(open, kLowerZ);
    add(open, icosphere({0.5f, 0.3f, 3.0f}, 0.7f, 2), emitter({0.1f, 0.9f, 0.4f}));
    Scene mirrored = open;
    add(mirrored, quad({-4, -3, 0}, {8, 0, 0}, {0, 6, 0}), mirror());
    Camera camera;
    camera.position = {0.3, 0.2, 2.0};
    camera.vertical_fov = 1.2;
    const Image in_mirror = drawn(mirrored, camera, kPicture, {4}).image;
    camera.position.z = -camera.position.z;
    camera.forward.z = -camera.forward.z;
    const Image direct = drawn(open, camera, kPicture, {4}).image;
    EXPECT_EQ(in_mirror.pixels, direct.pixels);
    EXPECT_GT(glm::length(direct.at(0, 0) - direct.at(47, 35)), 0.1f);
}

// The worked room of references.md B1: a mirror shows the true hits, where maps show others.
TEST_F(Planar, MirrorShowsTheTrueHits) {
    const CodedRoom coded({0, 0, 0}, {4, 3, 5});
    Scene scene;
    coded.add_to(scene, kLowerZ);
    add(scene, quad({0, 0, 0}, {4, 0, 0}, {0, 3, 0}), mirror());
    const glm::dvec3 eye(1, 1.6, 4);
    const std::vector<std::pair<glm::dvec3, glm::dvec3>> hits = {{{2.5, 2, 0}, {4, 2.4, 4}},
                                                                 {{2, 1.5, 0}, {3.25, 1.375, 5}},
                                                                 {{1, 1, 0}, {1, 0.25, 5}},
                                                                 {{3, 2.5, 0}, {4, 2.95, 2}}};
    for (const auto& [place, hit] : hits) {
        const glm::dvec3 seen = coded.decode(estimate_of(look(scene, eye, place).image).mean);
        // Half a picture of 1e-4 rad at 10 m of way, grazing a wall at no less than a quarter.
        EXPECT_LE(glm::distance(seen, hit), 0.5 * kCloseUpAngle * 10.0 * 4.0);
    }
}

TEST_F(Planar, BothSidesReflect) {
    const CodedRoom coded(glm::dvec3(-4.0), glm::dvec3(4.0));
    Scene scene;
    coded.add_to(scene);
    add(scene, quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), mirror());
    for (const double side : {1.0, -1.0}) {
        const glm::dvec3 eye(0.5, 0.2, 2.0 * side);
        const glm::dvec3 seen = coded.decode(estimate_of(look(scene, eye, {0, 0, 0}).image).mean);
        EXPECT_LE(glm::distance(seen, coded.wall_point({0, 0, 0}, {-0.5, -0.2, 2.0 * side})), 1e-3);
    }
}

// Both mirrors have images of one reflection at the same pixels, and that of the hidden one is nearer.
TEST_F(Planar, AMirrorInFrontOfAnotherShowsItsOwnImage) {
    const CodedRoom coded(glm::dvec3(-4.0), glm::dvec3(4.0));
    Scene scene;
    coded.add_to(scene);
    add(scene, quad({-0.5f, -0.5f, 0}, {1, 0, 0}, {0, 1, 0}), mirror());
    add(scene, quad({-0.9f, -1, -0.1f}, {1.8f, 0, -1.8f}, {0, 2, 0}), mirror());
    add(scene, quad({1.5f, -1, -1.8f}, {0, 0, 1.6f}, {0, 4, 0}), emitter(glm::vec3(5.0f)));
    const glm::dvec3 eye(0.1, 0.05, 2.0);
    const glm::dvec3 seen = coded.decode(estimate_of(look(scene, eye, {0, 0, 0}).image).mean);
    EXPECT_LE(glm::distance(seen, coded.wall_point({0, 0, 0}, {-0.1, -0.05, 2.0})), 1e-3);
    // Above the first the second shows the panel.
    EXPECT_EQ(look(scene, eye, {0, 0.9, -1}).image.at(8, 8), glm::vec3(5.0f));
}

/// Two mirrors of reflectance 0.9 that face each other at a distance of 1, for x <= 1.
Scene facing_mirrors(float emission) {
    Material material = mirror();
    material.base_colour = glm::vec3(0.9f);
    material.emissive = glm::vec3(emission);
    Scene scene;
    add(scene, quad({-1, -1, -0.5f}, {2, 0, 0}, {0, 2, 0}), material);
    add(scene, flipped(quad({-1, -1, 0.5f}, {2, 0, 0}, {0, 2, 0})), material);
    return scene;
}

constexpr double kReflectance = static_cast<double>(0.9f);
constexpr std::uint64_t kLookSamples = 2 * kCloseUpSize * kCloseUpSize;

// As AChainOfTenReflections of mirrors_test.cpp: ten mirrors, then the environment of radiance 1.
TEST_F(Planar, AChainOfTenReflections) {
    Scene scene = facing_mirrors(0.0f);
    scene.environment = glm::vec3(1.0f);
    const double cosine = 1.0 / std::sqrt(1.01);
    const double reflectance = kReflectance + (1.0 - kReflectance) * std::pow(1.0 - cosine, 5.0);
    const Traced all = look(scene, {0, 0, 0}, {0.1, 0, 1}, 10);
    expect_radiance(estimate_of(all.image), std::pow(reflectance, 10.0), 1e-6);
    EXPECT_EQ(all.statistics.counts.truncated, 0u);
    EXPECT_EQ(all.statistics.counts.lookups, 10 * kLookSamples);
    const Traced cut = look(scene, {0, 0, 0}, {0.1, 0, 1}, 9);
    expect_radiance(estimate_of(cut.image), 0.0);
    EXPECT_EQ(cut.statistics.counts.truncated, kLookSamples);
    EXPECT_EQ(cut.statistics.counts.lookups, 10 * kLookSamples);
}

// Mirrors that shine with radiance 1 add up to 1 + rho + ... + rho^depth along the common axis.
TEST_F(Planar, SpecularDepthCutsTheSeries) {
    double sum = 0.0;
    for (std::uint32_t depth = 0; depth <= 40; ++depth) {
        sum += std::pow(kReflectance, depth);
        if (depth > 3 && depth < 40) continue;
        SCOPED_TRACE(depth);
        const Traced result = look(facing_mirrors(1.0f), {0, 0, 0}, {0, 0, 1}, depth);
        expect_radiance(estimate_of(result.image), sum, 1e-6);
        EXPECT_EQ(result.statistics.counts.truncated, kLookSamples);
    }
}

// Two mirrors at right angles send light back where it came from: see mirrors_test.cpp.
TEST_F(Planar, ACornerOfTwoMirrorsReturnsLight) {
    const CodedRoom coded(glm::dvec3(-10.0), glm::dvec3(10.0));
    Scene scene;
    coded.add_to(scene);
    add(scene, quad({0, -1, 0}, {0, 2, 0}, {0, 0, 4}), mirror());
    add(scene, quad({0, -1, 0}, {4, 0, 0}, {0, 2, 0}), mirror());
    const glm::dvec3 eye(2.0, 0.0, 1.5);
    for (const glm::dvec3 target : {glm::dvec3(0, 0.1, 0.7), glm::dvec3(0.9, -0.2, 0)}) {
        const glm::dvec3 along = target - eye;
        const glm::dvec3 image(-eye.x, eye.y, -eye.z);
        const glm::dvec3 expected = coded.wall_point(image, {-along.x, along.y, -along.z});
        const glm::dvec3 seen = coded.decode(estimate_of(look(scene, eye, target).image).mean);
        EXPECT_LE(glm::distance(seen, expected), 2.0 * kCloseUpAngle * 20.0);
    }
}

// What is fixed to the mirror, or touches its plane from behind, does not cover what it shows.
TEST_F(Planar, WhatIsBehindTheMirrorIsNotSeenInIt) {
    const CodedRoom coded(glm::dvec3(-4.0), glm::dvec3(4.0));
    Scene scene;
    coded.add_to(scene);
    add(scene, quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), mirror());
    add(scene, quad({-3, -3, -1e-4f}, {6, 0, 0}, {0, 6, 0}), emitter(glm::vec3(5.0f)));
    // In the very plane, around the mirror.
    add(scene, quad({-3, -3, 0}, {2, 0, 0}, {0, 6, 0}), emitter(glm::vec3(7.0f)));
    const glm::dvec3 eye(0.5, 0.2, 2.0);
    const glm::dvec3 seen = coded.decode(estimate_of(look(scene, eye, {0, 0, 0}).image).mean);
    EXPECT_LE(glm::distance(seen, coded.wall_point({0, 0, 0}, {-0.5, -0.2, 2.0})), 1e-3);
}

// From within its plane a mirror is a line, of no pixel: the picture is the one without it.
TEST_F(Planar, AnEyeInTheMirrorsPlaneSeesNoMirror) {
    const CodedRoom coded(glm::dvec3(-4.0), glm::dvec3(4.0));
    Scene without;
    coded.add_to(without);
    Scene scene = without;
    add(scene, quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), mirror());
    for (const Camera& camera :
         {look_at({3, 0.3, 0}, {0, 0, 0}, 1.0), look_at({0.2, 0.1, 0}, {1, 3, 2}, 1.0)}) {
        const Traced result = drawn(scene, camera, kPicture, {2});
        EXPECT_EQ(result.image.pixels, drawn(without, camera, kPicture, {2}).image.pixels);
        EXPECT_EQ(result.statistics.counts.lookups, 0u);
    }
}

// A hair off that plane, and wherever else: no pixel is lost, all are within what the room shines with.
TEST_F(Planar, AnEyeCloseToTheMirrorSeesTheRoom) {
    const CodedRoom coded(glm::dvec3(-4.0), glm::dvec3(4.0));
    Scene scene;
    coded.add_to(scene);
    add(scene, quad({-4, -4, 0}, {8, 0, 0}, {0, 8, 0}), mirror());
    for (const double distance : {1e-1, 1e-3, 1e-5}) {
        const Traced result = drawn(scene, look_at({0.2, 0.1, distance}, {2, 0.3, 0}, 1.0), kPicture, {2});
        EXPECT_EQ(result.statistics.counts.truncated, 0u);
        for (const glm::vec3& pixel : result.image.pixels) {
            // One of the three coordinates is that of a wall.
            const glm::vec3 off = glm::min(glm::abs(pixel), glm::abs(pixel - 1.0f));
            EXPECT_LE(std::min({off.x, off.y, off.z}), 1e-2f);
        }
    }
}

// A lit room with a wall of mirror metal, drawn and traced. What the light cache leaves: over its distance of
// points, a sixtieth of the diagonal of 7 m, the light of a lamp 1 m away bends by up to 3 L^2 / 8 = 0.5 %.
TEST_F(Planar, AgreesWithTracingInALitRoom) {
    Scene scene;
    Material wall = mirror();
    wall.base_colour = {0.9f, 0.7f, 0.5f};
    add(scene, room({-2, 0, -2}, {2, 3, 2}), lambert({0.3f, 0.6f, 0.9f}));
    add(scene, quad({-2, 0, -1.9f}, {4, 0, 0}, {0, 3, 0}), wall);
    Light lamp;
    lamp.position = {0.3, 1.6, 0.4};
    lamp.intensity = glm::vec3(100.0f);
    scene.lights.push_back(lamp);
    const Camera camera = look_at({1.2, 1.4, 1.5}, {-0.3, 1.2, -2}, 1.0);
    const Image traced = trace(device(), scene, camera, kPicture, 64).image;
    const Image planar = drawn(scene, camera, kPicture, {64}).image;
    double sum = 0.0;
    for (std::size_t i = 0; i < traced.pixels.size(); ++i) {
        const glm::dvec3 expected(traced.pixels[i]);
        sum += glm::length(glm::dvec3(planar.pixels[i]) - expected) / glm::length(expected);
    }
    EXPECT_LE(sum / static_cast<double>(traced.pixels.size()), 0.01);
}

TEST_F(Planar, WithoutPlaneMirrorsIsProxyMapping) {
    Scene scene = everything_scene();
    scene.instances.pop_back();
    const Image planar = drawn(scene, everything_camera(), kPicture, {3}).image;
    const Image proxy = render_with_maps(device(), scene, everything_camera(), kPicture, MapKind::proxy,
                                         MapSettings{24, 2, {}}, 3)
                            .image;
    EXPECT_EQ(planar.pixels, proxy.pixels);
}

TEST_F(Planar, IsTheSameForAnySplitAndAtAnyScale) {
    const Image original = drawn(everything_scene(), everything_camera(), kPicture, {5}).image;
    EXPECT_EQ(drawn(everything_scene(), everything_camera(), kPicture, {1, 3, 1}).image.pixels,
              original.pixels);
    for (const int k : {-20, 20}) {
        const double factor = std::ldexp(1.0, k);
        Camera camera = everything_camera();
        camera.position *= factor;
        EXPECT_EQ(drawn(scaled(everything_scene(), factor), camera, kPicture, {5}).image.pixels,
                  original.pixels)
            << "k = " << k;
    }
}

// A room of mirrors shows itself without end: images are bounded, what is left out is counted, and dark.
TEST_F(Planar, ARoomOfMirrorsIsBounded) {
    Scene scene;
    Material material = mirror();
    material.base_colour = glm::vec3(0.5f);
    material.emissive = glm::vec3(1.0f);
    add(scene, room(glm::vec3(-2.0f), glm::vec3(2.0f)), material);
    const Camera camera = look_at({0.3, 0.4, 1}, {0, 0, -2}, 1.0);
    const Traced result = drawn(scene, camera, {48, 36, 7, 30}, {2});
    // Corners are placed to 1/256 of a pixel, in each image for itself: along the edges of the room, no
    // longer in pixels than ten times the picture's width and height, a ray may slip through.
    EXPECT_GE(result.statistics.counts.truncated, 2u * 48u * 36u - 2u * 10u * (48u + 36u) / 256u);
    for (const glm::vec3& pixel : result.image.pixels) {
        EXPECT_GE(pixel.x, 1.5f);  // no direction is cut before its second reflection
        EXPECT_LE(pixel.x, 2.5f);  // 1 / (1 - 1/2), and Schlick's rise at grazing angles
    }
}

}  // namespace
}  // namespace utsuri::test
