// SPDX-License-Identifier: Apache-2.0
#include "map_observer.h"

#include "support/methods.h"

#include <gtest/gtest.h>

namespace utsuri::test {

MapObserver::MapObserver(Device& device, const Scene& scene, MapKind kind, const MapSettings& settings)
    : device_(device),
      data_(prepare_scene_data(scene)),
      gpu_scene_(device, data_),
      kind_(kind),
      settings_(settings),
      // What is looked at shines by itself.
      light_(kept_light(device, data_, gpu_scene_, evenly_kept(1.0 / 60.0, 4, 0))) {}

Image MapObserver::picture(const Camera& camera, const RenderSettings& settings, std::uint32_t samples) {
    RasterRenderer renderer =
        make_raster(device_, data_, gpu_scene_, light_, camera, kind_, settings, settings_);
    Film film(device_, settings.width, settings.height, "observed film");
    Progress progress;
    renderer.prepare(progress);
    renderer.add_samples(film, samples, progress);
    statistics_ = renderer.statistics();
    EXPECT_EQ(statistics_.counts.nonfinite, 0u);
    EXPECT_EQ(statistics_.prepare_counts.nonfinite, 0u);
    return film.resolve();
}

Estimate MapObserver::look(glm::dvec3 eye, glm::dvec3 target, std::uint32_t samples) {
    RenderSettings settings;
    settings.width = settings.height = kCloseUpSize;
    return estimate_of(picture(look_at(eye, target, kCloseUpAngle), settings, samples));
}

std::vector<Image> MapObserver::maps(const Camera& camera) {
    RenderSettings settings;
    settings.width = settings.height = interop::TILE_SIZE;
    MapSettings all = settings_;
    all.captures_all = true;
    RasterRenderer renderer = make_raster(device_, data_, gpu_scene_, light_, camera, kind_, settings, all);
    Progress progress;
    renderer.prepare(progress);
    std::vector<Image> images;
    for (std::uint32_t face = 0; face < renderer.maps().maps().maps_per_probe(); ++face) {
        images.push_back(renderer.maps().maps().map(0, face));
    }
    return images;
}

}  // namespace utsuri::test
