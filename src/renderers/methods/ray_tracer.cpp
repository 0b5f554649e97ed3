// SPDX-License-Identifier: Apache-2.0
#include "renderers/methods/ray_tracer.h"

#include "renderers/film/frame_camera.h"

#include "interop/bindings.h"
#include "kernels/trace_kept.h"

#include <algorithm>

namespace utsuri {

RayTracer::RayTracer(const RendererInput& input, const RenderSettings& settings)
    : device_(input.device),
      data_(input.data),
      scene_(input.scene),
      light_method_(input.light),
      kept_light_(settings.kept_light ? input.kept_light.get() : nullptr),
      settings_(settings),
      frame_{{}, settings.seed, std::min(settings.max_depth, input.scene.max_depth()), interop::NONE},
      kernel_(make_kernel()) {
    RayTracer::set_camera(input.camera);
}

FilmKernel RayTracer::make_kernel() const {
    Bindings bindings = scene_.bindings();
    if (kept_light_ == nullptr) {
        return FilmKernel(device_, std::string(light_method_.kernel_name), light_method_.kernel,
                          scene_.specialization(), std::move(bindings));
    }
    bindings.merge(kept_light_->bindings());
    return FilmKernel(device_, "trace_kept", kernels::trace_kept, scene_.specialization(),
                      std::move(bindings));
}

void RayTracer::update(const SceneChange& change, Progress& progress) {
    restart_statistics();
    if (kept_light_ == nullptr || change.empty()) return;
    kept_light_->update(change, progress);
    kept_light_->fill(progress);
    if (change.geometry || change.lights) count_light(kept_light_->cost());
}

void RayTracer::set_camera(const Camera& camera) {
    frame_.camera = make_camera_info(camera, data_.origin, settings_.width, settings_.height);
}

void RayTracer::prepare(Progress& progress) {
    if (kept_light_ != nullptr) {
        kept_light_->fill(progress);
        count_light(kept_light_->cost());
    }
    Film scratch(device_, interop::TILE_SIZE, interop::TILE_SIZE, "warm-up film");
    statistics_.compile_seconds += kernel_.warm_up(scratch);
}

FrameCounts RayTracer::render(Film& film, std::uint32_t count, Progress& progress) {
    return kernel_.add_samples(film, frame_, count, progress);
}

}  // namespace utsuri
