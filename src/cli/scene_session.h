// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/options.h"
#include "cli/progress_line.h"
#include "compare/comparison/comparison.h"
#include "import/conversion/gltf.h"

#include "session/session.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

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

/// Whether the environment asks for the validation layer: UTSURI_VALIDATION=1. What that says is an error.
Validation wanted_validation();

/// A session on the device that the options name.
Session make_session(const CommonOptions& options, const LightSettings& light);

/// The methods of a light that a user lists by their reflections, separated by commas; all without a list.
/// @throws UsageError if there is none of such a name, or a name is listed twice
std::vector<Method> listed_methods(const LightMethod& light, const std::optional<std::string>& reflections);

/// Where a command writes what it finds about a scene: what the user wants, else a folder named after command
/// and scene.
std::filesystem::path result_folder(const std::string& wanted, const std::string& command,
                                    const std::filesystem::path& scene);

/// A scene on a device, for a command that writes a folder about it.
class SceneSession {
  public:
    /// Imports the scene, proves that the folder can be written, and builds the BVH.
    /// @throws Error if any of that fails
    SceneSession(const CommonOptions& common, const PictureOptions& picture,
                 const std::filesystem::path& scene, const std::filesystem::path& folder);

    [[nodiscard]] const LoadedScene& loaded() const { return loaded_; }
    [[nodiscard]] const Camera& camera() const { return camera_; }
    [[nodiscard]] Session& session() { return session_; }
    [[nodiscard]] ProgressLine& progress() { return progress_; }

    /// Tells where a comparison comes from.
    /// @param scene path as given
    void describe(Comparison& comparison, const std::string& scene, const std::string& command_line) const;

  private:
    LoadedScene loaded_;
    const Camera& camera_;  ///< of the loaded scene
    LightSettings light_settings_;
    Session session_;
    ProgressLine progress_;
};

/// @throws DeviceError with the validation layer's messages, if there are any
void check_validation(Session& session);

}  // namespace utsuri
