// SPDX-License-Identifier: Apache-2.0
#include "compare/trade/error_metric.h"

#include "base/error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace utsuri {
namespace {

// relMSE divides by the reference, noise included: there the noise's term is right to the first order in the
// noise's variance over (reference^2 + epsilon).
constexpr std::array<ErrorMetric, 6> kMetrics = {{{"rel_mse", "relMSE", &Metrics::rel_mse, true},
                                                  {"mse", "MSE", &Metrics::mse, true},
                                                  {"mape", "MAPE", &Metrics::mape, false},
                                                  {"flip", "FLIP", &Metrics::flip, false},
                                                  {"p999", "p99.9", &Metrics::p999, false},
                                                  {"max", "max", &Metrics::max, false}}};

}  // namespace

std::span<const ErrorMetric> error_metrics() {
    return kMetrics;
}

std::vector<std::string> error_metric_names() {
    std::vector<std::string> names;
    for (const ErrorMetric& metric : kMetrics)
        names.emplace_back(metric.name);
    return names;
}

const ErrorMetric& parse_error_metric(std::string_view name) {
    const auto found = std::find_if(kMetrics.begin(), kMetrics.end(),
                                    [&](const ErrorMetric& metric) { return metric.name == name; });
    if (found != kMetrics.end()) return *found;
    throw UsageError("choose metric", fmt::format("'{}'", name),
                     fmt::format("there are: {}", fmt::join(error_metric_names(), ", ")));
}

double least_error(const ErrorMetric& metric, const Metrics& noise) {
    return (metric.adds_noise ? 1.0 : 2.0) * noise.*metric.value;
}

double error_beyond_noise(const ErrorMetric& metric, const Metrics& measured, const Metrics& noise) {
    const double value = measured.*metric.value;
    if (std::isnan(value)) return value;
    const double error = metric.adds_noise ? value - noise.*metric.value : value;
    return std::max(error, least_error(metric, noise));
}

}  // namespace utsuri
