// SPDX-License-Identifier: Apache-2.0
#include "session/session.h"

#include "renderers/device_scene/scene_change.h"
#include "renderers/film/aov.h"
#include "renderers/film/frame_camera.h"
#include "renderers/methods/method.h"
#include "renderers/methods/renderer_input.h"

#include "base/error.h"
#include "scene/check_scene.h"

#include "session/checked_settings.h"
#include "session/session_state.h"

#include <utility>

namespace utsuri {

PreparedScene& SessionState::needed_scene() {
    if (!scene) throw UsageError("use a session", "without a scene", "give it one with set_scene() first");
    return *scene;
}

std::unique_ptr<Renderer> SessionState::renderer_for(const PictureSettings& settings) {
    PreparedScene& prepared = needed_scene();
    const LightMethod& light = *settings.method.light;
    KeptLight& kept =
        prepared.lights.try_emplace(&light, device, prepared.data, prepared.on_device, light, light_settings)
            .first->second;
    return make_renderer(settings.method,
                         {device, prepared.data, prepared.on_device, light, kept, settings.camera},
                         settings.render, settings.maps);
}

std::vector<std::shared_ptr<PictureState>> SessionState::live_pictures() const {
    std::vector<std::shared_ptr<PictureState>> live;
    for (const std::weak_ptr<PictureState>& picture : pictures) {
        if (auto held = picture.lock()) live.push_back(std::move(held));
    }
    return live;
}

void SessionState::forget_gone_pictures() {
    std::erase_if(pictures, [](const std::weak_ptr<PictureState>& picture) { return picture.expired(); });
}

void SessionState::drop_unread_light() {
    std::erase_if(scene->lights, [](const auto& light) { return !light.second.is_in_use(); });
}

void SessionState::drop_derived() {
    for (const std::shared_ptr<PictureState>& picture : live_pictures())
        picture->drop();
    if (scene) scene->lights.clear();
}

Session::Session(const SessionSettings& settings)
    : state_(std::make_shared<SessionState>(settings.validation, settings.device, checked(settings.light))) {}

Session::Session(Session&& other) noexcept = default;
Session& Session::operator=(Session&& other) noexcept = default;
Session::~Session() = default;

namespace {

/// Has the scene take over another. If that fails there is none any more: host and device may differ.
SceneChange update_scene(SessionState& state, const Scene& scene) {
    try {
        SceneChange change = update_scene_data(state.scene->data, scene);
        // Makes room: new buffers may be larger than those that they replace.
        if (change.rebuilt) state.drop_derived();
        state.scene->on_device.update(state.scene->data);
        return change;
    } catch (...) {
        state.drop_derived();
        state.scene.reset();
        throw;
    }
}

/// Has a picture take over a change. One that cannot is made anew when it is next used, and tells why then.
void update_picture(PictureState& picture, const SceneChange& change, Progress& progress) {
    if (!picture.is_prepared) return picture.drop();
    try {
        picture.renderer->update(change, progress);
    } catch (const Error&) {
        return picture.drop();
    }
    if (picture.film) picture.film->clear();
}

/// Has lights and pictures take over a change; if that ends half way, all of them are made anew.
void update_derived(SessionState& state, const SceneChange& change, Progress& progress) {
    try {
        state.drop_unread_light();
        for (auto& [method, light] : state.scene->lights)
            light.update(change, progress);
        for (const std::shared_ptr<PictureState>& picture : state.live_pictures())
            update_picture(*picture, change, progress);
    } catch (...) {
        state.drop_derived();
        throw;
    }
}

}  // namespace

SceneUpdate Session::set_scene(const Scene& scene, Progress& progress) {
    check_scene(scene);
    state_->forget_gone_pictures();
    if (!state_->scene) {
        state_->scene.emplace(state_->device, prepare_scene_data(scene));
        return {SceneUpdate::Kind::rebuilt, "there was no scene before it"};
    }
    SceneChange change = update_scene(*state_, scene);
    if (change.rebuilt) return {SceneUpdate::Kind::rebuilt, std::move(change.reason)};
    if (change.empty()) return {SceneUpdate::Kind::unchanged, {}};
    update_derived(*state_, change, progress);
    return {SceneUpdate::Kind::updated, {}};
}

SceneUpdate Session::set_scene(const Scene& scene) {
    Progress silent;
    return set_scene(scene, silent);
}

Picture Session::make_picture(const PictureSettings& settings) {
    Picture picture(state_, checked(settings));
    state_->forget_gone_pictures();
    state_->pictures.push_back(picture.state_);
    return picture;
}

std::vector<interop::AovPixel> Session::first_hits(const Camera& camera, std::uint32_t width,
                                                   std::uint32_t height) const {
    check_picture_size(width, height);
    const PreparedScene& prepared = state_->needed_scene();
    return render_aovs(state_->device, prepared.on_device,
                       make_camera_info(checked(camera), prepared.data.origin, width, height), width, height);
}

const SceneData& Session::scene() const {
    return state_->needed_scene().data;
}

const DeviceSummary& Session::device() const {
    return state_->device.summary();
}

MemoryUsage Session::memory() const {
    return state_->device.memory();
}

void Session::reset_peak_memory() {
    state_->device.reset_peak_memory();
}

std::vector<std::string> Session::take_validation_messages() {
    return state_->instance.validation_messages().take();
}

}  // namespace utsuri
