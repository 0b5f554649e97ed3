// SPDX-License-Identifier: Apache-2.0
// Scenes and pictures at the edge of what there can be: nothing crashes and nothing is not a number.
#include "support/coded_room.h"
#include "support/methods.h"
#include "support/test_device.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace utsuri::test {
namespace {

constexpr RenderSettings kSettings{16, 12, 1, 8};

class Degenerate : public DeviceTest {
  protected:
    /// Renders by all methods; pixels must be finite and no sample may be left out.
    /// @param eyes that the scene is seen from, at least one; it is prepared for the first
    void render_all(const Scene& scene, const std::vector<Camera>& eyes,
                    RenderSettings settings = kSettings) {
        for (const Camera& eye : eyes) {
            const Traced traced = trace(device(), scene, eye, settings, 2);
            EXPECT_EQ(traced.statistics.counts.nonfinite, 0u);
            check(traced.image);
        }
        DrawnScene drawn(device(), scene);
        for (const DrawnMethod& method : drawn_methods()) {
            SCOPED_TRACE(method);
            const auto renderer = drawn.renderer(method, eyes.front(), settings, MapSettings{4, 1, {}});
            Progress progress;
            renderer->prepare(progress);
            for (const Camera& eye : eyes) {
                renderer->set_camera(eye);
                Film film(device(), settings.width, settings.height, "film");
                renderer->add_samples(film, 2, progress);
                check(film.resolve());
            }
            const RenderStatistics& statistics = renderer->statistics();
            EXPECT_EQ(statistics.counts.nonfinite + statistics.prepare_counts.nonfinite, 0u);
        }
    }

