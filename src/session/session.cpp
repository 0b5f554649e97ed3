// SPDX-License-Identifier: Apache-2.0
#include "session/session.h"

#include "renderers/film/aov.h"
#include "renderers/film/frame_camera.h"

#include "base/error.h"

#include "session/checked_settings.h"
#include "session/session_state.h"

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

std::vector<std::shared_ptr<PictureState>> SessionState::live_pictures() {
    std::vector<std::shared_ptr<PictureState>> live;
    std::erase_if(pictures, [&](const std::weak_ptr<PictureState>& picture) {
        if (auto held = picture.lock()) {
            live.push_back(std::move(held));
            return false;
        }
        return true;
    });
    return live;
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
void update_all(SessionState& state, const SceneChange& change, Progress& progress) {
    try {
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
    if (!state_->scene) {
        state_->scene.emplace(state_->device, prepare_scene_data(scene));
        return SceneUpdate::rebuilt;
    }
    SceneChange change;
    try {
        change = update_scene_data(state_->scene->data, scene);
        state_->scene->on_device.update(state_->scene->data);
    } catch (...) {
        state_->drop_derived();
        state_->scene.reset();
        throw;
    }
    if (change.rebuilt) {
        state_->drop_derived();
        return SceneUpdate::rebuilt;
    }
    if (change.empty()) return SceneUpdate::unchanged;
    update_all(*state_, change, progress);
    return SceneUpdate::updated;
}

SceneUpdate Session::set_scene(const Scene& scene) {
    Progress silent;
    return set_scene(scene, silent);
}

Picture Session::make_picture(const PictureSettings& settings) {
    Picture picture(state_, checked(settings));
    static_cast<void>(state_->live_pictures());  // forgets those that are gone
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
