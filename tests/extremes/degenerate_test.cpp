// SPDX-License-Identifier: Apache-2.0
// Scenes and pictures at the edge of what there can be: nothing crashes, and pictures are what they must be.
#include "support/coded_room.h"
#include "support/light_scenes.h"
#include "support/methods.h"
#include "support/test_device.h"

#include <glm/geometric.hpp>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

namespace utsuri::test {
namespace {

constexpr RenderSettings kSettings{16, 12, 1, 8};
/// Of the bounds of scenes in support/methods.cpp, where light is kept by drawn methods.
constexpr double kLightSpacing = 1.0 / 60.0;
/// A few roundings of float32, for pictures whose pixels are all equal.
constexpr float kEqual = 1e-6f;

/// Of a picture by a method, or of a traced one.
using Check = std::function<void(const Image&, std::optional<MapKind>)>;

class Degenerate : public DeviceTest {
  protected:
    /// Renders by all methods; pixels must be finite and pass the check, and no sample may be left out.
    /// @param eyes that the scene is seen from, at least one; it is prepared for the first
    void render_all(const Scene& scene, const std::vector<Camera>& eyes, const Check& check,
                    RenderSettings settings = kSettings) {
        for (const Camera& eye : eyes) {
            SCOPED_TRACE(testing::Message() << "traced from " << (&eye - eyes.data()));
            const Traced traced = trace(device(), scene, eye, settings, 2);
            EXPECT_EQ(traced.statistics.counts.nonfinite, 0u);
            expect_finite(traced.image);
            check(traced.image, std::nullopt);
        }
        DrawnScene drawn(device(), scene);
        for (const DrawnMethod& method : drawn_methods()) {
            const auto renderer = drawn.renderer(method, eyes.front(), settings, MapSettings{4, 1, {}});
            Progress progress;
            renderer->prepare(progress);
            for (const Camera& eye : eyes) {
                SCOPED_TRACE(testing::Message() << method << " from " << (&eye - eyes.data()));
                renderer->set_camera(eye);
                Film film(device(), settings.width, settings.height, "film");
                renderer->add_samples(film, 2, progress);
                const Image image = film.resolve();
                expect_finite(image);
                check(image, method.kind);
            }
            const RenderStatistics& statistics = renderer->statistics();
            EXPECT_EQ(statistics.counts.nonfinite + statistics.prepare_counts.nonfinite, 0u) << method;
        }
    }

    static void expect_finite(const Image& image) {
        for (const glm::vec3& pixel : image.pixels)
            ASSERT_TRUE(std::isfinite(pixel.x) && std::isfinite(pixel.y) && std::isfinite(pixel.z));
    }
};

/// All channels of all pixels are between these.
Check between(float least, float most) {
    return [=](const Image& image, std::optional<MapKind>) {
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            for (int c = 0; c < 3; ++c) {
                ASSERT_GE(image.pixels[i][c], least) << "pixel " << i;
                ASSERT_LE(image.pixels[i][c], most) << "pixel " << i;
            }
        }
    };
}

Check all_are(float radiance) {
    return between(radiance * (1.0f - kEqual), radiance * (1.0f + kEqual));
}

/// No light is negative, and some of it arrives.
void expect_lit(const Image& image, std::optional<MapKind> kind = std::nullopt) {
    between(0.0f, std::numeric_limits<float>::max())(image, kind);
    EXPECT_TRUE(
        std::any_of(image.pixels.begin(), image.pixels.end(), [](const glm::vec3& p) { return p.x > 0.0f; }));
}

constexpr std::size_t kMirrorBall = 2;
constexpr std::size_t kGlossyBall = 3;

/// everything_scene(), all of it shining with 1 but for the mirror ball: whatever that shows has a radiance
/// of 1, and so has every pixel, whatever is looked up and wherever rays end.
Scene shining_scene() {
    Scene scene = everything_scene();
    for (std::size_t i = 0; i < scene.materials.size(); ++i)
        if (i != kMirrorBall) scene.materials[i] = emitter(glm::vec3(1.0f));
    for (Material& material : scene.materials)
        material.double_sided = true;
    scene.lights.clear();
    return scene;
}

/// Of shining_scene(). Beyond the rim of a sphere map's disc it is dark, and the maps here have four texels
/// along an edge.
void expect_shining(const Image& image, std::optional<MapKind> kind) {
    (kind == MapKind::sphere ? between(0.0f, 1.0f + kEqual) : all_are(1.0f))(image, kind);
}

/// An empty room of an albedo, with one light.
struct LitRoom {
    CodedRoom room{{-2, 0, -2.5}, {2, 3, 2.5}};
    float albedo = 0.5f;
    Light light;

