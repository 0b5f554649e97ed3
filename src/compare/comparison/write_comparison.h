// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/comparison/comparison.h"

#include <filesystem>

namespace utsuri {

/// Writes pictures (.exr, .png), error maps and those of predictions (.png), compare.json and report.html
/// into a folder that exists.
/// @throws InputError naming what cannot be written
void write_comparison(const Comparison& comparison, const std::filesystem::path& folder);

}  // namespace utsuri
