// SPDX-License-Identifier: Apache-2.0
// direct/sphere-map: the OpenGL 1.x baseline, right where it is defined and wrong where it is known to be.
#include "support/coded_room.h"
#include "support/light_scenes.h"
#include "support/test_device.h"

#include "map_observer.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

namespace utsuri::test {
namespace {

class SphereMap : public DeviceTest {};

void add_ball(Scene& scene, glm::vec3 centre) {
    add(scene, icosphere(centre, 0.05f, 0), mirror());
}

/// OpenGL 2.1, section 2.11.4: the texture coordinate of a reflected direction in eye space, as picture
/// coordinates.
glm::dvec2 opengl_coordinate(const glm::dvec3& world, const Camera& eye) {
    const glm::dvec3 unit = glm::normalize(world);
    const glm::dvec3 r(glm::dot(unit, eye.right), glm::dot(unit, eye.up), -glm::dot(unit, eye.forward));
    const double m = 2.0 * std::sqrt(r.x * r.x + r.y * r.y + (r.z + 1.0) * (r.z + 1.0));
    return 2.0 * glm::dvec2(r.x, r.y) / m;
}

// What a texel has captured lies in a direction whose OpenGL coordinate is that texel. Towards the rim texels
// stretch (2.3 : 1 at a radius of 0.9 of the disc), and a texel's mean over what it covers drifts from its
// centre by its curvature: a quarter of a texel holds to there.
TEST_F(SphereMap, DirectionToTextureAndBack) {
    constexpr std::uint32_t kSize = 128;
    constexpr double kRadius = 0.9;
    const CodedRoom coded({0, 0, 0}, {4, 3, 5});
    const glm::dvec3 centre(1.5, 1.0, 2.0);
    Scene scene;
    coded.add_to(scene);
    add_ball(scene, glm::vec3(centre));
    MapObserver observer(device(), scene, MapKind::sphere, map_settings(kSize));
    const Camera camera = look_at({3, 2, 4}, centre);
    const std::vector<Image> maps = observer.maps(camera);
    ASSERT_EQ(maps.size(), 1u);
    int texels = 0;
    for (std::uint32_t row = 0; row < maps[0].height; ++row) {
        for (std::uint32_t column = 0; column < maps[0].width; ++column) {
            const glm::dvec2 p = texel_centre(column, row, kSize);
            if (glm::length(p) > 1.0 + std::sqrt(2.0) / kSize) {
                ASSERT_EQ(maps[0].at(column, row), glm::vec3(0.0f));
            }
            if (glm::length(p) > kRadius) continue;
            ++texels;
            const glm::dvec3 seen = coded.decode(glm::dvec3(maps[0].at(column, row))) - centre;
            ASSERT_LE(glm::length(opengl_coordinate(seen, camera) - p), 0.25 * 2.0 / kSize)
                << column << ' ' << row;
        }
    }
    EXPECT_GT(texels, 10000);
}

// The map is equal-area: each texel is 16 / N^2 sr. A unit square at distance 1 fills 0.805431683 sr,
// wherever it is.
TEST_F(SphereMap, TexelsHaveEqualSolidAngles) {
    constexpr std::uint32_t kSize = 64;
    // Texels on the outline, of which stretched squares have at most some 200, are uncertain by a binomial
    // share.
    const double bound = kSigmas * std::sqrt(200.0) * 0.5 / std::sqrt(16.0) * 16.0 / (kSize * kSize);
    for (const double angle : {0.0, 0.7, 1.4, 2.1}) {
        Scene scene;
        add(scene, flipped(quad({-0.5f, -0.5f, 1}, {1, 0, 0}, {0, 1, 0})), emitter(glm::vec3(1.0f)));
        scene.instances.back().world_from_object =
            glm::rotate(glm::dmat4(1.0), angle, glm::dvec3(0.6, 0.8, 0));
        add_ball(scene, glm::vec3(0.0f));
        MapObserver observer(device(), scene, MapKind::sphere, map_settings(kSize));
        const Image map = observer.maps(look_at({0, 0, 3}, {0, 0, 0})).front();
        double sum = 0.0;
        for (const glm::vec3& texel : map.pixels) {
            sum += static_cast<double>(texel.x) * 16.0 / (kSize * kSize);
        }
        EXPECT_NEAR(sum, 0.805431683, bound) << "turned by " << angle;
    }
}

// Its coordinates are not projective, so that a plane mirror of two triangles distorts by degrees what the
// polygon map shows to a texel.
TEST_F(SphereMap, DistortsOnPlaneMirrors) {
    constexpr std::uint32_t kSize = 128;
    const CodedRoom hall({-20, -20, -10}, {20, 20, 30});
    const glm::dvec3 capture_point(0, 0, 3);
    Scene scene;
    hall.add_to(scene);
    add(scene, quad({-4, -4, 0}, {8, 0, 0}, {0, 8, 0}), mirror());
    const Camera camera = look_at({0.1, -2, 3}, {0.1, 0, 0}, 1.0);
    RenderSettings settings;
    settings.width = settings.height = 32;
    const auto largest_error = [&](MapKind kind) {
        const Image image = MapObserver(device(), scene, kind, map_settings(kSize, capture_point))
                                .picture(camera, settings, 4);
        const double half = std::tan(0.5 * camera.vertical_fov);
        double largest = 0.0;
        for (std::uint32_t y = 0; y < 32; ++y) {
            for (std::uint32_t x = 0; x < 32; ++x) {
                const glm::dvec2 p = half * (glm::dvec2(x + 0.5, -(y + 0.5)) / 16.0 + glm::dvec2(-1, 1));
                const glm::dvec3 along = camera.forward + p.x * camera.right + p.y * camera.up;
                const glm::dvec3 seen = hall.decode(glm::dvec3(image.at(x, y)));
                largest =
                    std::max(largest, angle_between(seen - capture_point, {along.x, along.y, -along.z}));
            }
        }
        return largest;
    };
    const double polygon = largest_error(MapKind::polygon);
    EXPECT_LE(polygon, 2.0 / kSize);
    EXPECT_GE(largest_error(MapKind::sphere), 10.0 * polygon);
}

}  // namespace
}  // namespace utsuri::test
