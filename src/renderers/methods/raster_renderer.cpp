// SPDX-License-Identifier: Apache-2.0
#include "renderers/methods/raster_renderer.h"

#include "renderers/methods/mapped_view.h"
#include "renderers/methods/planar_view.h"
#include "renderers/reflection/raster/picture_pixels.h"

#include "base/check.h"
#include "base/stopwatch.h"

#include "interop/bindings.h"

#include <algorithm>
#include <array>

namespace utsuri {

RasterRenderer::RasterRenderer(const RendererInput& input, const RasterMethod& method,
                               const RenderSettings& settings, const MapSettings& map_settings)
    : device_(require_graphics(input.device)),
      data_(input.data),
      scene_(input.scene),
      light_(input.kept_light.get()),
      method_(method),
      settings_(settings),
      map_settings_(map_settings),
      camera_(input.camera) {}

void RasterRenderer::make_view(PreparedMaps* previous) {
    PlaneMirrors mirrors;
    std::vector<std::uint32_t> instances = data_.requirements.reflective_instances;
    if (method_.draws_mirrored_views) {
        mirrors = find_plane_mirrors(data_);
        instances = curved_instances(data_, mirrors);
    }
    maps_ = std::make_unique<PreparedMaps>(device_, data_, scene_, *light_, camera_, method_.kind, settings_,
                                           map_settings_, instances, previous);
    if (method_.draws_mirrored_views) {
        view_ = std::make_unique<PlanarView>(device_, data_, *maps_, std::move(mirrors), method_.kind,
                                             settings_, map_settings_);
    } else {
        view_ = std::make_unique<MappedView>(device_, data_, *maps_, method_.kind, settings_, map_settings_);
    }
    if (defers_reflections(data_, method_.kind))
        deferred_.emplace(device_, maps_->specialization(), maps_->bindings(), settings_.width,
                          settings_.height);
    samples_.emplace(device_, settings_.width, settings_.height,
                     *maps_->bindings().at(interop::BINDING_MAP_STATES));
    view_->set_camera(camera_);
}

void RasterRenderer::warm_up() {
    const Stopwatch stopwatch;
    view_->warm_up();
    if (deferred_) deferred_->warm_up();
    statistics_.compile_seconds += stopwatch.seconds();
}

void RasterRenderer::prepare(Progress& progress) {
    light_->fill(progress);
    count_light(light_->cost());
    // What draws is bound to the light, which has its size only now.
    if (!view_) make_view(nullptr);
    warm_up();
    maps_->prepare(camera_, statistics_, progress);
    capture_first_view(progress);
}

void RasterRenderer::update(const SceneChange& change, Progress& progress) {
    restart_statistics();
    if (change.empty()) return;
    // May put other buffers in the place of those that drawing reads.
    light_->update(change, progress);
    light_->fill(progress);
    if (change.geometry || change.lights) count_light(light_->cost());
    // What draws reads buffers of the maps.
    samples_.reset();
    deferred_.reset();
    view_.reset();
    const std::unique_ptr<PreparedMaps> previous = std::move(maps_);
    make_view(previous.get());
    warm_up();
    maps_->update(change, camera_, statistics_, progress);
    capture_first_view(progress);
}

void RasterRenderer::capture_first_view(Progress& progress) {
    if (maps_->maps().map_count() == 0) return;
    const Stopwatch stopwatch;
    // What no sample at a corner of a pixel looks up, those in between hardly do; if one does, its map is
    // captured then.
    constexpr float kLast = 0x1.fffffep-1f;
    constexpr std::array kCorners = {glm::vec2(0.0f, 0.0f), glm::vec2(kLast, 0.0f), glm::vec2(0.0f, kLast),
                                     glm::vec2(kLast, kLast)};
    for (const glm::vec2& corner : kCorners) {
        do {
            if (progress.cancelled()) throw Interrupted();
            // What is left to rays looks nothing up.
            interop::FrameInfo frame = frame_settings();
            frame.jitter = corner;
            device_.run("draw a frame",
                        [&](const vk::raii::CommandBuffer& commands) { view_->record(commands, frame); });
        } while (maps_->capture_missing(statistics_, progress));
    }
    statistics_.prepare_seconds += stopwatch.seconds();
}

void RasterRenderer::set_camera(const Camera& camera) {
    camera_ = camera;
    if (view_) view_->set_camera(camera);
}

interop::FrameInfo RasterRenderer::frame_settings() const {
    interop::FrameInfo frame = frame_info(data_, settings_.width, settings_.height);
    frame.seed = settings_.seed;
    frame.max_depth = std::min(settings_.max_depth, scene_.max_depth());
    frame.tolerance = static_cast<float>(map_settings_.tolerance.most);
    return frame;
}

void RasterRenderer::record_picture(const vk::raii::CommandBuffer& commands,
                                    const interop::FrameInfo& frame) const {
    view_->record(commands, frame);
    if (deferred_) deferred_->record(commands, view_->deferred_picture());
}

bool RasterRenderer::draw_frame() {
    view_->prepare_view();
    Progress silent;
    do {
        device_.run("draw a frame", [&](const vk::raii::CommandBuffer& commands) {
            record_picture(commands, frame_settings());
        });
    } while (maps_->capture_missing(statistics_, silent));
    return true;
}

Image RasterRenderer::frame() const {
    Image image(settings_.width, settings_.height);
    const std::vector<glm::vec4> pixels = picture_pixels(device_, view_->picture());
    std::transform(pixels.begin(), pixels.end(), image.pixels.begin(),
                   [](const glm::vec4& pixel) { return glm::vec3(pixel); });
    return image;
}

FrameCounts RasterRenderer::render(Film& film, std::uint32_t count, Progress& progress) {
    UTSURI_CHECK_EQ(film.width(), settings_.width);
    UTSURI_CHECK_EQ(film.height(), settings_.height);
    FrameCounts counts;
    counts.gpu_seconds = view_->prepare_view();
    const interop::FrameInfo frame = frame_settings();
    const auto record = [&](const vk::raii::CommandBuffer& commands, const interop::FrameInfo& of_sample) {
        record_picture(commands, of_sample);
    };
    SilentProgress capturing(progress);
    samples_->begin(film);
    for (std::uint32_t done = 0; done < count && !progress.cancelled();) {
        counts.gpu_seconds += samples_->draw(film, frame, view_->picture(), record);
        // A picture that lacked a map was not added, and is drawn again.
        if (maps_->capture_missing(statistics_, capturing)) continue;
        film.note_samples(1);
        progress.update(++done, count);
    }
    accumulate(counts, samples_->counts());
    return counts;
}

bool RasterRenderer::tells_errors() const {
    return !method_.draws_mirrored_views || method_.kind == MapKind::hybrid;
}

std::vector<PredictedError> RasterRenderer::predict_errors() {
    if (!tells_errors()) return {};
    if (method_.draws_mirrored_views) draw_frame();
    return view_->predict_errors();
}

std::vector<MeasuredError> RasterRenderer::measure_errors() {
    if (!tells_errors()) return {};
    if (method_.draws_mirrored_views) draw_frame();
    return view_->measure_errors();
}

std::vector<float> RasterRenderer::traced_pixels() {
    if (method_.kind != MapKind::hybrid) return {};
    draw_frame();
    return traced_pixels_of(picture_pixels(device_, view_->picture()));
}

}  // namespace utsuri
