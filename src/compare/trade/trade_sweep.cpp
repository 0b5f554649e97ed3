// SPDX-License-Identifier: Apache-2.0
#include "compare/trade/trade_sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>

namespace utsuri {
namespace {

/// Sizes of maps tried, as shares of the size asked for.
constexpr std::array kMapScales = {0.25, 1.0};
/// Interpolation errors of polygons tried, in degrees: a texel of a map of 256 is a third of a degree.
constexpr std::array kPolygonErrors = {4.0, 1.0};
/// Capture points of a reflector that are tried beside one.
constexpr std::uint32_t kSeveralProbes = 4;

/// Tolerances of hybrid tried beside the one asked for, as multiples of it.
constexpr std::array kToleranceScales = {0.5, 2.0, 4.0};

TradeSetting with_fitted_maps(TradeSetting setting) {
    setting.maps.fitted = true;
    setting.maps.size = kMostFittedMapSize;
    setting.maps.shares_room = false;
    setting.options.insert(setting.options.end(), {"--map-size", "fit"});
    return setting;
}

TradeSetting with_map_size(TradeSetting setting, std::uint32_t size) {
    setting.maps.size = size;
    setting.maps.shares_room = false;  // as the option has it
    setting.options.insert(setting.options.end(), {"--map-size", fmt::format("{}", size)});
    return setting;
}

TradeSetting with_polygon_error(TradeSetting setting, double degrees) {
    setting.maps.refinement.error = degrees * std::numbers::pi / 180.0;
    setting.options.insert(setting.options.end(), {"--polygon-error", fmt::format("{}", degrees)});
    return setting;
}

TradeSetting with_probes(TradeSetting setting, std::uint32_t most) {
    setting.maps.most_probes = most;
    setting.options.insert(setting.options.end(), {"--probes", fmt::format("{}", most)});
    return setting;
}

TradeSetting with_tolerance(TradeSetting setting, double most) {
    Tolerance& tolerance = setting.maps.tolerance;
    tolerance.most = most;
    const bool is_share = tolerance.of == Tolerance::Of::radiance;
    setting.options.insert(
        setting.options.end(),
        {"--tolerance", is_share ? fmt::format("{:.10g}%", 100.0 * most) : fmt::format("{:.10g}", most)});
    return setting;
}

/// Beside the one asked for, each once.
std::vector<double> other_tolerances(const Tolerance& given) {
    const bool is_share = given.of == Tolerance::Of::radiance;
    std::vector<double> tolerances;
    for (const double scale : kToleranceScales) {
        const double most = std::clamp(scale * given.most, is_share ? kLeastRadianceTolerance : 0.0,
                                       is_share ? kMostRadianceTolerance : kMostPlaceTolerance);
        const bool is_known = std::find(tolerances.begin(), tolerances.end(), most) != tolerances.end();
        if (most != given.most && !is_known) tolerances.push_back(most);
    }
    return tolerances;
}

/// With maps of the size given.
TradeSetting with_given_maps(const TradeSetting& setting, const MapSettings& given) {
    return given.fitted ? with_fitted_maps(setting) : with_map_size(setting, given.size);
}

/// Each size once, the smallest first.
std::vector<std::uint32_t> map_sizes(std::uint32_t given) {
    std::vector<std::uint32_t> sizes;
    for (const double scale : kMapScales) {
        const auto size = static_cast<std::uint32_t>(scale * given);
        sizes.push_back(std::max(size, 1u));
    }
    sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
    return sizes;
}

/// What a method is swept over.
std::vector<TradeSetting> settings_of(const Method& method, const MapSettings& given) {
    const TradeSetting plain{method, given, {"--reflection", std::string(method.reflection->name)}};
    std::vector<TradeSetting> settings;
    const ReflectionTraits& traits = method.reflection->traits;
    if (!traits.looks_up_maps) return {plain};
    const auto add = [&](const TradeSetting& sized) {
        settings.push_back(traits.has_tolerance ? with_tolerance(sized, given.tolerance.most) : sized);
    };
    for (const std::uint32_t size : given.fitted ? std::vector<std::uint32_t>() : map_sizes(given.size))
        add(with_map_size(plain, size));
    add(with_fitted_maps(plain));
    if (given.most_probes == 1 && traits.takes_probes) {
        const TradeSetting sized = with_given_maps(plain, given);
        settings.push_back(with_probes(
            traits.has_tolerance ? with_tolerance(sized, given.tolerance.most) : sized, kSeveralProbes));
    }
    if (traits.has_tolerance) {
        for (const double most : other_tolerances(given.tolerance))
            settings.push_back(with_tolerance(with_given_maps(plain, given), most));
    }
    const bool as_modelled = !given.refinement.edge && !given.refinement.error;
    if (traits.is_per_polygon && as_modelled) {
        for (const double degrees : kPolygonErrors)
            settings.push_back(with_polygon_error(with_given_maps(plain, given), degrees));
    }
    return settings;
}

}  // namespace

std::vector<TradeSetting> swept_settings(const std::vector<Method>& methods, const MapSettings& given) {
    std::vector<TradeSetting> all;
    for (const Method& method : methods) {
        const std::vector<TradeSetting> settings = settings_of(method, given);
        all.insert(all.end(), settings.begin(), settings.end());
    }
    return all;
}

std::vector<std::uint32_t> swept_samples(std::uint32_t most) {
    std::vector<std::uint32_t> counts;
    for (std::uint64_t count = 1; count < most; count *= 2)
        counts.push_back(static_cast<std::uint32_t>(count));
    counts.push_back(most);
    return counts;
}

}  // namespace utsuri
