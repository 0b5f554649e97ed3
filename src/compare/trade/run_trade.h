// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/comparison/run_comparison.h"
#include "compare/trade/trade.h"

namespace utsuri {

/// Renders the reference, then every method with each of its settings, and measures at each number of samples
/// on the way to settings.samples. Each setting is prepared once. Stops early if progress says so, with what
/// was finished. A setting that fails is noted in Trade::failures, and the others go on.
/// @throws Interrupted if the reference was not finished; Error if it fails
Trade run_trade(Session& session, const Camera& camera, const ComparisonSettings& settings,
                Progress& progress);

}  // namespace utsuri