    explicit LitRoom(const glm::dvec3& position) {
        light.position = position;
        light.intensity = glm::vec3(8.0f);
    }
    [[nodiscard]] Scene scene() const {
        Scene scene;
        add(scene, utsuri::test::room({-2, 0, -2.5f}, {2, 3, 2.5f}), lambert(glm::vec3(albedo)));
        scene.lights = {light};
        return scene;
    }

    struct Bounds {
        double least = std::numeric_limits<double>::infinity();
        double most = 0.0;
    };
    /// Of the radiance in a pixel: a wall's is (albedo / pi) I cos / d^2 (Lambert).
    [[nodiscard]] Bounds bounds(const Camera& eye, std::uint32_t pixel) const {
        constexpr int kSteps = 5;
        const double scale = 2.0 * std::tan(0.5 * eye.vertical_fov) / kSettings.height;
        Bounds result;
        double kept = 0.0;
        for (int i = 0; i < kSteps * kSteps; ++i) {
            const double x = pixel % kSettings.width + (i % kSteps) / (kSteps - 1.0) - 0.5 * kSettings.width;
            const double y = pixel / kSettings.width + (i / kSteps) / (kSteps - 1.0) - 0.5 * kSettings.height;
            const glm::dvec3 place =
                room.wall_point(eye.position, eye.forward + x * scale * eye.right - y * scale * eye.up);
            const double height = light_height(place);
            if (height < 1e-9) {
                // Off by rounding of places, 2^-22 m, over the cube of half a metre or more.
                result.least = 0.0;
                kept = std::max(kept, 1e-5);
                continue;
            }
            const double most = static_cast<double>(albedo) / std::numbers::pi * 8.0 / (height * height);
            const double cosine = height / glm::distance(light.position, place);
            result.least = std::min(result.least, most * cosine * cosine * cosine);
            result.most = std::max(result.most, most * cosine * cosine * cosine);
            // Light is interpolated between points that are h apart, over which it bends by 3 h^2 / height^2
            // of its most: off by half of that.
            const double spacing = kLightSpacing * std::sqrt(4.0 * 4.0 + 3.0 * 3.0 + 5.0 * 5.0);
            kept = std::max(kept, 1.5 * most * spacing * spacing / (height * height));
        }
        // Between places that are a quarter of a pixel apart there is at most a quarter of what they differ
        // by.
        const double slack = (result.most - result.least) / (kSteps - 1) + kept + 1e-5 * result.most;
        return {result.least - slack, result.most + slack};
    }

