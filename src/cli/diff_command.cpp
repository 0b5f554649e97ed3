// SPDX-License-Identifier: Apache-2.0
#include "cli/command.h"
#include "cli/output.h"
#include "compare/comparison/comparison_json.h"
#include "compare/trade/error_metric.h"

#include "image/error_map.h"
#include "image/metrics.h"
#include "image_io/image_io.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <limits>
#include <memory>

namespace utsuri {
namespace {

struct DiffOptions {
    CommonOptions common;
    std::string reference;
    std::string test;
    std::string error_map;
    std::string metric = "rel_mse";
    std::optional<double> fail_above;
    std::optional<double> exposure;
    bool display = false;
};

/// The display pictures of PNG files have no scale of light to normalise, and FLIP looks at them as they are.
MetricSettings metric_settings(const DiffOptions& options) {
    MetricSettings settings;
    settings.exposure = options.exposure;
    if (options.display) {
        settings.normalise = false;
        settings.flip_hdr = false;
        settings.exposure = options.exposure.value_or(0.0);
    }
    return settings;
}

ExitCode diff(DiffOptions options) {
    if (!options.error_map.empty() && std::filesystem::path(options.error_map).extension() != ".png") {
        throw UsageError("write", fmt::format("'{}'", options.error_map),
                         "expected a name that ends in .png");
    }
    const Image reference = read_image(options.reference);
    const Image test = read_image(options.test);
    options.display = !options.reference.ends_with(".exr") && !options.reference.ends_with(".hdr");
    const MetricSettings settings = metric_settings(options);
    const PerceptualMaps maps = compute_perceptual_maps(reference, test, settings);
    const Metrics metrics = compute_metrics(reference, test, &maps, nullptr, settings);
    const nlohmann::ordered_json values = metrics_to_json(metrics);
    if (!options.error_map.empty()) write_png_coded(options.error_map, error_map(maps.flip));

    std::string text = fmt::format("{} against {}\n", options.test, options.reference);
    for (const auto& [name, value] : values.items())
        text += fmt::format("  {:<10}{}\n", name, value.dump());
    print_text(options.common, text);
    nlohmann::ordered_json json = {
        {"reference", options.reference}, {"test", options.test}, {"metrics", values}};
    write_json(options.common, json);

    const nlohmann::ordered_json& chosen = values.at(options.metric);
    if (!options.fail_above) return ExitCode::success;
    const bool within =
        chosen.is_number() && chosen.get<double>() <= *options.fail_above && metrics.nonfinite == 0;
    return within ? ExitCode::success : ExitCode::difference;
}

}  // namespace

void add_diff_command(CLI::App& app, Action& action) {
    auto options = std::make_shared<DiffOptions>();
    CLI::App* command = app.add_subcommand("diff", "Measure how far one picture is from another");
    command->add_option("reference", options->reference, "Picture taken as the truth")
        ->required()
        ->type_name("A");
    command->add_option("test", options->test, "Picture to measure")->required()->type_name("B");
    command->add_option("-o,--error-map", options->error_map, "Write the FLIP error map as PNG")
        ->type_name("FILE");
    command->add_option("--metric", options->metric, "Metric for --fail-above")
        ->check(CLI::IsMember(error_metric_names()))
        ->capture_default_str();
    command->add_option("--fail-above", options->fail_above, "Exit with 1 if the metric is above this")
        ->check(finite_range(0.0, std::numeric_limits<double>::max()));
    command
        ->add_option("--exposure", options->exposure,
                     "Exposure in stops for PSNR and SSIM [automatic for .exr]")
        ->check(finite_range(-kMostStops, kMostStops));
    add_common_options(*command, options->common);
    command->callback([=, &action] { action = [=] { return diff(*options); }; });
}

}  // namespace utsuri
