// SPDX-License-Identifier: Apache-2.0
// What a session and its pictures share. Members go in the reverse of their order: what refers to something
// stands behind it.
#pragma once

#include "renderers/device_scene/gpu_scene.h"
#include "renderers/device_scene/scene_data.h"
#include "renderers/film/film.h"
#include "renderers/light/light.h"
#include "renderers/light/light_settings.h"
#include "renderers/methods/renderer.h"

#include "gpu/device.h"
#include "gpu/vulkan_instance.h"

#include "session/picture.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace utsuri {

struct PictureState {
    PictureSettings settings;
    std::unique_ptr<Renderer> renderer;  ///< none once the scene was rebuilt, until it is needed again
    bool is_prepared = false;
    std::optional<Film> film;

    /// What was made from the scene.
    void drop() {
        film.reset();
        renderer.reset();
        is_prepared = false;
    }
};

/// A scene on the device, and the light kept on its surfaces by each light method that was asked for.
struct PreparedScene {
    PreparedScene(Device& device, SceneData prepared) : data(std::move(prepared)), on_device(device, data) {}

    SceneData data;
    GpuScene on_device;
    std::map<const LightMethod*, KeptLight> lights;
};

struct SessionState {
    SessionState(Validation validation, const std::string& wanted_device, const LightSettings& light)
        : instance(validation), device(instance, wanted_device), light_settings(light) {}

    VulkanInstance instance;
    Device device;
    LightSettings light_settings;
    std::optional<PreparedScene> scene;
    std::vector<std::weak_ptr<PictureState>> pictures;

    /// @throws UsageError if there is none
    PreparedScene& needed_scene();
    /// A renderer of a picture, not prepared.
    /// @throws UsageError without a scene, or if the settings do not fit it
    std::unique_ptr<Renderer> renderer_for(const PictureSettings& settings);
    /// Pictures that are still there.
    [[nodiscard]] std::vector<std::shared_ptr<PictureState>> live_pictures() const;
    void forget_gone_pictures();
    /// Drops light that no renderer reads. It is made anew when it is next needed.
    void drop_unread_light();
    /// Makes pictures and lights anew when they are next needed.
    void drop_derived();
};

}  // namespace utsuri
