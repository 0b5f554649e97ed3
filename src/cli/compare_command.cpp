// SPDX-License-Identifier: Apache-2.0
#include "cli/command.h"
#include "cli/output.h"
#include "cli/reference_options.h"
#include "cli/scene_session.h"
#include "compare/comparison/comparison_json.h"
#include "compare/comparison/comparison_table.h"
#include "compare/comparison/run_comparison.h"
#include "compare/comparison/write_comparison.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <limits>
#include <memory>
#include <optional>

namespace utsuri {
namespace {

struct CompareOptions {
    CommonOptions common;
    PictureOptions picture;
    std::string scene;
    std::string folder;
    std::string light = "direct";
    std::optional<std::string> methods;
    std::uint32_t samples = 16;
    ReferenceOptions reference;
    std::optional<double> fail_above;
    bool predictions = false;
};

/// Whether a method is farther from the reference than the user allows.
bool differs(const Comparison& comparison, const CompareOptions& options) {
    if (!options.fail_above) return false;
    bool any = false;
    for (const MethodResult& result : comparison.methods) {
        if (result.metrics.rel_mse <= *options.fail_above) continue;
        fmt::print(stderr, "{}: relMSE {:.3g} is above {:.3g}\n", method_name(result.method),
                   result.metrics.rel_mse, *options.fail_above);
        any = true;
    }
    return any;
}

ComparisonSettings settings_of(const CompareOptions& options) {
    ComparisonSettings settings;
    settings.render = options.picture.render_settings();
    settings.maps = options.picture.map_settings();
    settings.light = &find_light(options.light);
    settings.methods = listed_methods(*settings.light, options.methods);
    settings.samples = options.samples;
    apply(options.reference, settings);
    settings.exposure = options.picture.exposure;
    settings.predictions = options.predictions;
    return settings;
}

ExitCode compare(const CompareOptions& options, const std::string& command_line) {
    const ComparisonSettings settings = settings_of(options);
    const std::filesystem::path folder = result_folder(options.folder, "compare", options.scene);
    SceneSession scene(options.common, options.picture, options.scene, folder);
    Comparison comparison = run_comparison(scene.session(), scene.camera(), settings, scene.progress());
    scene.describe(comparison, options.scene, command_line);
    scene.progress().begin("writing the report");
    write_comparison(comparison, folder);
    scene.progress().clear();

    print_notes(options.common, scene.loaded().notes);
    print_text(options.common, comparison_table(comparison));
    print_text(options.common, fmt::format("\n{}\n", (folder / "report.html").string()));
    write_json(options.common, comparison_to_json(comparison));
    check_validation(scene.session());
    for (const MethodFailure& failure : comparison.failures)
        fmt::print(stderr, "{}: {}\n", method_name(failure.method), failure.message);
    if (comparison.interrupted) return ExitCode::interrupted;
    if (!comparison.failures.empty()) return comparison.failures.front().exit_code;
    return differs(comparison, options) ? ExitCode::difference : ExitCode::success;
}

}  // namespace

void add_compare_command(CLI::App& app, const std::string& command_line, Action& action) {
    auto options = std::make_shared<CompareOptions>();
    CLI::App* command = app.add_subcommand(
        "compare", "Render a scene by several methods and hold them against a ray traced reference");
    command->add_option("scene", options->scene, "glTF scene, .gltf or .glb")->required()->type_name("SCENE");
    command
        ->add_option("-o,--output", options->folder,
                     "Folder for pictures, compare.json and report.html [compare-SCENE]")
        ->type_name("DIR");
    command->add_option("--light", options->light, "Light at diffuse surfaces: " + list_lights())
        ->capture_default_str();
    command->add_option("--methods", options->methods,
                        "Reflections to compare, separated by commas [all of them]");
    command->add_option("--spp", options->samples, "Samples per pixel of each method")
        ->check(CLI::Range(1u, 1u << 24))
        ->capture_default_str();
    add_reference_options(*command, options->reference);
    command
        ->add_option("--fail-above", options->fail_above,
                     "Exit with 1 if the relMSE of a method is above this")
        ->check(finite_range(0.0, std::numeric_limits<double>::max()));
    command->add_flag(
        "--predictions", options->predictions,
        "Tell by how many pixels reflections are predicted to be off their places, by how many "
        "rays measure that they are, and where hybrid traces; found after the methods are timed");
    add_picture_options(*command, options->picture);
    add_common_options(*command, options->common);
    command->callback([=, &action] { action = [=] { return compare(*options, command_line); }; });
}

}  // namespace utsuri
