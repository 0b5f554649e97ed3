// SPDX-License-Identifier: Apache-2.0
#include "cli/command.h"

#include "base/command_line.h"
#include "base/error.h"
#include "base/progress.h"
#include "base/version.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <vector>

namespace utsuri {
namespace {

/// The command line as a shell would take it, for reports.
std::string command_line(int argc, char** argv) {
    std::vector<std::string> words = {"utsuri"};
    for (int i = 1; i < argc; ++i)
        words.emplace_back(argv[i]);
    return shell_command(words);
}

/// The parser says that a subcommand is missing, but not that the word in its place is none.
void check_subcommand(const CLI::App& app, int argc, char** argv) {
    if (argc < 2 || argv[1][0] == '-') return;
    std::string names;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
        if (command->get_name() == argv[1]) return;
        names += (names.empty() ? "" : ", ") + command->get_name();
    }
    throw UsageError("run", fmt::format("'{}'", argv[1]), fmt::format("there are: {}", names));
}

int exit_status(ExitCode code) {
    return static_cast<int>(code);
}

int run(int argc, char** argv) {
    CLI::App app(
        "Renders a glTF scene by tracing rays and by reflection mapping, and measures what each costs and "
        "how "
        "wrong it is.",
        "utsuri");
    app.set_version_flag("--version", std::string("utsuri ") + kVersion);
    app.require_subcommand(1);
    app.get_formatter()->column_width(34);
    Action action;
    add_compare_command(app, command_line(argc, argv), action);
    add_render_command(app, action);
    add_trade_command(app, command_line(argc, argv), action);
    add_info_command(app, action);
    add_diff_command(app, action);
    add_devices_command(app, action);
    app.footer(
        "Exit codes: 0 success, 1 images differ, 2 wrong usage, 3 bad input, 4 no usable device, 130 "
        "interrupted.\nCtrl-C ends work after the sample or map at hand and keeps what is finished; a second "
        "one ends it at once.\nEnvironment: UTSURI_DEVICE chooses the device, UTSURI_VALIDATION=1 turns "
        "Vulkan validation on.");
    check_subcommand(app, argc, argv);
    try {
        app.parse(argc, argv);
        return exit_status(action());
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? exit_status(ExitCode::success) : exit_status(ExitCode::usage);
    }
}

}  // namespace
}  // namespace utsuri

int main(int argc, char** argv) {
    try {
        return utsuri::run(argc, argv);
    } catch (const utsuri::Interrupted&) {
        std::fputs("utsuri: interrupted\n", stderr);
        return utsuri::exit_status(utsuri::ExitCode::interrupted);
    } catch (const utsuri::Error& error) {
        std::fprintf(stderr, "utsuri: %s\n", error.what());
        return utsuri::exit_status(error.exit_code());
    } catch (const std::bad_alloc&) {
        std::fputs("utsuri: out of memory; use a smaller scene or picture\n", stderr);
        return utsuri::exit_status(utsuri::ExitCode::input);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "utsuri: internal error, please report it: %s\n", error.what());
        return utsuri::exit_status(utsuri::ExitCode::device);
    }
}
