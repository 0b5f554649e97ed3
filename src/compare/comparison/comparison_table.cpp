// SPDX-License-Identifier: Apache-2.0
#include "compare/comparison/comparison_table.h"

#include "compare/comparison/reference.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>

namespace utsuri {
namespace {

/// Three significant digits without an exponent, for values in [0.01, 1000).
std::string three_digits(double value) {
    const int decimals = value < 9.995 ? 2 : (value < 99.95 ? 1 : 0);
    return fmt::format("{:.{}f}", value, decimals);
}

template <std::size_t N>
std::string with_unit(double value, double step, const std::array<const char*, N>& units) {
    std::size_t unit = 0;
    while (unit + 1 < N && value >= 999.5) {
        value /= step;
        ++unit;
    }
    return fmt::format("{} {}", three_digits(value), units[unit]);
}

std::string format_metric(double value) {
    if (std::isnan(value)) return "-";
    if (std::isinf(value)) return "inf";
    return fmt::format("{:.3g}", value);
}

constexpr const char* kRow = "{:<20}{:>10}{:>10}{:>11}{:>12}{:>9}{:>9}{:>9}{:>9}{:>9}\n";

std::string metric_rows(const Comparison& comparison, const char* title, Metrics MethodResult::*metrics) {
    std::string text = fmt::format("\n{}\n", title);
    text += fmt::format(kRow, "", "relMSE", "MAPE", "MSE", "PSNR [dB]", "SSIM", "FLIP", "max", "p99.9", "");
    for (const MethodResult& result : comparison.methods) {
        const Metrics& m = result.*metrics;
        text += fmt::format(kRow, method_name(result.method), format_metric(m.rel_mse), format_metric(m.mape),
                            format_metric(m.mse), format_metric(m.psnr), format_metric(m.ssim),
                            format_metric(m.flip), format_metric(m.max), format_metric(m.p999), "");
    }
    return text;
}

std::string cost_row(const std::string& name, const MethodResult& result) {
    return fmt::format(kRow, name, result.samples, format_seconds(result.prepare_seconds),
                       format_seconds(result.compile_seconds), format_seconds(result.frame_seconds),
                       format_seconds(result.frame_seconds / std::max(1u, result.samples)),
                       format_bytes(result.peak_bytes), format_count(static_cast<double>(result.rays)),
                       fmt::format("{:.3g} %", 100.0 * result.traced_fraction), result.nonfinite);
}

std::string format_displacement(double pixels) {
    return std::isinf(pixels) ? "unknown" : three_digits(pixels);
}

constexpr const char* kDisplacementRow = "{:<20}{:>18}{:>15}{:>17}{:>14}{:>12}{:>12}\n";

std::string displacement_rows(const Comparison& comparison) {
    std::string rows;
    for (const MethodResult& result : comparison.methods) {
        if (!result.reflection_errors) continue;
        const ReflectionErrorSummary summary = summarise(*result.reflection_errors);
        rows += fmt::format(
            kDisplacementRow, method_name(result.method), format_displacement(summary.predicted.median),
            format_displacement(summary.predicted.p95), format_displacement(summary.measured.median),
            format_displacement(summary.measured.p95), fmt::format("{:.3g} %", 100.0 * summary.exceeded),
            format_seconds(result.reflection_errors->seconds));
    }
    if (rows.empty()) return rows;
    return "\nby how many pixels what mirrors show is off its place; 95 of 100 mirror pixels are within "
           "p95\n" +
           fmt::format(kDisplacementRow, "", "predicted median", "predicted p95", "measured median",
                       "measured p95", "exceeded", "found in") +
           rows;
}

/// Which errors the noise of the reference makes uncertain.
std::string noise_note(const Comparison& comparison) {
    const std::vector<Method> near = methods_near_noise(comparison);
    if (near.empty()) return {};
    std::vector<std::string> names;
    names.reserve(near.size());
    for (const Method& method : near)
        names.push_back(method_name(method));
    return fmt::format(
        "It is more than a tenth of the MSE of {}: these are not told apart by less than that. A longer "
        "--reference-time or a larger --reference-spp tells more.\n",
        fmt::join(names, ", "));
}

}  // namespace

std::string format_seconds(double seconds) {
    if (seconds >= 119.5) {
        const long whole = std::lround(seconds);
        return fmt::format("{} min {:02} s", whole / 60, whole % 60);
    }
    if (seconds >= 0.9995) return fmt::format("{} s", three_digits(seconds));
    if (seconds >= 0.9995e-3) return fmt::format("{} ms", three_digits(seconds * 1e3));
    return fmt::format("{:.0f} us", seconds * 1e6);
}

std::string format_bytes(std::uint64_t bytes) {
    if (bytes < 1000) return fmt::format("{} B", bytes);
    return with_unit(static_cast<double>(bytes), 1024.0, std::array{"B", "KiB", "MiB", "GiB", "TiB"});
}

std::string format_count(double count) {
    if (count < 999.5) return fmt::format("{:.0f}", count);
    return with_unit(count, 1000.0, std::array{"", "k", "M", "G", "T"});
}

std::string comparison_table(const Comparison& comparison) {
    const Image& picture = comparison.reference.image;
    std::string text = fmt::format(
        "{} on {} ({})\n{} triangles, {} x {} pixels, {} of them reflective; mirrors "
        "followed {} times at most\n{} light{}\n\n",
        comparison.scene, comparison.device.name, comparison.device.driver, comparison.triangles,
        picture.width, picture.height, comparison.reflective_pixels, comparison.settings.max_depth,
        comparison.light->name,
        comparison.settings.kept_light
            ? ", in traced pictures and the reference, too, from where it is kept on surfaces"
            : "");
    text += fmt::format(kRow, "cost", "samples", "prepare", "compile", "frame", "a sample", "memory", "rays",
                        "traced", "non-fin.");
    text += cost_row("reference", comparison.reference);
    for (const MethodResult& result : comparison.methods)
        text += cost_row(method_name(result.method), result);
    text += metric_rows(comparison, "error, whole frame (light in units of the reference's mean)",
                        &MethodResult::metrics);
    if (comparison.reflective_pixels > 0) {
        text += metric_rows(comparison, "error, reflective pixels", &MethodResult::metrics_reflective);
    }
    text += displacement_rows(comparison);
    if (std::isnan(comparison.reference_noise)) {
        text += "\nThe reference's own noise was not estimated: that takes an even number of samples.\n";
    } else {
        text += fmt::format("\nThe reference's own noise: MSE {:.2g}, standard error {:.2g} % of the mean.\n",
                            comparison.reference_noise_mse, 100.0 * comparison.reference_noise);
        text += noise_note(comparison);
    }
    for (const MethodFailure& failure : comparison.failures)
        text += fmt::format("\n{} failed: {}\n", method_name(failure.method), failure.message);
    return text;
}

}  // namespace utsuri
