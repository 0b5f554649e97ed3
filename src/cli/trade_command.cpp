// SPDX-License-Identifier: Apache-2.0
#include "cli/command.h"
#include "cli/output.h"
#include "cli/reference_options.h"
#include "cli/scene_session.h"
#include "cli/trade_choice.h"
#include "compare/trade/run_trade.h"
#include "compare/trade/trade_json.h"
#include "compare/trade/trade_page.h"
#include "compare/trade/trade_table.h"

#include "base/command_line.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>
#include <optional>

namespace utsuri {
namespace {

struct TradeOptions {
    CommonOptions common;
    PictureOptions picture;
    ChoiceOptions choice;
    std::string scene;
    std::string folder;
    std::string light = "direct";
    std::optional<std::string> methods;
    std::uint32_t most_samples = kTradeSamples;
    ReferenceOptions reference;
};

ComparisonSettings settings_of(const TradeOptions& options) {
    const LightMethod& light = find_light(options.light);
    ComparisonSettings settings =
        trade_settings(options.picture, listed_methods(light, options.methods), light);
    settings.samples = options.most_samples;
    apply(options.reference, settings);
    return settings;
}

/// Words that all runs share when `utsuri render` carries them out.
std::vector<std::string> scene_words(const TradeOptions& options, const std::vector<std::string>& given) {
    const std::string stem = std::filesystem::path(options.scene).stem().string();
    std::vector<std::string> words = {options.scene, "-o", stem + ".exr"};
    if (!options.common.device.empty()) words.insert(words.end(), {"--device", options.common.device});
    words.insert(words.end(), given.begin(), given.end());
    return words;
}

/// A setting of the sweep that cannot be carried out here is a finding; a device that fails is not.
ExitCode exit_code(const Trade& trade) {
    if (trade.interrupted) return ExitCode::interrupted;
    for (const TradeFailure& failure : trade.failures) {
        if (failure.exit_code != ExitCode::usage || trade.runs.empty()) return failure.exit_code;
    }
    return ExitCode::success;
}

ExitCode trade(const TradeOptions& options, const std::vector<std::string>& given,
               const std::string& command_line) {
    const ComparisonSettings settings = settings_of(options);
    if (!options.choice.within.empty()) parse_duration(options.choice.within);
    const std::filesystem::path folder = result_folder(options.folder, "trade", options.scene);
    SceneSession scene(options.common, options.picture, options.scene, folder);
    Trade trade = run_trade(scene.session(), scene.camera(), settings, scene.progress());
    scene.describe(trade.basis, options.scene, command_line);
    trade.scene_options = scene_words(options, given);
    scene.progress().begin("writing trade.html");
    write_trade(trade, options.choice.metric, folder);
    if (!trade.interrupted) keep_for_later(scene.session(), scene.camera(), settings, given, trade);
    scene.progress().clear();

    print_notes(options.common, scene.loaded().notes);
    print_text(options.common, trade_table(trade, parse_error_metric(options.choice.metric)));
    print_text(options.common, fmt::format("\n{}\n", (folder / "trade.html").string()));
    check_validation(scene.session());
    nlohmann::ordered_json json = trade_to_json(trade);
    if (options.choice.wanted()) {
        const TradePoint point = choose_run(trade, options.choice);
        const std::string command = shell_command(trade.render_command(trade.runs[point.run]));
        print_text(options.common,
                   fmt::format("\n{}{}\n", choice_text(trade, point, options.choice), command));
        json["choice"] = choice_to_json(trade, point, options.choice);
        json["choice"]["command"] = command;
    }
    write_json(options.common, json);
    return exit_code(trade);
}

}  // namespace

void add_trade_command(CLI::App& app, const std::string& command_line, Action& action) {
    auto options = std::make_shared<TradeOptions>();
    CLI::App* command = app.add_subcommand(
        "trade", "Find what time buys: all methods over their settings, error against time");
    command->add_option("scene", options->scene, "glTF scene, .gltf or .glb")->required()->type_name("SCENE");
    command->add_option("-o,--output", options->folder, "Folder for trade.json and trade.html [trade-SCENE]")
        ->type_name("DIR");
    command->add_option("--light", options->light, "Light at diffuse surfaces: " + list_lights())
        ->capture_default_str();
    command->add_option("--methods", options->methods,
                        "Reflections to try, separated by commas [all of them]");
    command
        ->add_option("--most-spp", options->most_samples,
                     "Most samples per pixel; powers of two up to it are tried")
        ->check(CLI::Range(1u, 1u << 24))
        ->capture_default_str();
    add_reference_options(*command, options->reference);
    add_choice_options(*command, options->choice);
    add_picture_options(*command, options->picture);
    add_common_options(*command, options->common);
    command->footer(
        "Maps of a quarter and all of --map-size and fitted ones are tried, one capture point and several "
        "unless "
        "--probes "
        "sets how many, polygons as modelled and finer unless --polygon-edge or --polygon-error sets theirs, "
        "and "
        "hybrid at a half, once, twice and four times --tolerance.");
    command->callback([=, &action] {
        action = [=] { return trade(*options, given_picture_options(*command), command_line); };
    });
}

}  // namespace utsuri
