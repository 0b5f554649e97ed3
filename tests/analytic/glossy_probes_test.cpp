// SPDX-License-Identifier: Apache-2.0
// Glossy surfaces with maps from several capture points.
#include "support/light_scenes.h"
#include "support/test_device.h"

#include "glossy_lobes.h"
#include "map_observer.h"
#include "picture_difference.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace utsuri::test {
namespace {

MapSettings from_points(std::uint32_t most) {
    MapSettings settings = map_settings(64);
    settings.most_probes = most;
    return settings;
}

/// A floor of rough metal, 2 m wide, with a wall that shines on one side of a screen.
Scene screened_floor() {
    Scene scene;
    add(scene, ground(1.0f), glossy_metal(0.7f));
    add(scene, quad({0, 0.02f, -1}, {0, 0, 2}, {0, 1, 0}), lambert(glm::vec3(0.0f)));
    add(scene, quad({-1, 0, -1}, {0, 1, 0}, {0, 0, 2}), emitter(glm::vec3(1.0f)));
    return scene;
}

class GlossyProbes : public DeviceTest {
  protected:
    /// Of a square picture of the floor from above.
    static Image floor_from_above(MapObserver& observer, std::uint32_t edge) {
        RenderSettings settings;
        settings.width = settings.height = edge;
        return observer.picture(look_at({0, 8, 1e-3}, {0, 0, 0}, 0.2), settings, 4);
    }
};

/// A room with a floor of rough metal, half of it behind a screen from the lamp.
Scene parted_room(float roughness) {
    Scene scene;
    add(scene, quad({-2, 0, 2}, {4, 0, 0}, {0, 0, -4}), glossy_metal(roughness));
    add(scene, room({-2, -0.2f, -2}, {2, 2.5f, 2}), lambert(glm::vec3(0.6f)));
    add(scene, quad({0.5f, 0, -2}, {0, 0, 2.5f}, {0, 2, 0}), lambert(glm::vec3(0.5f)));
    add(scene, quad({-1.5f, 2.45f, -1}, {1, 0, 0}, {0, 0, 1}), emitter(glm::vec3(10.0f)));
    return scene;
}

class PartedRoom : public DeviceTest {
  protected:
    static RenderSettings settings() {
        RenderSettings result;
        result.width = 48;
        result.height = 32;
        return result;
    }
    static Camera eye() { return look_at({-1.2, 1.8, 1.9}, {0.6, 0, -0.6}, 1.0); }
};

// From one point, on one side of the screen, the floor shows on both sides what is on that one. Four
// points are taken only because each is predicted to lower the mean error; if lobes then took the wrong
// ones, or all alike, the floor would be as wrong as before. Noise of the traced picture may hide no more
// than itself on either side.
TEST_F(PartedRoom, IsCloserToTracingFromFourPointsThanFromOne) {
    Observer tracing(device(), parted_room(0.3f));
    const TracedPicture traced = trace_twice(tracing, eye(), settings(), 128);
    for (const MapKind kind : {MapKind::cube, MapKind::proxy}) {
        const auto difference = [&](std::uint32_t most) {
            MapObserver observer(device(), parted_room(0.3f), kind, from_points(most));
            return mean_difference(observer.picture(eye(), settings(), 4), traced.image);
        };
        EXPECT_LT(difference(4) + traced.noise, difference(1) - traced.noise)
            << "kind of map " << static_cast<int>(kind);
    }
}

// Measured from two points: 0.14 instead of 0.11 at a roughness of 0.3, 0.20 instead of 0.17 at 0.6.
TEST_F(PartedRoom, IsSeenFromOnePointByDistances) {
    const auto pixels = [&](std::uint32_t most) {
        MapObserver observer(device(), parted_room(0.3f), MapKind::distance, from_points(most));
        return observer.picture(eye(), settings(), 1).pixels;
    };
    EXPECT_EQ(pixels(4), pixels(1));
}

// From one pixel to the next a lobe passes each capture point nearer or farther by a pixel at most, so
// the weight of one over the nearest changes by two pixels over the width of the blend, and so does its
// share. Picked one at a time, capture points on both sides of the screen would jump by all that they
// differ.
TEST_F(GlossyProbes, NeighbouringPixelsDifferByNoMoreThanTheWeightsMayChange) {
    constexpr std::uint32_t kEdge = 64;
    const Scene scene = screened_floor();
    const SceneData data = prepare_scene_data(scene);
    const std::vector<Probe> probes =
        place_probes(data, data.requirements.glossy_instances, MapKind::cube, {2, {}});
    ASSERT_EQ(probes.size(), 2u);
    const GlossyMapPlan plan = plan_glossy_maps(data, 64, probes);
    MapObserver observer(device(), scene, MapKind::cube, from_points(2));
    const Image picture = floor_from_above(observer, kEdge);
    const double pixel = 2.0 * 8.0 * std::tan(0.1) / kEdge;
    double most = 0.0;
    double range = 0.0;
    for (std::uint32_t y = 0; y < kEdge; ++y) {
        for (std::uint32_t x = 1; x < kEdge; ++x) {
            const double here = static_cast<double>(picture.pixels[y * kEdge + x].x);
            const double before = static_cast<double>(picture.pixels[y * kEdge + x - 1].x);
            most = std::max(most, std::abs(here - before));
            range = std::max(range, here);
        }
    }
    // The eye turns by a pixel, too, over which a lobe of width alpha changes by no more than its share
    // of that.
    const double turn = 0.2 / kEdge / (0.7 * 0.7);
    EXPECT_LE(most, range * (2.0 * pixel / static_cast<double>(plan.infos[0].blend_width) + turn));
}

TEST_F(GlossyProbes, UniformSurroundingsStayUniform) {
    Scene scene = screened_floor();
    for (Material& material : scene.materials)
        if (material.roughness == 1.0f) material.emissive = glm::vec3(1.0f);
    scene.environment = glm::vec3(1.0f);
    MapObserver one(device(), scene, MapKind::cube, from_points(1));
    MapObserver four(device(), scene, MapKind::cube, from_points(4));
    const Image a = floor_from_above(one, 16);
    const Image b = floor_from_above(four, 16);
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        ASSERT_NEAR(a.pixels[i].x, b.pixels[i].x, 1e-6f) << i;
}

}  // namespace
}  // namespace utsuri::test
