// SPDX-License-Identifier: Apache-2.0
// Over whole scenes, diffuse surfaces lit from light that is kept on them agree with direct/trace.
#include "import/conversion/gltf.h"
#include "renderers/film/aov.h"
#include "renderers/film/frame_camera.h"
#include "renderers/methods/raster_renderer.h"
#include "renderers/methods/ray_tracer.h"
#include "support/methods.h"
#include "support/scenes.h"
#include "support/test_device.h"

#include "image/metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

namespace utsuri::test {
namespace {

constexpr RenderSettings kPicture{128, 96, 5, 8};
/// Of both pictures, so that they smooth edges alike.
constexpr std::uint32_t kDrawnSamples = 16;
constexpr std::uint32_t kTracedSamples = 128;
/// As by default, with a quarter of the rays: what holds here holds by default.
constexpr LightSettings kCoarse{LightSettings().spacing, 16, kPicture.seed};

/// The bounds that docs/architecture.md states.
constexpr double kMostBias = 0.01;     ///< of the mean, which interpolation keeps and leaks do not
constexpr double kMostRelMse = 0.005;  ///< beyond the noise of the traced picture: where shadows end

class LightAgreement : public DeviceTest {
  protected:
    /// Pixels inside surfaces that reflect diffusely and shine not: at edges it is samples that differ.
    static Mask diffuse_mask(const SceneData& data, const GpuScene& scene, const Camera& camera) {
        const auto aovs = render_aovs(device(), scene,
                                      make_camera_info(camera, data.origin, kPicture.width, kPicture.height),
                                      kPicture.width, kPicture.height);
        const auto is_diffuse = [&](const interop::AovPixel& pixel) {
            return pixel.triangle != interop::NONE && pixel.mirror == 0 &&
                   !data.requirements.surfaces[pixel.material].glossy &&
                   data.triangle_infos[pixel.triangle].light == interop::NONE;
        };
        Mask mask(aovs.size(), 0);
        for (std::uint32_t y = 1; y + 1 < kPicture.height; ++y) {
            for (std::uint32_t x = 1; x + 1 < kPicture.width; ++x) {
                const std::size_t pixel = std::size_t{y} * kPicture.width + x;
                bool is_inside = is_diffuse(aovs[pixel]);
                for (const std::size_t other :
                     {pixel - 1, pixel + 1, pixel - kPicture.width, pixel + kPicture.width})
                    is_inside = is_inside && aovs[other].instance == aovs[pixel].instance;
                mask[pixel] = is_inside ? 1 : 0;
            }
        }
        return mask;
    }

    static double sum_over(const Image& image, const Mask& mask) {
        double sum = 0.0;
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            const glm::dvec3 pixel = image.pixels[i];
            if (mask[i] != 0) sum += pixel.x + pixel.y + pixel.z;
        }
        return sum;
    }

    static void expect_agreement(const std::string& name) {
        const auto path = std::filesystem::path(UTSURI_SOURCE_DIR) / "scenes" / name / (name + ".glb");
        const Scene scene = import_gltf(path).scene;
        const SceneData data = prepare_scene_data(scene);
        const GpuScene gpu_scene(device(), data);
        const Camera camera = scene.cameras.front();
        KeptLight light = kept_light(device(), data, gpu_scene, kCoarse);
        MapSettings maps;
        maps.size = maps.samples = 1;  // reflections do not matter here
        RasterRenderer renderer =
            make_raster(device(), data, gpu_scene, light, camera, MapKind::cube, kPicture, maps);
        Progress progress;
        renderer.prepare(progress);
        Film drawn(device(), kPicture.width, kPicture.height, "drawn film");
        renderer.add_samples(drawn, kDrawnSamples, progress);

        const std::unique_ptr<RayTracer> tracer = make_tracer(device(), data, gpu_scene, camera, kPicture);
        tracer->prepare(progress);
        Film traced(device(), kPicture.width, kPicture.height, "traced film");
        tracer->add_samples(traced, kTracedSamples, progress);

        const Mask mask = diffuse_mask(data, gpu_scene, camera);
        const Image reference = traced.resolve();
        const Metrics measured = compute_metrics(reference, drawn.resolve(), nullptr, &mask);
        const Metrics noise = compute_metrics(reference, traced.resolve_half(0), nullptr, &mask);
        const double bias = sum_over(drawn.resolve(), mask) / sum_over(reference, mask) - 1.0;
        RecordProperty("bias", std::to_string(bias));
        RecordProperty("rel_mse", std::to_string(measured.rel_mse - noise.rel_mse));
        EXPECT_GT(measured.pixels, kPicture.width * kPicture.height / 4) << name;
        EXPECT_LE(std::abs(bias), kMostBias) << name;
        EXPECT_LE(measured.rel_mse - noise.rel_mse, kMostRelMse)
            << name << ", with a noise of " << noise.rel_mse;
    }
};

TEST_F(LightAgreement, Cornell) {
    expect_agreement("cornell");
}

TEST_F(LightAgreement, Office) {
    expect_agreement("office-lambert");
}

TEST_F(LightAgreement, ClutteredRoom) {
    expect_agreement("cluttered-mirror");
}

TEST_F(LightAgreement, Corridor) {
    expect_agreement("mirror-corridor");
}

}  // namespace
}  // namespace utsuri::test
