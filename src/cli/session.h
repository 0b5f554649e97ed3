// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/options.h"
#include "import/gltf.h"
#include "renderers/methods/method.h"

#include <filesystem>
#include <memory>
#include <string>

namespace utsuri {

/// A scene file on the host.
struct LoadedScene {
    Scene scene;
    Notes notes;  ///< all of what was ignored, dropped and added
    double import_seconds = 0.0;
};

LoadedScene load_scene(const std::filesystem::path& path);

/// The camera a user means by an index or a name; the first if the text is empty.
/// @throws UsageError that lists the cameras
const Camera& choose_camera(const Scene& scene, const std::string& wanted);

/// A Vulkan device for one run. With UTSURI_VALIDATION=1 in the environment the validation layer watches, and
/// what it says is an error.
class DeviceSession {
  public:
    explicit DeviceSession(const CommonOptions& options);

    [[nodiscard]] Device& device() { return *device_; }
    /// @throws DeviceError with the validation layer's messages, if there are any
    void check_validation();

  private:
    std::unique_ptr<VulkanInstance> instance_;
    std::unique_ptr<Device> device_;
};

/// Instance as the environment wants it: see DeviceSession.
std::unique_ptr<VulkanInstance> make_instance();

}  // namespace utsuri
