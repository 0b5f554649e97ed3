// SPDX-License-Identifier: Apache-2.0
// A scene without reflective surfaces pays nothing for reflection mapping, whatever is asked of it.
#include "support/methods.h"
#include "support/test_device.h"

namespace utsuri::test {
namespace {

constexpr RenderSettings kSettings{24, 18, 3, 8};

/// Every kind of light and surface but those that reflect with a lobe, smooth or rough.
Scene without_lobes() {
    Scene scene = everything_scene();
    for (Material& material : scene.materials) {
        if (may_be_mirror(scene, material) || may_be_glossy(scene, material))
            material = lambert(glm::vec3(0.5f));
    }
    return scene;
}

class NoReflection : public DeviceTest {
  protected:
    struct Cost {
        std::uint64_t bytes;
        std::uint64_t rays;
        Image image;
    };

    static Cost render(MapKind kind, const MapSettings& maps) {
        const SceneData data = prepare_scene_data(without_lobes());
        const GpuScene scene(device(), data);
        KeptLight light = kept_light(device(), data, scene, evenly_kept(1.0 / 60.0, 4, 0));
        Progress progress;
        light.get()->fill(progress);
        const std::uint64_t before = device().memory().current;
        RasterRenderer renderer =
            make_raster(device(), data, scene, light, everything_camera(), kind, kSettings, maps);
        renderer.prepare(progress);
        const std::uint64_t bytes = device().memory().current - before;
        Film film(device(), kSettings.width, kSettings.height, "film");
        renderer.add_samples(film, 2, progress);
        EXPECT_EQ(reflectors_of(renderer), nullptr) << "kernels, pipelines and buffers of polygons";
        EXPECT_TRUE(renderer.maps().maps().infos().empty());
        const std::uint64_t rays =
            renderer.statistics().prepare_counts.rays - light.get()->cost().counts.rays;
        return {bytes, rays, film.resolve()};
    }
};

TEST_F(NoReflection, CostsNoMapsNoPolygonsAndNoRays) {
    MapSettings small;
    small.size = 1;
    const Cost least = render(MapKind::sphere, small);
    EXPECT_EQ(least.rays, 0u) << "beyond those that find the light on surfaces";
    MapSettings large;
    large.size = 4096;
    large.polyhedron = platonic_solid("icosahedron");
    large.refinement.edge = 1e-6;
    for (const MapKind kind : kMapKinds) {
        const Cost cost = render(kind, large);
        EXPECT_LE(cost.bytes, least.bytes) << "kind of map " << static_cast<int>(kind);
        EXPECT_EQ(cost.rays, 0u);
        EXPECT_TRUE(cost.image.pixels == least.image.pixels);
    }
}

// The test above must not pass because nothing is ever counted.
TEST_F(NoReflection, WhileAMirrorCosts) {
    const SceneData data = prepare_scene_data(everything_scene());
    const GpuScene scene(device(), data);
    KeptLight light = kept_light(device(), data, scene, evenly_kept(1.0 / 60.0, 4, 0));
    Progress progress;
    const std::shared_ptr<SurfaceLight> filled = light.get();
    filled->fill(progress);
    MapSettings maps;
    maps.size = 8;
    const std::uint64_t before = device().memory().current;
    RasterRenderer small =
        make_raster(device(), data, scene, light, everything_camera(), MapKind::cube, kSettings, maps);
    small.prepare(progress);
    const std::uint64_t small_bytes = device().memory().current - before;
    maps.size = 64;
    RasterRenderer large =
        make_raster(device(), data, scene, light, everything_camera(), MapKind::cube, kSettings, maps);
    large.prepare(progress);
    EXPECT_GT(device().memory().current - before, 2 * small_bytes);
    EXPECT_GT(small.statistics().prepare_counts.rays, light.get()->cost().counts.rays);
    EXPECT_NE(reflectors_of(small), nullptr);
}

}  // namespace
}  // namespace utsuri::test
