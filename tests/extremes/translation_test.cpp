// SPDX-License-Identifier: Apache-2.0
// A scene far out is the same scene: it is re-based in float64, so no bit of the picture changes as long as
// float64 holds the coordinates exactly.
#include "support/methods.h"
#include "support/test_device.h"

#include <glm/common.hpp>

namespace utsuri::test {
namespace {

constexpr RenderSettings kSettings{48, 36, 5, 8};
constexpr std::uint32_t kSamples = 2;

/// The nearest multiple of 2^-16 m: with an integer below 2^36 added it still has fewer than 53 bits.
template <typename Vector>
Vector snapped(const Vector& v) {
    return glm::round(v * Vector(65536)) / Vector(65536);
}

Scene snapped_scene() {
    Scene scene = everything_scene();
    for (Mesh& mesh : scene.meshes) {
        for (glm::vec3& position : mesh.positions)
            position = snapped(position);
    }
    for (Light& light : scene.lights)
        light.position = snapped(light.position);
    return scene;
}

Scene moved(Scene scene, const glm::dvec3& offset) {
    for (Instance& instance : scene.instances)
        instance.world_from_object[3] += glm::dvec4(offset, 0.0);
    for (Light& light : scene.lights)
        light.position += offset;
    return scene;
}

Camera moved(Camera camera, const glm::dvec3& offset) {
    camera.position = snapped(camera.position) + offset;
    return camera;
}

class Translation : public DeviceTest {};

TEST_F(Translation, ChangesNoBitOfThePicture) {
    const Scene scene = snapped_scene();
    const Camera camera = moved(everything_camera(), glm::dvec3(0.0));
    const Image traced = trace(device(), scene, camera, kSettings, kSamples).image;
    const MapSettings maps{16, 1, {}};
    const Image mapped =
        render_with_maps(device(), scene, camera, kSettings, MapKind::polygon, maps, kSamples).image;
    for (const glm::dvec3 offset : {glm::dvec3(1e6, -2e6, 3e6), glm::dvec3(-1e9, 1.0, 7e8)}) {
        const Scene there = moved(scene, offset);
        const Camera eye = moved(everything_camera(), offset);
        EXPECT_TRUE(trace(device(), there, eye, kSettings, kSamples).image.pixels == traced.pixels);
        EXPECT_TRUE(render_with_maps(device(), there, eye, kSettings, MapKind::polygon, maps, kSamples)
                        .image.pixels == mapped.pixels);
    }
}

}  // namespace
}  // namespace utsuri::test
