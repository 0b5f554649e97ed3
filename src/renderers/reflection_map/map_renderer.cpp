// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection_map/map_renderer.h"

#include "renderers/common/frame_camera.h"
#include "renderers/reflection_map/map_preparation.h"

#include "base/check.h"

#include "interop/specialization.h"

#include <algorithm>
#include <chrono>

namespace utsuri {
namespace {

/// Whether it is told how bright reflections can be.
bool bounds_radiance(MapKind kind, const MapSettings& settings) {
    return kind == MapKind::hybrid && settings.tolerance.of == Tolerance::Of::radiance;
}

std::optional<DistanceMaps> make_distances(Device& device, const SceneData& data, const ReflectionMaps& maps,
                                           MapKind kind, const MapSettings& settings) {
    if (maps.infos().empty() || (!keeps_distances(kind) && !settings.predicts_errors)) return std::nullopt;
    return std::make_optional<DistanceMaps>(
        device, data, maps.instances(), maps.infos(), DistanceMaps::size_for(maps.largest_size()),
        bounds_radiance(kind, settings) ? Tolerance::Of::radiance : Tolerance::Of::place);
}

std::optional<RadianceBounds> make_radiance_bounds(Device& device, const ReflectionMaps& maps, MapKind kind,
                                                   const MapSettings& settings) {
    if (maps.infos().empty() || !bounds_radiance(kind, settings)) return std::nullopt;
    return std::make_optional<RadianceBounds>(device, maps.instances(), maps.infos(),
                                              DistanceMaps::size_for(maps.largest_size()));
}

template <typename Errors>
std::vector<Errors> no_mirrors(const RenderSettings& settings) {
    return std::vector<Errors>(std::size_t{settings.width} * settings.height,
                               Errors{-1.0f, -1.0f, -1.0f, -1.0f});
}

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

MapRenderer::MapRenderer(Device& device, const SceneData& data, const GpuScene& scene, FilledLight& light,
                         const Camera& camera, MapKind kind, const RenderSettings& settings,
                         const MapSettings& map_settings)
    : device_(device),
      data_(data),
      scene_(scene),
      filled_light_(light),
      camera_(camera),
      settings_(settings),
      map_settings_(map_settings),
      kind_(kind),
      maps_(device, data, kind, map_settings, {camera, settings.width, settings.height}),
      distances_(make_distances(device, data, maps_, kind, map_settings)),
      radiance_bounds_(make_radiance_bounds(device, maps_, kind, map_settings)),
      rough_maps_(device, data, rough_map_settings(kind, map_settings)),
      light_cache_(device, data, light.settings),
      capture_(device, scene, light_cache_, maps_, settings, map_settings),
      reflectors_(maps_.reflectors().triangles.empty()
                      ? nullptr
                      : std::make_unique<ReflectorDrawer>(device, data, maps_.reflectors(), kind,
                                                          maps_.faces(), map_settings.most_cut_pieces,
                                                          map_settings.tolerance.of, drawing_specialization(),
                                                          drawing_bindings())),
      drawer_(device, data, drawing_specialization(), drawing_bindings(), reflectors_.get(), settings.width,
              settings.height) {}

Bindings MapRenderer::drawing_bindings() const {
    Bindings bindings = scene_.bindings();
    bindings.merge(light_cache_.bindings());
    bindings.merge(maps_.bindings());
    bindings.merge(rough_maps_.bindings());
    if (distances_) bindings.merge(distances_->bindings());
    if (radiance_bounds_) bindings.merge(radiance_bounds_->bindings());
    return bindings;
}

Specialization MapRenderer::drawing_specialization() const {
    Specialization specialization =
        with_proxies(maps_.specialise(scene_.specialization()), maps_, rough_maps_);
    specialization[interop::SPEC_MAP_KIND] = whole_map_kind(kind_);
    if (distances_) specialization[interop::SPEC_DISTANCE_SIZE] = distances_->size();
    return specialization;
}

interop::CameraInfo MapRenderer::camera_info() const {
    return make_camera_info(camera_, data_.origin, settings_.width, settings_.height);
}

void MapRenderer::prepare(Progress& progress) {
    const auto start = std::chrono::steady_clock::now();
    drawer_.warm_up();
    reflect();
    statistics_.compile_seconds += seconds_since(start);

    prepare_light_and_surroundings(
        scene_, filled_light_, light_cache_,
        {&rough_maps_, distances_ ? &*distances_ : nullptr, radiance_bounds_ ? &*radiance_bounds_ : nullptr},
        settings_, statistics_, progress);
    capture_.prepare(
        camera_, [&](const glm::vec2& jitter) { drawer_.draw_frame(draw_settings(), jitter); }, statistics_,
        progress);
}

void MapRenderer::look_from(const Camera& camera) {
    camera_ = camera;
    eye_moved_ = true;
}

double MapRenderer::reflect() {
    if (!reflectors_) return 0.0;
    interop::ReflectVerticesPush eye{};
    eye.eye = glm::vec3(camera_.position - data_.origin);
    eye.right = glm::vec3(camera_.right);
    eye.up = glm::vec3(camera_.up);
    eye.forward = glm::vec3(camera_.forward);
    eye_moved_ = false;
    return reflectors_->look_from(eye);
}

DrawSettings MapRenderer::draw_settings() const {
    return {camera_info(), settings_.seed, std::min(settings_.specular_depth, scene_.specular_depth()),
            static_cast<float>(map_settings_.tolerance.most)};
}

bool MapRenderer::draw_frame() {
    if (eye_moved_) reflect();
    const Progress silent;
    do {
        drawer_.draw_frame(draw_settings());
    } while (capture_.complete(statistics_, silent));
    return true;
}

FrameCounts MapRenderer::render(Film& film, std::uint32_t count, Progress& progress) {
    const double vertex_seconds = eye_moved_ ? reflect() : 0.0;
    FrameCounts counts = drawer_.add_samples(film, draw_settings(), count, progress,
                                             [&] { return capture_.complete(statistics_, progress); });
    counts.gpu_seconds += vertex_seconds;
    return counts;
}

PredictionDrawer MapRenderer::make_prediction_drawer() {
    UTSURI_CHECK(distances_.has_value());
    if (eye_moved_) reflect();
    return PredictionDrawer(device_, data_, kind_, maps_.faces().size(), drawing_specialization(),
                            drawing_bindings(), *reflectors_, settings_.width, settings_.height);
}

float MapRenderer::searching_tolerance() const {
    const Tolerance& tolerance = map_settings_.tolerance;
    const bool judges_outline = kind_ == MapKind::hybrid && tolerance.of == Tolerance::Of::place;
    return judges_outline ? static_cast<float>(tolerance.most) : 0.0f;
}

std::vector<PredictedError> MapRenderer::predict_errors() {
    if (!reflectors_) return no_mirrors<PredictedError>(settings_);
    return make_prediction_drawer().predict(camera_info(), searching_tolerance());
}

std::vector<MeasuredError> MapRenderer::measure_errors() {
    if (!reflectors_) return no_mirrors<MeasuredError>(settings_);
    return make_prediction_drawer().measure(camera_info(), searching_tolerance());
}

std::vector<float> MapRenderer::traced_pixels() {
    if (kind_ != MapKind::hybrid) return {};
    draw_frame();
    return drawer_.traced_pixels();
}

}  // namespace utsuri
