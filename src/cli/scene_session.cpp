// SPDX-License-Identifier: Apache-2.0
#include "cli/scene_session.h"

#include "cli/output.h"

#include "base/error.h"
#include "base/file.h"
#include "base/stopwatch.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>

namespace utsuri {

LoadedScene load_scene(const std::filesystem::path& path) {
    const Stopwatch stopwatch;
    ImportResult result = import_gltf(path);
    LoadedScene loaded;
    loaded.scene = std::move(result.scene);
    for (Notes* notes : {&result.ignored, &result.dropped, &result.added}) {
        loaded.notes.insert(loaded.notes.end(), notes->begin(), notes->end());
    }
    loaded.import_seconds = stopwatch.seconds();
    return loaded;
}

const Camera& choose_camera(const Scene& scene, const std::string& wanted) {
    if (wanted.empty()) return scene.cameras.front();
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), index);
    if (error == std::errc() && end == wanted.data() + wanted.size() && index < scene.cameras.size()) {
        return scene.cameras[index];
    }
    std::string names;
    for (std::size_t i = 0; i < scene.cameras.size(); ++i) {
        if (scene.cameras[i].name == wanted) return scene.cameras[i];
        names += fmt::format("\n  {}: {}", i, scene.cameras[i].name);
    }
    throw UsageError("choose camera", fmt::format("'{}'", wanted), fmt::format("the scene has{}", names));
}

Validation wanted_validation() {
    const char* value = std::getenv("UTSURI_VALIDATION");
    return value != nullptr && std::string_view(value) == "1" ? Validation::on : Validation::off;
}

Session make_session(const CommonOptions& options, const LightSettings& light) {
    return Session({options.device, wanted_validation(), light});
}

std::vector<Method> listed_methods(const LightMethod& light, const std::optional<std::string>& reflections) {
    if (!reflections) return all_methods(light);
    std::vector<Method> methods;
    for (const std::string& name : split_list(*reflections)) {
        const Method method{&light, &find_reflection(name)};
        const bool is_known = std::any_of(methods.begin(), methods.end(), [&](const Method& other) {
            return other.reflection == method.reflection;
        });
        if (is_known)
            throw UsageError("use methods", fmt::format("'{}'", *reflections), name + " is listed twice");
        methods.push_back(method);
    }
    if (methods.empty())
        throw UsageError("use methods", "of an empty list", "expected names such as trace,hybrid");
    return methods;
}

std::filesystem::path result_folder(const std::string& wanted, const std::string& command,
                                    const std::filesystem::path& scene) {
    return wanted.empty() ? command + "-" + scene.stem().string() : wanted;
}

SceneSession::SceneSession(const CommonOptions& common, const PictureOptions& picture,
                           const std::filesystem::path& scene, const std::filesystem::path& folder)
    : loaded_(load_scene(scene)),
      camera_(choose_camera(loaded_.scene, picture.camera)),
      light_settings_(picture.light_settings()),
      session_(make_session(common, light_settings_)),
      progress_(common.quiet) {
    make_output_folder(folder);
    check_json(common);
    progress_.begin("building the BVH");
    session_.set_scene(loaded_.scene);
}

void SceneSession::describe(Comparison& comparison, const std::string& scene,
                            const std::string& command_line) const {
    comparison.scene = scene;
    comparison.light_settings = light_settings_;
    comparison.command = command_line;
    comparison.import_seconds = loaded_.import_seconds;
    comparison.notes = loaded_.notes;
}

void check_validation(Session& session) {
    const std::vector<std::string> messages = session.take_validation_messages();
    if (!messages.empty()) {
        throw DeviceError("validate", session.device().name,
                          fmt::format("{} messages:\n{}", messages.size(), fmt::join(messages, "\n")));
    }
}

}  // namespace utsuri
