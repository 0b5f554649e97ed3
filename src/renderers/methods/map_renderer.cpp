// SPDX-License-Identifier: Apache-2.0
#include "renderers/methods/map_renderer.h"

#include "renderers/film/frame_camera.h"

#include "base/check.h"

#include <algorithm>
#include <chrono>

namespace utsuri {
namespace {

template <typename Errors>
std::vector<Errors> no_mirrors(const RenderSettings& settings) {
    return std::vector<Errors>(std::size_t{settings.width} * settings.height,
                               Errors{-1.0f, -1.0f, -1.0f, -1.0f});
}

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

MapRenderer::MapRenderer(Device& device, const SceneData& data, const GpuScene& scene, SurfaceLight& light,
                         const Camera& camera, MapKind kind, const RenderSettings& settings,
                         const MapSettings& map_settings)
    : device_(device),
      data_(data),
      scene_(scene),
      camera_(camera),
      settings_(settings),
      map_settings_(map_settings),
      kind_(kind),
      light_(light) {
    make_drawers(nullptr);
}

void MapRenderer::make_drawers(PreparedMaps* former) {
    prepared_ =
        std::make_unique<PreparedMaps>(device_, data_, scene_, light_, camera_, kind_, settings_,
                                       map_settings_, data_.requirements.reflective_instances, former);
    if (!maps().reflectors().triangles.empty()) {
        reflectors_ = std::make_unique<ReflectorDrawer>(
            device_, data_, maps().reflectors(), kind_, maps().faces(), map_settings_.most_cut_pieces,
            map_settings_.tolerance.of, prepared_->specialization(), prepared_->bindings());
    }
    drawer_ =
        std::make_unique<FrameDrawer>(device_, data_, prepared_->specialization(), prepared_->bindings(),
                                      reflectors_.get(), settings_.width, settings_.height);
    eye_moved_ = true;
}

interop::CameraInfo MapRenderer::camera_info() const {
    return make_camera_info(camera_, data_.origin, settings_.width, settings_.height);
}

void MapRenderer::warm_up() {
    const auto start = std::chrono::steady_clock::now();
    drawer_->warm_up();
    reflect();
    statistics_.compile_seconds += seconds_since(start);
}

void MapRenderer::draw_at(const glm::vec2& jitter) {
    drawer_->draw_frame(draw_settings(), jitter);
}

void MapRenderer::prepare(Progress& progress) {
    warm_up();
    prepared_->prepare(
        camera_, [&](const glm::vec2& jitter) { draw_at(jitter); }, statistics_, progress);
}

void MapRenderer::update(const SceneChange& change, Progress& progress) {
    restart_statistics();
    if (change.empty()) return;
    // May put other buffers in the place of those that drawing reads.
    light_.update(change, progress);
    // What draws reads buffers of the maps.
    prediction_drawer_.reset();
    drawer_.reset();
    reflectors_.reset();
    const std::unique_ptr<PreparedMaps> former = std::move(prepared_);
    make_drawers(former.get());
    warm_up();
    prepared_->update(
        change, camera_, [&](const glm::vec2& jitter) { draw_at(jitter); }, statistics_, progress);
}

void MapRenderer::set_camera(const Camera& camera) {
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
        drawer_->draw_frame(draw_settings());
    } while (prepared_->complete(statistics_, silent));
    return true;
}

FrameCounts MapRenderer::render(Film& film, std::uint32_t count, Progress& progress) {
    const double vertex_seconds = eye_moved_ ? reflect() : 0.0;
    FrameCounts counts = drawer_->add_samples(film, draw_settings(), count, progress,
                                              [&] { return prepared_->complete(statistics_, progress); });
    counts.gpu_seconds += vertex_seconds;
    return counts;
}

PredictionDrawer& MapRenderer::prediction_drawer() {
    UTSURI_CHECK(prepared_->has_distances());
    if (eye_moved_) reflect();
    if (!prediction_drawer_) {
        prediction_drawer_.emplace(device_, data_, kind_, maps().faces().size(), prepared_->specialization(),
                                   prepared_->bindings(), *reflectors_, settings_.width, settings_.height);
    }
    return *prediction_drawer_;
}

float MapRenderer::searching_tolerance() const {
    const Tolerance& tolerance = map_settings_.tolerance;
    const bool judges_outline = kind_ == MapKind::hybrid && tolerance.of == Tolerance::Of::place;
    return judges_outline ? static_cast<float>(tolerance.most) : 0.0f;
}

std::vector<PredictedError> MapRenderer::predict_errors() {
    if (!reflectors_) return no_mirrors<PredictedError>(settings_);
    return prediction_drawer().predict(camera_info(), searching_tolerance());
}

std::vector<MeasuredError> MapRenderer::measure_errors() {
    if (!reflectors_) return no_mirrors<MeasuredError>(settings_);
    return prediction_drawer().measure(camera_info(), searching_tolerance());
}

std::vector<float> MapRenderer::traced_pixels() {
    if (kind_ != MapKind::hybrid) return {};
    draw_frame();
    return drawer_->traced_pixels();
}

}  // namespace utsuri
