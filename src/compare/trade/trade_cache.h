// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/comparison/run_comparison.h"
#include "compare/trade/trade.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace utsuri {

/// All that a trade depends on: contents of the scene, camera, device and driver, picture, options and sweep.
/// @param options words of `utsuri render` that all runs share
nlohmann::ordered_json trade_key(const Session& session, const Camera& camera,
                                 const ComparisonSettings& settings, const std::vector<std::string>& options);

/// The file in `folder` that keeps the trade of a key.
std::filesystem::path trade_file(const std::filesystem::path& folder, const nlohmann::ordered_json& key);

/// The trade that a file keeps, as trade_from_json() gives it; none if there is no such file, it cannot be
/// read, or its key is another.
std::optional<Trade> read_kept_trade(const std::filesystem::path& file, const nlohmann::ordered_json& key);

/// Keeps a trade; the file appears whole or not at all. Makes its folder.
/// @throws InputError if it cannot be written
void keep_trade(const std::filesystem::path& file, const nlohmann::ordered_json& key, const Trade& trade);

}  // namespace utsuri
