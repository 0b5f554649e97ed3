// SPDX-License-Identifier: Apache-2.0
// How many pipelines a device keeps.
#include "renderers/methods/method.h"
#include "support/methods.h"
#include "support/test_device.h"

#include "gpu/pipeline_cache.h"

#include <vector>

namespace utsuri::test {
namespace {

using Pipelines = DeviceTest;

/// Settings of a reflection method that may take pipelines of their own.
std::vector<MapSettings> settings_of(const ReflectionTraits& traits) {
    MapSettings maps{4, 1, {}};
    maps.predicts_errors = traits.predicts_errors;
    std::vector<MapSettings> all = {maps};
    if (traits.has_tolerance) {
        maps.tolerance = {Tolerance::Of::radiance, 0.05};
        all.push_back(maps);
    }
    return all;
}

// What kMostPipelines is derived from.
TEST_F(Pipelines, OfAllMethodsOfASceneAreKept) {
    const RenderSettings settings{16, 12, 1, 8};
    const SceneData data = prepare_scene_data(everything_scene());
    const GpuScene scene(device(), data);
    KeptLight light = kept_light(device(), data, scene, evenly_kept(1.0 / 60.0, 4, 0));
    const Camera camera = everything_camera();
    const RendererInput input{device(), data, scene, light_methods().front(), light, camera};
    Progress progress;
    for (const ReflectionMethod& reflection : reflection_methods()) {
        for (const MapSettings& maps : settings_of(reflection.traits)) {
            const std::unique_ptr<Renderer> renderer = reflection.make(input, settings, maps);
            renderer->prepare(progress);
            if (!reflection.traits.predicts_errors) continue;
            renderer->predict_errors();
            renderer->measure_errors();
        }
    }
    // A cache that dropped some would be full.
    EXPECT_LT(device().pipelines().size(), kMostPipelines);
    EXPECT_GT(device().pipelines().size(), reflection_methods().size()) << "each method has some of its own";
}

}  // namespace
}  // namespace utsuri::test
