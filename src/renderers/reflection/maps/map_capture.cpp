// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/maps/map_capture.h"

#include "base/stopwatch.h"

#include "interop/bindings.h"
#include "interop/specialization.h"
#include "kernels/resolve_map.h"
#include "kernels/trace_kept.h"

#include <algorithm>

namespace utsuri {
namespace {

Specialization tracing_specialization(const GpuScene& scene, MapKind kind) {
    Specialization specialization = scene.specialization();
    specialization[interop::SPEC_EXCLUDES_INSTANCE] = 1;
    specialization[interop::SPEC_PROJECTION] =
        kind == MapKind::sphere ? interop::PROJECTION_SPHERE_MAP : interop::PROJECTION_PERSPECTIVE;
    return specialization;
}

Bindings tracing_bindings(const GpuScene& scene, const SurfaceLight& light) {
    Bindings bindings = scene.bindings();
    bindings.merge(light.bindings());
    return bindings;
}

}  // namespace

MapCapture::MapCapture(Device& device, const GpuScene& scene, const SurfaceLight& light, ReflectionMaps& maps,
                       const RenderSettings& settings, const MapSettings& map_settings)
    : device_(device),
      scene_(scene),
      light_(light),
      maps_(maps),
      settings_(settings),
      samples_(map_settings.samples),
      captures_all_(map_settings.captures_all) {}

void MapCapture::prepare(const Camera& eye, RenderStatistics& statistics) {
    statistics.maps = maps_.map_count();
    statistics.captured_maps = maps_.captured_count();
    if (statistics.maps == 0) return;
    const Stopwatch stopwatch;
    maps_.orient_to(eye);
    tracer_.emplace(device_, "trace_kept", kernels::trace_kept, tracing_specialization(scene_, maps_.kind()),
                    tracing_bindings(scene_, light_));
    resolver_.emplace(device_, "resolve_map", kernels::resolve_map, Specialization{},
                      sizeof(interop::ResolveMapPush));
    tracer_->warm_up(film_of(maps_.stride(0)));
    statistics.compile_seconds += stopwatch.seconds();
    if (captures_all_) maps_.want_all();
}

bool MapCapture::capture_missing(RenderStatistics& statistics, Progress& progress) {
    if (!tracer_) return false;
    const std::vector<std::uint32_t> wanted = maps_.wanted();
    if (wanted.empty()) return false;
    std::vector<std::uint32_t> done;
    for (const std::uint32_t map : wanted) {
        if (progress.cancelled()) break;
        accumulate(statistics.prepare_counts, capture(map));
        done.push_back(map);
        progress.update(static_cast<double>(done.size()), static_cast<double>(wanted.size()));
    }
    film_.reset();
    maps_.mark_captured(done);
    statistics.captured_maps = maps_.captured_count();
    return true;
}

Film& MapCapture::film_of(std::uint32_t edge) {
    if (!film_ || film_->width() != edge) {
        film_.reset();
        film_.emplace(device_, edge, edge, "map film");
    }
    return *film_;
}

FrameCounts MapCapture::capture(std::uint32_t map) {
    const std::uint32_t probe = map / maps_.maps_per_probe();
    const std::uint32_t stride = maps_.stride(probe);
    Film& film = film_of(stride);
    film.clear();
    FrameSettings frame;
    frame.camera = maps_.map_camera(map);
    // Any odd multiple of the map's number keeps the samples of maps and picture apart.
    frame.seed = settings_.seed ^ (0x9e3779b9u * (map + 1));
    frame.max_depth = std::min(settings_.max_depth, scene_.max_depth());
    frame.excluded_instance = maps_.reflectors().instances[maps_.probes()[probe].reflector];
    Progress silent;
    FrameCounts counts = tracer_->add_samples(film, frame, samples_, silent);

    const Bindings bindings = maps_.bindings();
    interop::ResolveMapPush push{};
    push.samples = samples_;
    for (const Film::Band& band : film.bands()) {
        push.texels = stride * band.rows;
        push.first_texel = maps_.first_texel(map) + band.first_row * stride;
        const BindingSet set =
            resolver_->bind({{interop::BINDING_FILM, &band.pixels},
                             {interop::BINDING_MAP_TEXELS, bindings.at(interop::BINDING_MAP_TEXELS)}});
        counts.gpu_seconds += device_.run("resolve a map", [&](const vk::raii::CommandBuffer& commands) {
            resolver_->dispatch(commands, set, push, group_count(push.texels));
        });
    }
    return counts;
}

}  // namespace utsuri
