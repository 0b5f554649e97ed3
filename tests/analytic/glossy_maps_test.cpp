// SPDX-License-Identifier: Apache-2.0
// Glossy lobes of drawn surfaces, looked up in maps convolved with the lobe.
#include "renderers/reflection/glossy/glossy_maps.h"

#include "support/coded_walls.h"
#include "support/light_scenes.h"
#include "support/test_device.h"

#include "glossy_lobes.h"
#include "map_observer.h"
#include "picture_difference.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <map>
#include <numbers>

namespace utsuri::test {
namespace {

/// Of the table of albedos, between its entries.
constexpr double kTable = 5e-3;

class GlossyMapping : public DeviceTest {
  protected:
    /// The faces of the first level of the scene's first glossy instance, with the convention of
    /// shaders/lib/cube.glsl.
    std::vector<Image> level(const Scene& scene, const MapSettings& settings) {
        std::vector<Image> faces;
        with_glossy_maps(device(), scene, MapKind::cube, settings, [&](const GlossyMaps& maps) {
            for (std::uint32_t face = 0; face < interop::GLOSSY_MAP_FACES; ++face)
                faces.push_back(maps.face(0, face));
        });
        return faces;
    }

    /// Fails where every 61st texel, borders included, is farther from `expected(direction)` than the
    /// tolerance.
    template <typename Expected>
    static void expect_level(const std::vector<Image>& faces, const Expected& expected, double tolerance) {
        constexpr std::uint32_t kEvery = 61;
        for (std::uint32_t face = 0; face < faces.size(); ++face) {
            const std::uint32_t stride = faces[face].width;
            for (std::uint32_t i = 0; i < stride * stride; i += kEvery) {
                const glm::dvec3 d = glossy_map_direction(face, i % stride, i / stride, stride);
                ASSERT_NEAR(static_cast<double>(faces[face].pixels[i].x), expected(d), tolerance)
                    << "face " << face << ", texel " << i % stride << ' ' << i / stride;
            }
        }
    }
};

/// Surroundings that shine evenly.
class GlossyFurnace : public GlossyMapping {};

TEST_F(GlossyFurnace, UniformSurroundingsStayUniformToTheBit) {
    for (const double alpha : {0.02, 0.2, 1.0}) {
        Scene scene;
        scene.environment = glm::vec3(1.0f, 0.5f, 0.25f);
        add(scene, icosphere(glm::vec3(0.0f), 1.0f, 1), metal_of(alpha));
        for (const Image& face : level(scene, map_settings(64))) {
            for (const glm::vec3& texel : face.pixels)
                ASSERT_EQ(texel, glm::vec3(1.0f, 0.5f, 0.25f)) << "alpha " << alpha;
        }
    }
}

/// Lights whose share of a lobe is found by quadrature.
class GlossyLights : public GlossyMapping {};

// A half space that shines: the lobe is bright by the share of it that reaches there.
TEST_F(GlossyLights, AHalfSpaceMatchesQuadrature) {
    for (const double alpha : {0.05, 0.25, 1.0}) {
        SCOPED_TRACE(alpha);
        Scene scene;
        add(scene, icosphere(glm::vec3(0.0f), 0.1f, 1), metal_of(alpha));
        add(scene, ceiling({0.0f, 1.0f, 0.0f}, 1e4f), emitter(glm::vec3(1.0f)));
        const auto expected = [&](const glm::dvec3& n) {
            return mean_over_lobe(n, alpha, [](const glm::dvec3& l) { return l.y > 0.0; });
        };
        expect_level(level(scene, map_settings(128, glm::dvec3(0.0))), expected, 5e-3);
    }
}

// A light of 5 degrees, 1000 times as bright as the widest lobe makes it: its light is spread, not lost, and
// no texel is lit by chance.
TEST_F(GlossyLights, ASmallBrightLightMatchesQuadrature) {
    constexpr float kRadiance = 1000.0f;
    constexpr double kHalf = 0.05;
    for (const double alpha : {0.1, 0.3, 1.0}) {
        SCOPED_TRACE(alpha);
        Scene scene;
        add(scene, icosphere(glm::vec3(0.0f), 0.1f, 1), metal_of(alpha));
        add(scene, ceiling({0.2f, 1.0f, 0.1f}, static_cast<float>(kHalf)), emitter(glm::vec3(kRadiance)));
        const double peak =
            mean_over_lobe(glm::normalize(glm::dvec3(0.2, 1.0, 0.1)), alpha, [](const glm::dvec3& l) {
                return l.y > 0.0 && std::abs(l.x / l.y - 0.2) < kHalf && std::abs(l.z / l.y - 0.1) < kHalf;
            });
        // By the midpoint rule over the light, which is small; its share at the peak tells the whole
        // lobe.
        const auto light_of = [&](const glm::dvec3& n) {
            double sum = 0.0;
            constexpr int kSteps = 8;
            for (int i = 0; i < kSteps * kSteps; ++i) {
                const glm::dvec3 l =
                    glm::normalize(glm::dvec3(0.2 + kHalf * (2.0 * (i % kSteps + 0.5) / kSteps - 1.0), 1.0,
                                              0.1 + kHalf * (2.0 * (i / kSteps + 0.5) / kSteps - 1.0)));
                sum += lobe(n, l, alpha);
            }
            return sum;
        };
        const double at_peak = light_of(glm::normalize(glm::dvec3(0.2, 1.0, 0.1)));
        const auto expected = [&](const glm::dvec3& n) {
            return static_cast<double>(kRadiance) * peak * light_of(n) / at_peak;
        };
        // Texels of what is captured are up to an eighth of an alpha wide, or of 1/32.
        expect_level(level(scene, map_settings(128, glm::dvec3(0.0))), expected,
                     0.05 * static_cast<double>(kRadiance) * peak);
    }
}

// White furnace: the pixel is the directional albedo, for every way to look maps up.
TEST_F(GlossyFurnace, FurnaceShowsTheDirectionalAlbedo) {
    struct Row {
        double alpha;
        std::array<double, 3> albedo;
    };
    constexpr std::array<double, 3> kCosines = {1.0, 0.5, 0.25};
    // references.md A3.4
    constexpr std::array<Row, 3> kRows = {{{0.10, {0.988304, 0.969205, 0.921623}},
                                           {0.25, {0.915812, 0.857263, 0.840082}},
                                           {1.00, {0.306853, 0.450694, 0.597641}}}};
    for (const MapKind kind : {MapKind::polygon, MapKind::sphere, MapKind::cube, MapKind::proxy}) {
        for (const Row& row : kRows) {
            Scene scene;
            scene.environment = glm::vec3(1.0f);
            add(scene, ground(1.0f), metal_of(row.alpha));
            MapObserver observer(device(), scene, kind, map_settings(32));
            for (std::size_t i = 0; i < kCosines.size(); ++i) {
                SCOPED_TRACE(testing::Message() << "alpha " << row.alpha << ", cosine " << kCosines[i]);
                const double mu = kCosines[i];
                const Estimate estimate =
                    observer.look({std::sqrt(1.0 - mu * mu), mu, 0.0}, {0.0, 0.0, 0.0}, 1);
                EXPECT_NEAR(estimate.mean.x, row.albedo[i], kTable);
                EXPECT_LE(estimate.mean.x, 1.0);
            }
        }
    }
}

// A rough dielectric in the furnace: what its lobe takes is lost to its Lambert part.
TEST_F(GlossyFurnace, ADielectricAgreesWithTracing) {
    Material material = lambert(glm::vec3(0.6f));
    material.specular = 1.0f;
    material.specular_colour = {0.0f, 1.0f, 20.0f};
    for (const float roughness : {0.3f, 0.7f}) {
        material.roughness = roughness;
        Scene scene;
        scene.environment = glm::vec3(1.0f);
        add(scene, ground(1.0f), material);
        Observer traced(device(), scene);
        MapObserver mapped(device(), scene, MapKind::cube, map_settings(32));
        for (const double mu : {1.0, 0.5, 0.2}) {
            SCOPED_TRACE(testing::Message() << "roughness " << roughness << ", cosine " << mu);
            const glm::dvec3 eye(std::sqrt(1.0 - mu * mu), mu, 0.0);
            const Estimate expected = traced.look(eye, {0, 0, 0}, 256);
            const Estimate found = mapped.look(eye, {0, 0, 0}, 1);
            for (int c = 0; c < 3; ++c) {
                EXPECT_NEAR(found.mean[c], expected.mean[c], kTable + kSigmas * expected.standard_error[c])
                    << "channel " << c;
            }
        }
    }
}

// Lights without extent are in no map. One of them is as exact as traced, and without noise; so is its
// shadow.
TEST_F(GlossyMapping, HighlightsOfPunctualLightsAreThoseOfTracing) {
    Scene scene;
    add(scene, ground(1.0f), metal_of(0.2, 0.7f));
    add(scene, quad({0.4f, 0.5f, -0.1f}, {0.2f, 0, 0}, {0, 0, 0.2f}), lambert(glm::vec3(0.0f)));
    Light point;
    point.position = glm::dvec3(0.0, 1.0, 0.0);
    point.intensity = glm::vec3(2.0f);
    scene.lights = {point};
    Observer traced(device(), scene);
    MapObserver mapped(device(), scene, MapKind::cube, map_settings(32));
    for (const glm::dvec3 target :
         {glm::dvec3(0.3, 0, 0), glm::dvec3(-0.2, 0, 0.5), glm::dvec3(0.95, 0, 0.0)}) {
        const glm::dvec3 eye = target + glm::dvec3(0.5, 0.8, 0.1);
        const double expected = traced.look(eye, target, 4).mean.x;
        EXPECT_NEAR(mapped.look(eye, target, 2).mean.x, expected, 1e-4 * expected) << target.x;
        EXPECT_EQ(expected == 0.0, target.x == 0.95) << "in the shadow";
    }
}

// On a plane interpolated vectors are exact, so that they find the same texels as those of each pixel.
TEST_F(GlossyMapping, InterpolatedVectorsOfAPlaneAreThoseOfItsPixels) {
    Scene scene;
    add(scene, ground(1.0f), metal_of(0.1));
    add(scene, ceiling({0.3f, 1.0f, -0.4f}, 0.5f), emitter(glm::vec3(1.0f)));
    RenderSettings settings;
    settings.width = settings.height = 32;
    const Camera camera = look_at({0.5, 0.7, 1.2}, {0, 0, 0});
    const Image polygon =
        MapObserver(device(), scene, MapKind::polygon, map_settings(64)).picture(camera, settings, 1);
    const Image cube =
        MapObserver(device(), scene, MapKind::cube, map_settings(64)).picture(camera, settings, 1);
    for (std::size_t i = 0; i < cube.pixels.size(); ++i)
        ASSERT_NEAR(polygon.pixels[i].x, cube.pixels[i].x, 1e-3f) << i;
}

/// A room with a panel of light.
Scene lit_room() {
    Scene scene;
    const glm::vec3 colours[] = {{0.8f, 0.2f, 0.2f}, {0.2f, 0.8f, 0.2f}, {0.7f, 0.7f, 0.7f}};
    add(scene, quad({-2, 0, -2}, {0, 0, 4}, {0, 2.5f, 0}), lambert(colours[0]));
    add(scene, quad({2, 0, -2}, {0, 2.5f, 0}, {0, 0, 4}), lambert(colours[1]));
    add(scene, quad({-2, 0, -2}, {0, 2.5f, 0}, {4, 0, 0}), lambert(colours[2]));
    add(scene, quad({-2, 0, 2}, {4, 0, 0}, {0, 2.5f, 0}), lambert(colours[2]));
    add(scene, quad({-2, 0, -2}, {4, 0, 0}, {0, 0, 4}), lambert(colours[2]));
    add(scene, ceiling({0.0f, 2.5f, 0.0f}, 2.0f), lambert(colours[2]));
    add(scene, ceiling({0.3f, 2.45f, 0.2f}, 0.4f), emitter(glm::vec3(20.0f)));
    return scene;
}

Image brightened(Image image, float factor) {
    for (glm::vec3& pixel : image.pixels)
        pixel *= factor;
    return image;
}

class GlossyBall : public DeviceTest {
  protected:
    struct Pictures {
        TracedPicture traced;
        std::map<MapKind, Image> drawn;

