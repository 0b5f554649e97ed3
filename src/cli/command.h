// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/error.h"

#include <CLI/App.hpp>

#include <functional>
#include <string>
#include <vector>

namespace utsuri {

/// What main() runs once the command line is understood. Returns the exit code of a run that did not fail.
using Action = std::function<ExitCode()>;

/// Each adds its subcommand, which sets `action` when it is the one that was given.
/// @param command_line the whole command line, for reports
void add_compare_command(CLI::App& app, const std::string& command_line, Action& action);
void add_trade_command(CLI::App& app, const std::string& command_line, Action& action);
void add_render_command(CLI::App& app, Action& action);
void add_info_command(CLI::App& app, Action& action);
void add_diff_command(CLI::App& app, Action& action);
void add_devices_command(CLI::App& app, Action& action);

}  // namespace utsuri
