// SPDX-License-Identifier: Apache-2.0
#include "renderers/methods/prepared_maps.h"

#include "renderers/reflection/raster/reflector_drawer.h"

#include "base/stopwatch.h"

#include "interop/bindings.h"
#include "interop/raster.h"
#include "interop/specialization.h"

#include <algorithm>

namespace utsuri {
namespace {

/// Whether it is told how bright reflections can be.
bool bounds_radiance(MapKind kind, const MapSettings& settings) {
    return kind == MapKind::hybrid && settings.tolerance.of == Tolerance::Of::radiance;
}

std::uint32_t distance_size(const Device& device, const ReflectionMaps& maps) {
    return DistanceMaps::size_for(maps.largest_size(), maps.infos().size(),
                                  device.summary().storage_range_bytes);
}

std::optional<DistanceMaps> make_distances(Device& device, const SceneData& data, const ReflectionMaps& maps,
                                           MapKind kind, const MapSettings& settings) {
    if (maps.infos().empty() || (!keeps_distances(kind) && !settings.predicts_errors)) return std::nullopt;
    return std::make_optional<DistanceMaps>(
        device, data, maps.probe_instances(), maps.infos(), distance_size(device, maps),
        bounds_radiance(kind, settings) ? Tolerance::Of::radiance : Tolerance::Of::place);
}

std::optional<RadianceBounds> make_radiance_bounds(Device& device,
                                                   const std::optional<DistanceMaps>& distances, MapKind kind,
                                                   const MapSettings& settings) {
    if (!distances || !bounds_radiance(kind, settings)) return std::nullopt;
    return std::make_optional<RadianceBounds>(device, distances->faces());
}

}  // namespace

GlossyMapSettings glossy_map_settings(MapKind kind, const MapSettings& maps) {
    // Of lobes only the sharpest would see finer maps than that.
    const std::uint32_t size = maps.fitted ? std::min(maps.size, MapSettings().size) : maps.size;
    // By distances, lobes are closer from one point that sees what they reflect than blended with others that
    // may not: glossy_probes_test.cpp.
    const std::uint32_t most_probes = keeps_distances(kind) ? 1 : maps.most_probes;
    return {size, maps.samples, maps.capture_point, most_probes, kind, maps.proxy, maps.shares_room};
}

PreparedMaps::PreparedMaps(Device& device, const SceneData& data, const GpuScene& scene, SurfaceLight& light,
                           const Camera& eye, MapKind kind, const RenderSettings& settings,
                           const MapSettings& map_settings, const std::vector<std::uint32_t>& instances,
                           PreparedMaps* previous)
    : data_(data),
      scene_(scene),
      light_(light),
      settings_(settings),
      kind_(kind),
      maps_(device, data, kind, map_settings, {eye, settings.width, settings.height}, proxy_planes_,
            instances),
      distances_(make_distances(device, data, maps_, kind, map_settings)),
      radiance_bounds_(make_radiance_bounds(device, distances_, kind, map_settings)),
      glossy_maps_(device, data, glossy_map_settings(kind, map_settings), proxy_planes_),
      proxy_plane_buffer_(make_buffer<interop::ProxyPlane>(device, proxy_planes_, "planes of proxies")),
      frame_(device, sizeof(interop::FrameInfo), "frame"),
      capture_(device, scene, light, maps_, settings, map_settings) {
    if (previous == nullptr) return;
    maps_.reuse_from(previous->maps_);
    if (distances_ && previous->distances_) distances_->reuse_from(*previous->distances_);
    if (radiance_bounds_ && previous->radiance_bounds_)
        radiance_bounds_->reuse_from(*previous->radiance_bounds_);
}

void PreparedMaps::update(const SceneChange& change, const Camera& eye, RenderStatistics& statistics,
                          Progress& progress) {
    const bool light_may_have_changed = change.geometry || change.lights;
    const SeenChanges changes(data_, change,
                              light_may_have_changed ? light_.changed() : std::vector<std::uint32_t>());
    maps_.forget(changes);
    if (distances_) distances_->forget(changes);
    if (radiance_bounds_) radiance_bounds_->forget(changes);
    prepare(eye, statistics, progress);
}

void PreparedMaps::prepare(const Camera& eye, RenderStatistics& statistics, Progress& progress) {
    FrameCounts& counts = statistics.prepare_counts;
    const Stopwatch stopwatch;
    double compile_seconds = 0.0;
    accumulate(counts, glossy_maps_.capture(scene_, light_, settings_, compile_seconds, progress));
    if (distances_) accumulate(counts, distances_->capture(scene_, compile_seconds, progress));
    if (radiance_bounds_)
        accumulate(counts, radiance_bounds_->capture(scene_, light_, compile_seconds, progress));
    const double seconds = stopwatch.seconds();
    statistics.prepare_seconds += seconds - compile_seconds;
    statistics.compile_seconds += compile_seconds;
    capture_.prepare(eye, statistics);
}

Bindings PreparedMaps::bindings() const {
    Bindings bindings = scene_.bindings();
    bindings.merge(light_.bindings());
    bindings.merge(maps_.bindings());
    bindings.merge(glossy_maps_.bindings());
    bindings[interop::BINDING_PROXY_PLANES] = &proxy_plane_buffer_;
    bindings[interop::BINDING_FRAME] = &frame_;
    if (distances_) bindings.merge(distances_->bindings());
    if (radiance_bounds_) bindings.merge(radiance_bounds_->bindings());
    return bindings;
}

Specialization PreparedMaps::specialization() const {
    Specialization specialization = maps_.specialise(scene_.specialization());
    specialization[interop::SPEC_HAS_PROXY_PLANES] = proxy_planes_.empty() ? 0 : 1;
    specialization[interop::SPEC_MAP_KIND] = whole_map_kind(kind_);
    specialization[interop::SPEC_MOST_GLOSSY_PROBES] = glossy_maps_.plan().most_probes();
    if (distances_) specialization[interop::SPEC_DISTANCE_SIZE] = distances_->size();
    return specialization;
}

}  // namespace utsuri
