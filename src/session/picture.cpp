// SPDX-License-Identifier: Apache-2.0
#include "session/picture.h"

#include "base/error.h"

#include "session/checked_settings.h"
#include "session/session_state.h"

#include <fmt/format.h>

#include <utility>

namespace utsuri {

Picture::Picture(std::shared_ptr<SessionState> session, const PictureSettings& settings)
    : session_(std::move(session)), state_(std::make_shared<PictureState>()) {
    state_->settings = settings;
    state_->renderer = session_->renderer_for(settings);
}

Picture::Picture(Picture&& other) noexcept = default;
Picture& Picture::operator=(Picture&& other) noexcept {
    // What is on the device goes before the session that it is of.
    state_ = std::move(other.state_);
    session_ = std::move(other.session_);
    return *this;
}
Picture::~Picture() = default;

void Picture::prepare(Progress& progress) {
    if (!state_->renderer) state_->renderer = session_->renderer_for(state_->settings);
    if (state_->is_prepared) return;
    try {
        state_->renderer->prepare(progress);
    } catch (...) {
        state_->drop();
        throw;
    }
    state_->is_prepared = true;
}

Renderer& Picture::renderer() {
    Progress silent;
    prepare(silent);
    return *state_->renderer;
}

void Picture::add_samples(std::uint32_t count, Progress& progress) {
    SilentProgress preparing(progress);
    prepare(preparing);
    const PictureSettings& settings = state_->settings;
    if (!state_->film) {
        state_->film.emplace(session_->device, settings.render.width, settings.render.height, settings.title);
    }
    try {
        state_->renderer->add_samples(*state_->film, count, progress);
    } catch (...) {
        // Some pixels may have a sample that others lack.
        state_->film->clear();
        throw;
    }
}

void Picture::add_samples(std::uint32_t count) {
    Progress silent;
    add_samples(count, silent);
}

void Picture::set_camera(const Camera& camera) {
    state_->settings.camera = checked(camera);
    if (state_->is_prepared) {
        state_->renderer->set_camera(camera);
    } else {
        // What is planned for the first view is planned anew.
        state_->renderer.reset();
    }
    clear();
}

void Picture::clear() {
    if (state_->film) state_->film->clear();
}

std::uint32_t Picture::samples() const {
    return state_->film ? state_->film->samples() : 0;
}

Image Picture::image() const {
    const RenderSettings& settings = state_->settings.render;
    return state_->film ? state_->film->resolve() : Image(settings.width, settings.height);
}

Image Picture::half_image(std::uint32_t half) const {
    if (half > 1) throw UsageError("tell half of the samples", fmt::format("{}", half), "must be 0 or 1");
    const RenderSettings& settings = state_->settings.render;
    return state_->film ? state_->film->resolve_half(half) : Image(settings.width, settings.height);
}

NoiseEstimate Picture::noise() const {
    if (samples() < 2 || samples() % 2 != 0) {
        throw UsageError("estimate noise", fmt::format("of {} samples", samples()),
                         "needs an even number of samples, at least 2");
    }
    return state_->film->estimate_noise();
}

const RenderStatistics& Picture::statistics() const {
    static const RenderStatistics none;
    return state_->renderer ? state_->renderer->statistics() : none;
}

bool Picture::draw_frame() {
    return renderer().draw_frame();
}

std::vector<PredictedError> Picture::predict_errors() {
    return renderer().predict_errors();
}

std::vector<MeasuredError> Picture::measure_errors() {
    return renderer().measure_errors();
}

std::vector<float> Picture::traced_pixels() {
    return renderer().traced_pixels();
}

}  // namespace utsuri
