// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/metrics.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace utsuri {

/// A metric that is 0 for equal pictures and grows with their difference.
struct ErrorMetric {
    std::string_view name;   ///< as in compare.json
    std::string_view title;  ///< as in tables
    double Metrics::*value;
    /// Whether the reference's noise adds a term of its own: the mean of (b + n)^2, where n has the mean 0,
    /// is that of b^2 and that of n^2.
    bool adds_noise;
};

/// All there are.
std::span<const ErrorMetric> error_metrics();
std::vector<std::string> error_metric_names();

/// @throws UsageError that lists the names there are
const ErrorMetric& parse_error_metric(std::string_view name);

/// The least error that can be told from the noise of the reference. What is measured then is twice what the
/// noise alone shows.
/// @param noise distance of the reference from itself with other noise: see Film::resolve_half()
double least_error(const ErrorMetric& metric, const Metrics& noise);

/// The error of a picture that was measured against a noisy reference: less the noise's own term where it has
/// one, and not below least_error().
double error_beyond_noise(const ErrorMetric& metric, const Metrics& measured, const Metrics& noise);

}  // namespace utsuri
