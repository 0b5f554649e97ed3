// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/options.h"
#include "import/scene/gltf.h"

#include "session/session.h"

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

/// Whether the environment asks for the validation layer: UTSURI_VALIDATION=1. What that says is an error.
Validation wanted_validation();

/// A session on the device that the options name.
Session make_session(const CommonOptions& options, const LightSettings& light);

/// @throws DeviceError with the validation layer's messages, if there are any
void check_validation(Session& session);

}  // namespace utsuri
