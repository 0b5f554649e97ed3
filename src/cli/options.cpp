// SPDX-License-Identifier: Apache-2.0
#include "cli/options.h"

#include "base/error.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>

namespace utsuri {
namespace {

template <typename Number>
std::optional<Number> parse_number(std::string_view text) {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

}  // namespace

std::vector<std::string> split_list(const std::string& text) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, ',');)
        parts.push_back(part);
    return parts;
}

CLI::Validator finite_range(double lowest, double highest) {
    const auto check = [=](const std::string& text) {
        double value = 0.0;
        if (CLI::detail::lexical_cast(text, value) && value >= lowest && value <= highest)
            return std::string();
        return fmt::format("Value {} not in range {:g} to {:g}", text, lowest, highest);
    };
    return CLI::Validator(check, fmt::format("in [{:g} - {:g}]", lowest, highest));
}

glm::uvec2 parse_size(const std::string& text) {
    const std::size_t cross = text.find('x');
    const auto width = parse_number<std::uint32_t>(std::string_view(text).substr(0, cross));
    const auto height = cross == std::string::npos
                            ? std::nullopt
                            : parse_number<std::uint32_t>(std::string_view(text).substr(cross + 1));
    if (!width || !height || *width < 1 || *height < 1 || *width > kLargestPictureEdge ||
        *height > kLargestPictureEdge) {
        throw UsageError("use --size", fmt::format("'{}'", text),
                         fmt::format("expected WIDTHxHEIGHT in pixels, each from 1 to {}, such as 512x384",
                                     kLargestPictureEdge));
    }
    return {*width, *height};
}

double parse_duration(const std::string& text) {
    const std::size_t unit_at = text.find_first_not_of("0123456789.e-+");
    const auto value = parse_number<double>(std::string_view(text).substr(0, unit_at));
    const std::string unit = unit_at == std::string::npos ? "s" : text.substr(unit_at);
    const double scale = unit == "ms" ? 1e-3 : (unit == "s" ? 1.0 : (unit == "min" ? 60.0 : 0.0));
    if (!value || !std::isfinite(*value) || !(*value > 0.0) || scale == 0.0) {
        throw UsageError("use time", fmt::format("'{}'", text),
                         "expected a positive time such as 33ms, 2s or 5min");
    }
    return *value * scale;
}

glm::dvec3 parse_point(const std::string& text) {
    const std::vector<std::string> parts = split_list(text);
    glm::dvec3 point(0.0);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto value = parts.size() == 3 ? parse_number<double>(parts[i]) : std::nullopt;
        if (!value || !std::isfinite(*value)) {
            throw UsageError("use point", fmt::format("'{}'", text),
                             "expected X,Y,Z in metres, such as 0,1.5,-2");
        }
        point[static_cast<int>(i)] = *value;
    }
    return point;
}

MapSize parse_map_size(const std::string& text) {
    if (text == "fit") return {kMostFittedMapSize, true};
    const auto texels = parse_number<std::uint32_t>(text);
    if (!texels || *texels < 1 || *texels > kLargestMapSize) {
        throw UsageError("use --map-size", fmt::format("'{}'", text),
                         fmt::format("expected texels from 1 to {}, such as 256, or fit", kLargestMapSize));
    }
    return {*texels, false};
}

Tolerance parse_tolerance(const std::string& text) {
    const bool is_share = text.ends_with('%');
    const auto value =
        parse_number<double>(std::string_view(text).substr(0, text.size() - (is_share ? 1 : 0)));
    const double unit = is_share ? 100.0 : 1.0;
    const double least = is_share ? kLeastRadianceTolerance : 0.0;
    const double most = is_share ? kMostRadianceTolerance : kMostPlaceTolerance;
    if (!value || !(*value >= unit * least && *value <= unit * most)) {
        throw UsageError(
            "use --tolerance", fmt::format("'{}'", text),
            fmt::format("expected pixels from 0 to {:g}, such as 1, or a share of the radiance from "
                        "{:g}% to {:g}%, such as 5%",
                        kMostPlaceTolerance, 100.0 * kLeastRadianceTolerance,
                        100.0 * kMostRadianceTolerance));
    }
    return {is_share ? Tolerance::Of::radiance : Tolerance::Of::place, *value / unit};
}

RenderSettings PictureOptions::render_settings() const {
    const glm::uvec2 pixels = parse_size(size);
    return {pixels.x, pixels.y, seed, depth, kept_light};
}

MapSettings PictureOptions::map_settings() const {
    MapSettings settings;
    if (map_size) {
        const MapSize size_of_maps = parse_map_size(*map_size);
        settings.size = size_of_maps.texels;
        settings.fitted = size_of_maps.fitted;
        settings.shares_room = false;
    }
    settings.samples = map_samples;
    if (!capture_point.empty()) settings.capture_point = parse_point(capture_point);
    settings.most_probes = most_probes;
    const bool is_file = polyhedron.find_first_of("./\\") != std::string::npos;
    settings.polyhedron = is_file ? read_polyhedron(polyhedron) : platonic_solid(polyhedron);
    if (proxy) settings.proxy = read_proxy(*proxy);
    settings.tolerance = parse_tolerance(tolerance);
    settings.refinement.edge = polygon_edge;
    if (polygon_error) settings.refinement.error = *polygon_error * std::numbers::pi / 180.0;
    return settings;
}