  private:
    /// Of the light above the wall that a place is on.
    [[nodiscard]] double light_height(const glm::dvec3& place) const {
        const glm::dvec3 lower = room.decode(glm::dvec3(0.0));
        const glm::dvec3 upper = room.decode(glm::dvec3(1.0));
        int axis = 0;
        double nearest = std::numeric_limits<double>::infinity();
        for (int i = 0; i < 3; ++i) {
            const double distance = std::min(place[i] - lower[i], upper[i] - place[i]);
            if (distance >= nearest) continue;
            nearest = distance;
            axis = i;
        }
        return std::abs(light.position[axis] - place[axis]);
    }
};

float mean_of_row(const Image& image, std::uint32_t row) {
    float sum = 0.0f;
    for (std::uint32_t x = 0; x < image.width; ++x)
        sum += image.pixels[row * image.width + x].x;
    return sum / static_cast<float>(image.width);
}

TEST_F(Degenerate, EmptySceneShowsTheSurroundings) {
    Scene scene;
    scene.environment = glm::vec3(1, 2, 3);
    const Camera camera = look_at(glm::dvec3(0), glm::dvec3(0, 0, -1));
    render_all(scene, {camera}, [](const Image& image, std::optional<MapKind>) {
        EXPECT_THAT(image.pixels, testing::Each(glm::vec3(1, 2, 3)));
    });
}

/// No light, and lights at odd places.
class DegenerateLights : public Degenerate {};

TEST_F(DegenerateLights, SceneWithoutLightIsBlack) {
    Scene scene;
    add(scene, icosphere(glm::vec3(0), 1.0f, 1), mirror());
    render_all(scene, {look_at(glm::dvec3(0, 0, 5), glm::dvec3(0))}, all_are(0.0f));
}

// Nothing shades the triangle, and it reflects half of what is about it.
TEST_F(Degenerate, OneTriangle) {
    Scene scene;
    Mesh mesh = quad(glm::vec3(-1, -1, 0), glm::vec3(2, 0, 0), glm::vec3(0, 2, 0));
    mesh.triangles.resize(1);
    add(scene, mesh, lambert(glm::vec3(0.5f)));
    scene.environment = glm::vec3(1.0f);
    render_all(scene, {look_at(glm::dvec3(0, 0, 3), glm::dvec3(0))},
               [](const Image& image, std::optional<MapKind> kind) {
                   between(0.5f * (1.0f - kEqual), 1.0f)(image, kind);
                   const auto [least, most] =
                       std::minmax_element(image.pixels.begin(), image.pixels.end(),
                                           [](const glm::vec3& a, const glm::vec3& b) { return a.x < b.x; });
                   EXPECT_NEAR(least->x, 0.5f, kEqual) << "the triangle";
                   EXPECT_EQ(most->x, 1.0f) << "beside it";
               });
}

TEST_F(Degenerate, ZeroAreaTrianglesAreNeverHit) {
    Material shining = lambert(glm::vec3(0.5f));
    shining.emissive = glm::vec3(100.0f);
    for (const float half : {1.0f, 0.0f}) {
        SCOPED_TRACE(half > 0.0f ? "on a line" : "all in one point");
        Scene scene;
        Mesh mesh;
        mesh.positions = {{-half, 0, 0}, {half, 0, 0}, {0, 0, 0}, {0, 0, 0}};
        mesh.normals.assign(4, glm::vec3(0, 0, 1));
        mesh.triangles = {{0, 1, 2}, {2, 3, 2}, {0, 1, 1}};
        add(scene, mesh, shining);
        scene.environment = glm::vec3(1.0f);
        render_all(scene, {look_at(glm::dvec3(0, 0, 3), glm::dvec3(0))}, between(1.0f, 1.0f));
    }
}

// Each pixel shows one of them, but where their diagonals are, and every picture the same ones.
TEST_F(Degenerate, CoincidentTrianglesHaveAStableWinner) {
    Scene scene;
    for (int i = 0; i < 5; ++i) {
        add(scene, quad(glm::vec3(-3, -3, 0), glm::vec3(6, 0, 0), glm::vec3(0, 6, 0)),
            emitter(glm::vec3(static_cast<float>(i + 1))));
    }
    const Camera camera = look_at(glm::dvec3(0, 0, 3), glm::dvec3(0));
    const Image first = trace(device(), scene, camera, kSettings, 1).image;
    EXPECT_THAT(first.pixels, testing::Each(testing::Truly([](const glm::vec3& pixel) {
                    return pixel.x >= 1.0f && pixel.x <= 5.0f && pixel.x == std::round(pixel.x);
                })));
    EXPECT_TRUE(trace(device(), scene, camera, kSettings, 1).image.pixels == first.pixels);
    render_all(scene, {camera}, between(1.0f, 5.0f));
}

/// Odd pictures and eyes of good scenes.
class DegenerateViews : public Degenerate {};

TEST_F(DegenerateViews, PicturesOfOnePixelEdges) {
    for (const glm::uvec2 size : {glm::uvec2(1, 1), glm::uvec2(1, 67), glm::uvec2(67, 1), glm::uvec2(9, 7)}) {
        SCOPED_TRACE(testing::Message() << size.x << " x " << size.y);
        const RenderSettings settings{size.x, size.y, 0, 2};
        render_all(everything_scene(), {everything_camera()}, expect_lit, settings);
        render_all(shining_scene(), {everything_camera()}, expect_shining, settings);
    }
}

TEST_F(DegenerateViews, EyeOnASurfaceAndInAVertex) {
    const std::vector<Camera> eyes = {
        look_at(glm::dvec3(0, 0, 0), glm::dvec3(0, 1, -1)),            // on the floor
        look_at(glm::dvec3(-2, 0, -2.5), glm::dvec3(-1, 0.8, -1.5)),   // in a corner of the room
        look_at(glm::dvec3(0, 1, -2.45), glm::dvec3(0.5, 1, -2.45))};  // in the plane of the mirror
    render_all(everything_scene(), eyes, expect_lit);
    render_all(shining_scene(), eyes, expect_shining);
}

// Rays never leave it, so that what is traced is black; maps show what is outside.
TEST_F(DegenerateViews, EyeInsideTheBall) {
    const Camera eye = look_at(glm::dvec3(-0.6, 0.5, -0.5), glm::dvec3(1, 0.5, 0.1));
    const auto traced_is_black = [](const Check& mapped) {
        return [=](const Image& image, std::optional<MapKind> kind) {
            const bool is_traced = !kind || *kind == MapKind::hybrid;
            (is_traced ? between(0.0f, 0.0f) : mapped)(image, kind);
        };
    };
    render_all(everything_scene(), {eye}, traced_is_black(expect_lit));
    render_all(shining_scene(), {eye}, traced_is_black(expect_shining));
}

TEST_F(Degenerate, VertexNormalsThatCancelOrPointInside) {
    const auto spoilt = [](Scene scene) {
        for (const std::size_t ball : {kMirrorBall, kGlossyBall}) {
            std::vector<glm::vec3>& normals = scene.meshes[ball].normals;
            for (std::size_t i = 0; i < normals.size(); ++i)
                normals[i] *= i % 2 == 0 ? 1.0f : -1.0f;
        }
        return scene;
    };
    render_all(spoilt(everything_scene()), {everything_camera()}, expect_lit);
    render_all(spoilt(shining_scene()), {everything_camera()}, expect_shining);
}

TEST_F(DegenerateLights, LightInASurfaceAndAtTheEye) {
    Scene scene = everything_scene();
    scene.lights[0].position = glm::dvec3(0.0, 0.0, 0.0);
    scene.lights[1].position = everything_camera().position;
    render_all(scene, {everything_camera()}, expect_lit);
}

// Nothing is in a shadow that the eye sees.
TEST_F(DegenerateLights, LightAtTheEyeLightsAllThatIsSeen) {
    const Camera eye = everything_camera();
    const LitRoom lit(eye.position);
    render_all(lit.scene(), {eye}, [&](const Image& image, std::optional<MapKind>) {
        for (std::uint32_t i = 0; i < image.pixels.size(); ++i) {
            const LitRoom::Bounds bounds = lit.bounds(eye, i);
            ASSERT_GE(static_cast<double>(image.pixels[i].x), bounds.least) << "pixel " << i;
            ASSERT_LE(static_cast<double>(image.pixels[i].x), bounds.most) << "pixel " << i;
        }
    });
}

// It is on either side of the surface, so that walls are lit by it or not; the surface itself is not.
TEST_F(DegenerateLights, LightInASurfaceIsNoBrighterThanBeforeIt) {
    const Camera eye = look_at(glm::dvec3(0.3, 2.0, 1.5), glm::dvec3(0.2, 0.6, -2.5));
    const LitRoom lit(glm::dvec3(0.1, 0.0, -0.2));
    render_all(lit.scene(), {eye}, [&](const Image& image, std::optional<MapKind>) {
        for (std::uint32_t i = 0; i < image.pixels.size(); ++i) {
            ASSERT_GE(image.pixels[i].x, 0.0f) << "pixel " << i;
            ASSERT_LE(static_cast<double>(image.pixels[i].x), lit.bounds(eye, i).most) << "pixel " << i;
        }
    });
}

TEST_F(Degenerate, HugeGroundAndTinyObject) {
    // No place where light is kept, in whose shadow all that is about it would be.
    const glm::dvec3 ball(0.4, 1e-3, 0.3);
    for (const float half : {1e2f, 1e6f}) {
        SCOPED_TRACE(half);
        Scene scene;
        add(scene, ground(half), lambert(glm::vec3(0.5f)));
        add(scene, icosphere(glm::vec3(ball), 1e-3f, 2), mirror());
        scene.environment = glm::vec3(1.0f);
        const Camera eye = look_at(ball + glm::dvec3(0, 1e-3, 1e-2), ball);
        // Where a ray meets a triangle is off by some roundings of that triangle's size, 2^-24 each: beyond
        // the eye's height it is open whether the ground is seen at all.
        const bool is_met = std::ldexp(static_cast<double>(half), -20) < eye.position.y;
        render_all(scene, {eye}, [&](const Image& image, std::optional<MapKind> kind) {
            between(0.0f, 1.0f + kEqual)(image, kind);
            EXPECT_EQ(mean_of_row(image, 0), 1.0f) << "above the horizon";
            // Less than a tenth of what shines on the ground there is covered by the ball.
            if (is_met) {
                EXPECT_LE(mean_of_row(image, image.height - 1), 0.5f + kEqual);
                EXPECT_GE(mean_of_row(image, image.height - 1), 0.25f);
            }
        });
    }
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
        expect_lit(image);
        EXPECT_TRUE(image.pixels == clean.render(method, camera, kSettings, maps, 2).image.pixels) << method;
    }
}

// A plane seen exactly from its edge covers nothing.
TEST_F(DegenerateViews, EyeInThePlaneOfTheMirrorDoesNotSeeIt) {
    Scene scene;
    CodedRoom({0, 0, 0}, {4, 3, 5}).add_to(scene);
    const Camera camera = look_at(glm::dvec3(2, 1.5, 4.5), glm::dvec3(2, 1.5, 0));
    const Image bare = trace(device(), scene, camera, kSettings, 2).image;
    expect_lit(bare);
    const MapSettings maps{16, 2, {}};
    const Image drawn = render_with_maps(device(), scene, camera, kSettings, MapKind::cube, maps, 2).image;
    expect_lit(drawn);
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
