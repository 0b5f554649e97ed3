// SPDX-License-Identifier: Apache-2.0
// Distances of what glossy lobes reflect, and look-ups that they correct.
#include "renderers/reflection/glossy/glossy_maps.h"
#include "support/light_scenes.h"
#include "support/test_device.h"
#include "support/worked_room.h"

#include "glossy_lobes.h"
#include "map_observer.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace utsuri::test {
namespace {

class GlossyDistances : public DeviceTest {
  protected:
    /// Fails where every 61st texel, borders included, of the maps of the scene's first glossy instance is
    /// not what `expect(direction, inverse distance)` asks.
    template <typename Expect>
    static void expect_texels(const Scene& scene, const Expect& expect) {
        constexpr std::uint32_t kEvery = 61;
        const auto expect_face = [&](const GlossyMaps& maps, std::uint32_t face) {
            const std::uint32_t stride = maps.face(0, face).width;
            const std::vector<float> texels = maps.inverse_distances(0, face);
            for (std::uint32_t i = 0; i < texels.size() && !HasFatalFailure(); i += kEvery) {
                expect(glossy_map_direction(face, i % stride, i / stride, stride),
                       static_cast<double>(texels[i]));
            }
        };
        with_glossy_maps(device(), scene, MapKind::distance, map_settings(128, glm::dvec3(0.0)),
                         [&](const GlossyMaps& maps) {
                             for (std::uint32_t face = 0; face < interop::GLOSSY_MAP_FACES; ++face)
                                 expect_face(maps, face);
                         });
    }
};

TEST_F(GlossyDistances, ASphereIsEquallyFarAllOver) {
    constexpr double kRadius = 2.0;
    // Points of a facet are within 0.06 rad of its vertices: a sixteenth of 1.1 rad, over the root of 3, and
    // half as much again where subdivision stretches it.
    const double farthest = 1.0 / (kRadius * std::cos(0.06));
    for (const double alpha : {0.05, 1.0}) {
        Scene scene;
        add(scene, icosphere(glm::vec3(0.0f), 0.1f, 1), metal_of(alpha));
        add(scene, flipped(icosphere(glm::vec3(0.0f), static_cast<float>(kRadius), 4)),
            emitter(glm::vec3(1.0f, 3.0f, 2.0f)));
        expect_texels(scene, [&](const glm::dvec3&, double inverse) {
            ASSERT_GE(inverse, 1.0 / kRadius * (1.0 - 1e-5)) << "alpha " << alpha;
            ASSERT_LE(inverse, farthest) << "alpha " << alpha;
        });
    }
}

// Light from a plane at distance 1 comes, along l, from 1 / l.y away. What is black does not count, however
// near.
TEST_F(GlossyDistances, OfAHalfSpaceMatchQuadrature) {
    for (const double alpha : {0.05, 0.25, 1.0}) {
        Scene scene;
        add(scene, icosphere(glm::vec3(0.0f), 0.1f, 1), metal_of(alpha));
        add(scene, ceiling({0.0f, 1.0f, 0.0f}, 1e4f), emitter(glm::vec3(1.0f, 1e3f, 0.5f)));
        add(scene, quad({-1e4f, -0.5f, 1e4f}, {2e4f, 0, 0}, {0, 0, -2e4f}), lambert(glm::vec3(0.0f)));
        expect_texels(scene, [&](const glm::dvec3& n, double inverse) {
            const double lit = mean_over_lobe(n, alpha, [](const glm::dvec3& l) { return l.y > 0.0; });
            if (lit < 0.5) return;
            const double expected =
                mean_over_lobe(n, alpha, [](const glm::dvec3& l) { return std::max(l.y, 0.0); }) / lit;
            // Both means are right to 5e-3 (AHalfSpaceMatchesQuadrature), over at least a half.
            ASSERT_NEAR(inverse, expected, 2.0 * 5e-3 / 0.5) << "alpha " << alpha;
        });
    }
}

// A lobe of 2e-3 rad shows the place that the ray meets, to the texel: that of the code and that of the
// distance are seen to half of one each. The room is straight, as a box would be, and turned.
TEST_F(GlossyDistances, SharpLobesShowTheTrueHits) {
    constexpr std::uint32_t kSize = 64;
    constexpr unsigned kWallAtLowerZ = 1u << 4;
    struct Ray {
        glm::dvec3 start;  ///< on the wall at z = 0, which is rough
        glm::dvec3 hit;    ///< a sixth of a radian and more from where walls meet
    };
    constexpr Ray kRays[] = {{{0.5, 0.4, 0.0}, {0.8, 0.48, 0.8}},
                             {{0.4, 0.3, 0.0}, {0.65, 0.275, 1.0}},
                             {{0.2, 0.2, 0.0}, {0.2, 0.1, 1.0}},
                             {{0.6, 0.5, 0.0}, {0.8, 0.45, 0.4}}};
    for (const double angle : {0.0, kWorkedTurn}) {
        const CodedWalls walls = turned_room({0, 0, 0}, {0.8, 0.6, 1.0}, angle);
        Scene scene;
        walls.add_to(scene, kWallAtLowerZ);
        add(scene, quad({0, 0, 0}, glm::vec3(turned({0.8, 0, 0}, angle)), {0, 0.6f, 0}), glossy_metal(0.04f));
        const glm::dvec3 capture_point = turned({0.4, 0.3, 0.5}, angle);
        MapObserver observer(device(), scene, MapKind::distance, map_settings(kSize, capture_point));
        for (const Ray& ray : kRays) {
            const glm::dvec3 way = ray.hit - ray.start;
            const glm::dvec3 eye = ray.start + 0.5 * glm::dvec3(-way.x, -way.y, way.z);
            glm::dvec3 radiance = observer.look(turned(eye, angle), turned(ray.start, angle), 4).mean;
            radiance *= std::round(radiance.b) / radiance.b;  // of the lobe's albedo
            const glm::dvec3 seen = walls.decode(radiance);
            EXPECT_LE(angle_between(seen - capture_point, turned(ray.hit, angle) - capture_point),
                      2.0 / kSize)
                << "seen " << seen.x << ' ' << seen.y << ' ' << seen.z << ", turned " << angle;
        }
    }
}

TEST_F(GlossyDistances, CostARayATexelWhereTheyAreKeptAndNothingElsewhere) {
    Scene scene;
    scene.environment = glm::vec3(1.0f);
    add(scene, icosphere(glm::vec3(0.0f), 1.0f, 1), metal_of(0.25));
    const auto rays = [&](MapKind kind) {
        MapObserver observer(device(), scene, kind, map_settings(32));
        observer.look({0, 0, 3}, {0, 0, 0}, 1);
        return observer.statistics().prepare_counts.rays;
    };
    const std::uint64_t without = rays(MapKind::cube);
    EXPECT_EQ(rays(MapKind::proxy), without);
    EXPECT_EQ(rays(MapKind::distance), without + interop::GLOSSY_MAP_FACES * 32u * 32u);
}

}  // namespace
}  // namespace utsuri::test
