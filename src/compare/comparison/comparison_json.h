// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/comparison/comparison.h"

#include <nlohmann/json_fwd.hpp>

namespace utsuri {

/// Version of the layout that docs/compare-json.md describes.
inline constexpr int kComparisonSchema = 1;

/// Values that do not exist (metrics over no pixels) and infinite ones (PSNR of equal pictures) become null.
nlohmann::ordered_json metrics_to_json(const Metrics& metrics);
/// A result without its errors.
nlohmann::ordered_json result_to_json(const MethodResult& result);
nlohmann::ordered_json device_to_json(const DeviceSummary& device);
nlohmann::ordered_json comparison_to_json(const Comparison& comparison);

}  // namespace utsuri
