// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/options.h"

#include "scene/scene.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace utsuri {

/// Proves before the work that the result for machines can be written where the user wants it.
/// @throws InputError otherwise
void check_json(const CommonOptions& options);

/// Writes the result for machines where the user wants it.
void write_json(const CommonOptions& options, const nlohmann::ordered_json& json);

/// Text for people on standard output; not if quiet, and not where standard output carries JSON.
void print_text(const CommonOptions& options, const std::string& text);

/// Tells on standard error what was ignored, dropped and added, at most a screenful.
void print_notes(const CommonOptions& options, const Notes& notes);

}  // namespace utsuri