        [[nodiscard]] double off(MapKind kind) const { return mean_difference(drawn.at(kind), traced.image); }
    };
    /// Of a ball added to a room.
    static Pictures pictures(Scene room, float roughness, std::initializer_list<MapKind> kinds) {
        RenderSettings settings;
        settings.width = settings.height = 32;
        const Camera camera = look_at({0.0, 1.2, 1.9}, {0.0, 1.0, 0.0}, 0.4);
        add(room, icosphere({0.0f, 1.0f, 0.0f}, 0.3f, 4), glossy_metal(roughness));
        Observer tracing(device(), room);
        Pictures result{trace_twice(tracing, camera, settings, 512), {}};
        for (const MapKind kind : kinds) {
            MapObserver observer(device(), room, kind, map_settings(128));
            result.drawn[kind] = observer.picture(camera, settings, 16);
        }
        return result;
    }
};

// What the round lobes of the split sum and the capture point in the middle of the ball cost has no bound
// that would tell anything. But the picture is one of this roughness: it is nearer to what is traced with it
// than to what is traced with another, and than that is, whose lobes are wider or narrower and reflect
// another share. Lobes are normalised, so that light is moved and not lost: a quarter brighter or darker it
// is farther off. And it is the nearer the more a method knows about where the light comes from: nothing, a
// box, distances.
TEST_F(GlossyBall, InARoomIsCloserToTracingOfItsRoughnessTheMoreIsKnown) {
    std::map<float, Pictures> by_roughness;
    for (const float roughness : {0.3f, 0.5f, 0.8f}) {
        by_roughness.emplace(
            roughness, pictures(lit_room(), roughness, {MapKind::cube, MapKind::proxy, MapKind::distance}));
    }
    for (const auto& [roughness, own] : by_roughness) {
        SCOPED_TRACE(testing::Message() << "roughness " << roughness);
        EXPECT_LT(own.off(MapKind::proxy), own.off(MapKind::cube));
        EXPECT_LT(own.off(MapKind::distance), own.off(MapKind::proxy));
        for (const MapKind kind : {MapKind::proxy, MapKind::distance}) {
            for (const float factor : {0.8f, 1.25f}) {
                EXPECT_LT(own.off(kind) + 2.0 * own.traced.noise,
                          mean_difference(brightened(own.drawn.at(kind), factor), own.traced.image))
                    << "kind of map " << static_cast<int>(kind) << " times " << factor;
            }
        }
        for (const auto& [other_roughness, other] : by_roughness) {
            if (other_roughness == roughness) continue;
            const double noise = own.traced.noise + other.traced.noise;
            const double apart = mean_difference(other.traced.image, own.traced.image);
            for (const MapKind kind : {MapKind::proxy, MapKind::distance}) {
                SCOPED_TRACE(testing::Message() << "kind of map " << static_cast<int>(kind)
                                                << ", traced with roughness " << other_roughness);
                EXPECT_LT(own.off(kind) + noise, mean_difference(own.drawn.at(kind), other.traced.image));
                EXPECT_LT(own.off(kind) + noise, apart);
            }
        }
    }
}

class GlossyBallByACabinet : public GlossyBall {};

// A cabinet a hand's breadth from the ball is no wall of a box.
TEST_F(GlossyBallByACabinet, IsCloserToTracingByDistancesThanByABox) {
    for (const float roughness : {0.15f, 0.3f}) {
        Scene scene = lit_room();
        add(scene, block({0.4f, 0, -0.6f}, {1.0f, 1.8f, 0.8f}), lambert({0.1f, 0.2f, 0.9f}));
        const Pictures seen = pictures(scene, roughness, {MapKind::proxy, MapKind::distance});
        EXPECT_LT(seen.off(MapKind::distance) + seen.traced.noise,
                  seen.off(MapKind::proxy) - seen.traced.noise)
            << "roughness " << roughness;
    }
}

// The same room, ball and eye, straight and turned by 30 degrees: a box stands in for one, planes for the
// other. Maps keep their axes, so the texels differ.
TEST_F(GlossyMapping, ATurnedRoomIsCorrectedLikeAStraightOne) {
    RenderSettings settings;
    settings.width = settings.height = 32;
    const auto picture = [&](double angle) {
        Scene scene;
        turned_room({-2, 0, -1.5}, {2, 2.5, 2.5}, angle).add_to(scene);
        const glm::dvec3 ball = turned({0.3, 1.0, 0.2}, angle);
        add(scene, icosphere(glm::vec3(ball), 0.3f, 4), glossy_metal(0.3f));
        MapObserver observer(device(), scene, MapKind::proxy, map_settings(128));
        return observer.picture(look_at(turned({0.3, 1.2, 2.1}, angle), ball, 0.25), settings, 16);
    };
    EXPECT_LE(mean_difference(picture(std::numbers::pi / 6.0), picture(0.0)), 0.002);
}

}  // namespace
}  // namespace utsuri::test