    static void check(const Image& image) {
        for (const glm::vec3& pixel : image.pixels)
            ASSERT_TRUE(std::isfinite(pixel.x) && std::isfinite(pixel.y) && std::isfinite(pixel.z));
    }
};

TEST_F(Degenerate, EmptySceneShowsTheSurroundings) {
    Scene scene;
    scene.environment = glm::vec3(1, 2, 3);
    const Camera camera = look_at(glm::dvec3(0), glm::dvec3(0, 0, -1));
    render_all(scene, {camera});
    EXPECT_THAT(trace(device(), scene, camera, kSettings, 3).image.pixels, testing::Each(glm::vec3(1, 2, 3)));
}

TEST_F(Degenerate, SceneWithoutLightIsBlack) {
    Scene scene;
    add(scene, icosphere(glm::vec3(0), 1.0f, 1), mirror());
    const Camera camera = look_at(glm::dvec3(0, 0, 5), glm::dvec3(0));
    render_all(scene, {camera});
    EXPECT_THAT(trace(device(), scene, camera, kSettings, 2).image.pixels, testing::Each(glm::vec3(0.0f)));
}

TEST_F(Degenerate, OneTriangle) {
    Scene scene;
    Mesh mesh = quad(glm::vec3(-1, -1, 0), glm::vec3(2, 0, 0), glm::vec3(0, 2, 0));
    mesh.triangles.resize(1);
    add(scene, mesh, lambert(glm::vec3(0.5f)));
    scene.environment = glm::vec3(1.0f);
    render_all(scene, {look_at(glm::dvec3(0, 0, 3), glm::dvec3(0))});
}

TEST_F(Degenerate, ZeroAreaTrianglesAreNeverHit) {
    Scene scene;
    Mesh mesh;
    mesh.positions = {{-1, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    mesh.normals.assign(4, glm::vec3(0, 0, 1));
    mesh.triangles = {{0, 1, 2}, {2, 3, 2}, {0, 1, 1}};
    add(scene, mesh, emitter(glm::vec3(100.0f)));
    scene.environment = glm::vec3(1.0f);
    const Camera camera = look_at(glm::dvec3(0, 0, 3), glm::dvec3(0));
    render_all(scene, {camera});
    EXPECT_THAT(trace(device(), scene, camera, kSettings, 4).image.pixels, testing::Each(glm::vec3(1.0f)));
}

TEST_F(Degenerate, CoincidentTrianglesHaveAStableWinner) {
    Scene scene;
    for (int i = 0; i < 5; ++i) {
        add(scene, quad(glm::vec3(-3, -3, 0), glm::vec3(6, 0, 0), glm::vec3(0, 6, 0)),
            emitter(glm::vec3(static_cast<float>(i + 1))));
    }
    const Camera camera = look_at(glm::dvec3(0, 0, 3), glm::dvec3(0));
    const Image first = trace(device(), scene, camera, kSettings, 1).image;
    EXPECT_TRUE(trace(device(), scene, camera, kSettings, 1).image.pixels == first.pixels);
    render_all(scene, {camera});
}

TEST_F(Degenerate, PicturesOfOnePixelEdges) {
    for (const glm::uvec2 size : {glm::uvec2(1, 1), glm::uvec2(1, 67), glm::uvec2(67, 1), glm::uvec2(9, 7)}) {
        render_all(everything_scene(), {everything_camera()}, {size.x, size.y, 0, 2});
    }
}

TEST_F(Degenerate, EyeOnASurfaceInAVertexAndInsideTheBall) {
    const std::vector<Camera> eyes = {
        look_at(glm::dvec3(0, 0, 0), glm::dvec3(0, 1, -1)),             // on the floor
        look_at(glm::dvec3(-2, 0, -2.5), glm::dvec3(0, 1, 0)),          // in a corner of the room
        look_at(glm::dvec3(-0.6, 0.5, -0.5), glm::dvec3(1, 0.5, 0.1)),  // at the mirror ball's centre
        look_at(glm::dvec3(0, 1, -2.45), glm::dvec3(0.5, 1, -2.45))};   // in the plane of the mirror
    render_all(everything_scene(), eyes);
}

TEST_F(Degenerate, VertexNormalsThatCancelOrPointInside) {
    Scene scene = everything_scene();
    for (const std::size_t ball : {std::size_t{2}, std::size_t{3}}) {
        std::vector<glm::vec3>& normals = scene.meshes[ball].normals;
        for (std::size_t i = 0; i < normals.size(); ++i)
            normals[i] *= i % 2 == 0 ? 1.0f : -1.0f;
    }
    render_all(scene, {everything_camera()});
}

TEST_F(Degenerate, LightInASurfaceAndAtTheEye) {
    Scene scene = everything_scene();
    scene.lights[0].position = glm::dvec3(0.0, 0.0, 0.0);
    scene.lights[1].position = everything_camera().position;
    render_all(scene, {everything_camera()});
}

TEST_F(Degenerate, HugeGroundAndTinyObject) {
    Scene scene;
    add(scene, quad(glm::vec3(-1e6f, 0, 1e6f), glm::vec3(2e6f, 0, 0), glm::vec3(0, 0, -2e6f)),
        lambert(glm::vec3(0.5f)));
    add(scene, icosphere(glm::vec3(0, 1e-3f, 0), 1e-3f, 2), mirror());
    scene.environment = glm::vec3(1.0f);
    render_all(scene, {look_at(glm::dvec3(0, 2e-3, 1e-2), glm::dvec3(0, 1e-3, 0))});
}

// Triangles without area reflect nothing, straddle nothing and move no capture point.
TEST_F(Degenerate, MirrorWithZeroAreaTrianglesLooksTheSame) {
    Scene scene;
    CodedRoom({-2, -1, -2}, {2, 2, 3}).add_to(scene);
    const std::uint32_t ball = add(scene, icosphere(glm::vec3(0.1f, 0.2f, 0.0f), 0.6f, 1), mirror());
    Scene worn = scene;
    std::vector<glm::uvec3>& triangles = worn.meshes[worn.instances[ball].mesh].triangles;
    triangles.insert(triangles.begin() + 7, {{0, 0, 0}, {3, 3, 5}, {4, 6, 4}});
    triangles.insert(triangles.end(), {{1, 2, 2}, {2, 1, 1}});
    const Camera camera = look_at(glm::dvec3(0.3, 1.2, 2.5), glm::dvec3(0.1, 0.2, 0.0), 0.7);
    DrawnScene clean(device(), scene);
    DrawnScene with_worn(device(), worn);
    const MapSettings maps{16, 2, {}};
    for (const DrawnMethod& method : drawn_methods()) {
        const Image image = with_worn.render(method, camera, kSettings, maps, 2).image;
        EXPECT_TRUE(image.pixels == clean.render(method, camera, kSettings, maps, 2).image.pixels) << method;
    }
}

// A plane seen exactly from its edge covers nothing.
TEST_F(Degenerate, EyeInThePlaneOfTheMirrorDoesNotSeeIt) {
    Scene scene;
    CodedRoom({0, 0, 0}, {4, 3, 5}).add_to(scene);
    const Camera camera = look_at(glm::dvec3(2, 1.5, 4.5), glm::dvec3(2, 1.5, 0));
    const Image bare = trace(device(), scene, camera, kSettings, 2).image;
    const MapSettings maps{16, 2, {}};
    const Image drawn = render_with_maps(device(), scene, camera, kSettings, MapKind::cube, maps, 2).image;
    add(scene, quad(glm::vec3(2, 0.5f, 0.5f), glm::vec3(0, 2, 0), glm::vec3(0, 0, 1.5f)), mirror());
    EXPECT_TRUE(trace(device(), scene, camera, kSettings, 2).image.pixels == bare.pixels);
    DrawnScene with_mirror(device(), scene);
    for (const DrawnMethod& method : drawn_methods()) {
        const Image image = with_mirror.render(method, camera, kSettings, maps, 2).image;
        EXPECT_TRUE(image.pixels == drawn.pixels) << method;
    }
}

}  // namespace
}  // namespace utsuri::test
