// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/comparison/run_comparison.h"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace utsuri {

/// How good the reference is to be that methods are held against.
struct ReferenceOptions {
    std::optional<std::uint32_t> samples;
    std::string time = "2min";
};

/// Adds --reference-spp and --reference-time.
void add_reference_options(CLI::App& command, ReferenceOptions& options);

/// @throws UsageError if the time is none
void apply(const ReferenceOptions& options, ComparisonSettings& settings);

}  // namespace utsuri
