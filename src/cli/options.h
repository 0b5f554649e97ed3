// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/light/direct/light_cache.h"
#include "renderers/methods/renderer.h"
#include "renderers/reflection/maps/reflection_maps.h"

#include <CLI/App.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace utsuri {

/// Largest exposure either way, in stops; beyond it float32 pixels go black or white.
inline constexpr double kMostStops = 60.0;

/// Options that every subcommand has.
struct CommonOptions {
    std::string device;  ///< index or part of a name; empty: UTSURI_DEVICE, else the fastest
    bool quiet = false;  ///< no progress and no summary
    std::string json;  ///< where to write the result for machines: a file, "-" for standard output, or empty
};

/// Options that say how a picture is rendered.
struct PictureOptions {
    std::string size = "512x384";
    std::string camera;
    std::uint32_t seed = 0;
    std::uint32_t depth = 8;
    std::optional<std::string> map_size;  ///< of what fits up to MapSettings::size if not given
    std::uint32_t map_samples = 8;
    std::uint32_t light_samples = LightSettings().samples;
    double light_spacing = LightSettings().spacing;
    double light_refinement = LightSettings().refinement;
    std::uint64_t light_points = LightSettings().most_points;
    bool kept_light = false;
    std::string capture_point;
    std::uint32_t most_probes = 1;
    std::string polyhedron = "cube";
    std::optional<std::string> proxy;
    std::optional<double> polygon_edge;
    std::optional<double> polygon_error;
    std::string tolerance = "1";
    std::optional<double> exposure;

    [[nodiscard]] RenderSettings render_settings() const;
    [[nodiscard]] MapSettings map_settings() const;
    [[nodiscard]] LightSettings light_settings() const;
};

void add_common_options(CLI::App& command, CommonOptions& options);
void add_picture_options(CLI::App& command, PictureOptions& options);

/// Refuses numbers outside [lowest, highest], and not-a-number, which CLI::Range lets pass.
CLI::Validator finite_range(double lowest, double highest);

/// "512x384": two whole numbers in [1, 16384].
glm::uvec2 parse_size(const std::string& text);
/// "33ms", "2s", "1.5min" or a number of seconds; > 0.
double parse_duration(const std::string& text);
/// Texels along an edge of a map, such as "256", or "fit".
struct MapSize {
    std::uint32_t texels;  ///< exactly, or at most
    bool fitted;
};
/// @throws UsageError that tells the range
MapSize parse_map_size(const std::string& text);
/// "1", in pixels, or "5%", of the radiance.
/// @throws UsageError that tells the ranges
Tolerance parse_tolerance(const std::string& text);
/// "0.5,1,-2".
glm::dvec3 parse_point(const std::string& text);
/// "depth,normal".
std::vector<std::string> split_list(const std::string& text);

}  // namespace utsuri
