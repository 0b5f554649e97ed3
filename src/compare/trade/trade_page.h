// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/trade/trade.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace utsuri {

/// One HTML5 page with a chart of error against time, a mark for each run, whose picture it shows. UTF-8; all
/// inside, nothing is fetched when it is shown. The element with id "data" holds the JSON of trade_to_json(),
/// the pictures as data URIs under "pictures", the tables of trade_equal.h under "equal", and under "metric"
/// the one that the chart starts with.
std::string make_trade_page(const Trade& trade, std::string_view metric);

/// trade.json and trade.html in a folder that is there.
/// @throws InputError if they cannot be written
void write_trade(const Trade& trade, std::string_view metric, const std::filesystem::path& folder);

}  // namespace utsuri
