// SPDX-License-Identifier: Apache-2.0
// references.md C0 for a scene read from a file: point, spot and area lights, textures, mirrors of three
// sizes.
#include "import/conversion/gltf.h"
#include "support/methods.h"
#include "support/test_device.h"

#include <cmath>
#include <filesystem>

namespace utsuri::test {
namespace {

constexpr RenderSettings kSettings{64, 48, 2, 8};
constexpr std::uint32_t kSamples = 4;

class ScaleOfScenes : public DeviceTest {
  protected:
    static Scene spheres() {
        return import_gltf(std::filesystem::path(UTSURI_SOURCE_DIR) / "scenes" / "spheres" / "spheres.glb")
            .scene;
    }
};

TEST_F(ScaleOfScenes, SpheresAreTheSameBitsAtEveryScale) {
    const Scene scene = spheres();
    const Image traced = trace(device(), scene, scene.cameras.front(), kSettings, kSamples).image;
    const MapSettings maps{32, 2, {}};
    const Image mapped =
        render_with_maps(device(), scene, scene.cameras.front(), kSettings, MapKind::polygon, maps, kSamples)
            .image;
    for (const int k : {-20, -10, 10, 20}) {
        const Scene other = scaled(scene, std::ldexp(1.0, k));
        const Traced result = trace(device(), other, other.cameras.front(), kSettings, kSamples);
        EXPECT_EQ(result.statistics.counts.nonfinite, 0u) << "k = " << k;
        EXPECT_TRUE(result.image.pixels == traced.pixels) << "k = " << k;
        const Image image = render_with_maps(device(), other, other.cameras.front(), kSettings,
                                             MapKind::polygon, maps, kSamples)
                                .image;
        EXPECT_TRUE(image.pixels == mapped.pixels) << "k = " << k;
    }
}

}  // namespace
}  // namespace utsuri::test
