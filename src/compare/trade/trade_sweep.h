// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/trade/trade.h"

#include <cstdint>
#include <vector>

namespace utsuri {

/// The settings that each of the methods is tried with, around those that are given: maps as large as
/// asked for, smaller, and fitted to pixels, polygons finer than modelled unless their size is given,
/// tolerances half, twice and four times the one asked for.
std::vector<TradeSetting> swept_settings(const std::vector<Method>& methods, const MapSettings& given);

/// The samples per pixel at which a picture is looked at: powers of two, and `most`.
std::vector<std::uint32_t> swept_samples(std::uint32_t most);

}  // namespace utsuri