LightSettings PictureOptions::light_settings() const {
    LightSettings settings;
    settings.samples = light_samples;
    settings.seed = seed;
    settings.spacing = light_spacing;
    settings.refinement = light_refinement;
    settings.most_points = light_points;
    return settings;
}

namespace {

void add_view_options(CLI::App& command, PictureOptions& options) {
    command.add_option("--size", options.size, "Picture size in pixels")
        ->type_name("WxH")
        ->capture_default_str();
    command.add_option("--camera", options.camera, "Camera: index or name [the first]");
    command.add_option("--seed", options.seed, "Seed of the random numbers")
        ->check(CLI::Range(0u, std::numeric_limits<std::uint32_t>::max()))
        ->capture_default_str();
    command.add_option("--depth", options.depth, "Most reflections by mirrors and glossy lobes followed")
        ->check(CLI::Range(0u, 1000000u))
        ->capture_default_str();
}

/// How finely maps and kept light are sampled, and what the latter lights.
void add_sampling_options(CLI::App& command, PictureOptions& options) {
    command
        .add_option(
            "--map-size", options.map_size,
            fmt::format("Texels along an edge of a reflection map, up to {}, or fit: for each object as "
                        "many as the pixels that show it need, up to {} [{}, fewer where there is no room]",
                        kLargestMapSize, kMostFittedMapSize, MapSettings().size))
        ->type_name("TEXELS|fit");
    command.add_option("--map-spp", options.map_samples, "Samples per texel of a reflection map")
        ->check(CLI::Range(1u, kMostMapSamples))
        ->capture_default_str();
    command
        .add_option(
            "--light-spp", options.light_samples,
            "Shadow rays at most on each side of a point where light is kept on surfaces (one for each lamp "
            "at least), for methods that draw and --kept-light")
        ->check(CLI::Range(1u, kMostLightSamples))
        ->capture_default_str();
    command
        .add_option(
            "--light-spacing", options.light_spacing,
            "Distance of these points where light is even, at most, as a share of the scene's diagonal")
        ->check(finite_range(1e-5, 1.0))
        ->capture_default_str();
    command
        .add_option("--light-refinement", options.light_refinement,
                    "How many times as near they may be where light changes; 1: evenly spaced")
        ->check(finite_range(1.0, 65536.0))
        ->capture_default_str();
    command
        .add_option("--light-points", options.light_points,
                    "Most points added where things touch, and again where light changes")
        ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1} << 31))
        ->capture_default_str();
    command.add_flag(
        "--kept-light", options.kept_light,
        "Light traced pictures, too, from the light kept on surfaces: methods then differ by their "
        "reflections");
}

/// Where maps are captured from, and what stands in for what they show.
void add_map_options(CLI::App& command, PictureOptions& options) {
    command
        .add_option("--capture-point", options.capture_point,
                    "Where maps are captured, in metres [centre of each reflective object]")
        ->type_name("X,Y,Z");
    command
        .add_option(
            "--probes", options.most_probes,
            "Points of each reflective or glossy object to capture maps from, at most; more than one only "
            "where that is predicted to lower the error")
        ->check(CLI::Range(1u, kMostProbes))
        ->capture_default_str();
    command
        .add_option(
            "--polyhedron", options.polyhedron,
            "Faces of polygon maps: tetrahedron, cube, octahedron, dodecahedron, icosahedron, or a file of "
            "planes (with a dot in its name), x y z distance a line")
        ->type_name("NAME|FILE")
        ->capture_default_str();
    command
        .add_option("--proxy", options.proxy,
                    "What stands in for the surroundings where proxy-map and planar correct look-ups, "
                    "for all objects: a file of planes, x y z distance a line, normals out of the "
                    "convex polyhedron, distances from the world's origin in metres [fitted to each object]")
        ->type_name("FILE");
}

/// How far off reflections may be.
void add_accuracy_options(CLI::App& command, PictureOptions& options) {
    command
        .add_option("--polygon-edge", options.polygon_edge,
                    "Cut reflectors into polygons with edges of at most so many metres [as modelled]")
        ->check(finite_range(1e-6, 1e9));
    command
        .add_option(
            "--polygon-error", options.polygon_error,
            "Cut reflectors into polygons over which reflections are interpolated to so many degrees, for a "
            "far eye [as modelled]")
        ->check(finite_range(1e-3, 90.0));
    command
        .add_option("--tolerance", options.tolerance,
                    "What hybrid may show wrong: pixels that a reflection is off its place, such as 1, or a "
                    "share of its radiance, such as 5%; where more is predicted, a ray is traced")
        ->type_name("PIXELS|PERCENT%")
        ->capture_default_str();
}

}  // namespace

void add_common_options(CLI::App& command, CommonOptions& options) {
    command.add_option("--device", options.device, "Vulkan device: index or part of its name [fastest kind]")
        ->envname("UTSURI_DEVICE")
        ->group("General");
    command.add_flag("--quiet,-q", options.quiet, "No progress line and no summary")->group("General");
    command.add_option("--json", options.json, "Write the result as JSON to FILE, or - for standard output")
        ->type_name("FILE")
        ->group("General");
}

void add_picture_options(CLI::App& command, PictureOptions& options) {
    add_view_options(command, options);
    add_sampling_options(command, options);
    add_map_options(command, options);
    add_accuracy_options(command, options);
    command.add_option("--exposure", options.exposure, "Exposure of display images in stops [automatic]")
        ->check(finite_range(-kMostStops, kMostStops));
}

}  // namespace utsuri
