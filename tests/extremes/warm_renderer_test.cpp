// SPDX-License-Identifier: Apache-2.0
// A renderer learns how much work its device does in a tenth of a second. What it has learnt must not show.
#include "renderers/methods/ray_tracer.h"
#include "support/methods.h"
#include "support/test_device.h"

namespace utsuri::test {
namespace {

using WarmRenderer = DeviceTest;

TEST_F(WarmRenderer, RendersTheSamePictureAgain) {
    const RenderSettings settings{72, 56, 11, 8};
    const SceneData data = prepare_scene_data(everything_scene());
    const GpuScene scene(device(), data);
    const std::unique_ptr<RayTracer> tracer =
        make_tracer(device(), data, scene, everything_camera(), settings);
    Film film(device(), settings.width, settings.height, "film");
    Progress progress;
    // The first sample takes many small dispatches, later ones few.
    tracer->add_samples(film, 8, progress);
    const Image cold = film.resolve();
    for (int run = 0; run < 2; ++run) {
        film.clear();
        tracer->add_samples(film, 8, progress);
        EXPECT_TRUE(film.resolve().pixels == cold.pixels);
    }
}

}  // namespace
}  // namespace utsuri::test
