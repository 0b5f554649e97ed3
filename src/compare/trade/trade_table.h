// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/trade/error_metric.h"
#include "compare/trade/trade.h"

#include <string>

namespace utsuri {

/// The trade as lines of text for a terminal, at most 110 columns: the front for the time of a frame and the
/// one with preparation, what each method makes of equal times, and what equal errors take it.
std::string trade_table(const Trade& trade, const ErrorMetric& metric);

/// An error with three digits; "<" before one that is hidden in the reference's noise.
std::string format_error(const ErrorMetric& metric, double error, const Metrics& noise);

}  // namespace utsuri
