// SPDX-License-Identifier: Apache-2.0
#include "cli/aov_output.h"
#include "cli/command.h"
#include "cli/output.h"
#include "cli/progress_line.h"
#include "cli/scene_session.h"
#include "cli/trade_choice.h"
#include "compare/comparison/comparison_json.h"
#include "compare/comparison/comparison_table.h"

#include "base/file.h"
#include "base/stopwatch.h"
#include "base/version.h"
#include "image/tone.h"
#include "image_io/image_io.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>

namespace utsuri {
namespace {

struct RenderOptions {
    CommonOptions common;
    PictureOptions picture;
    ChoiceOptions choice;
    std::string scene;
    std::string output;
    std::string light = "direct";
    std::string reflection = "trace";
    std::optional<std::uint32_t> samples;
    std::string time;
    std::optional<double> noise;
    std::string aovs;
};

constexpr std::uint32_t kDefaultSamples = 16;
/// Where only time or noise ends a run: 2^24 samples, beyond which a pixel's sums stop gaining.
constexpr std::uint32_t kMostSamples = 1u << 24;
/// Relative noise that a user can ask for: below the first the rounding of float32 pixels hides it, and a
/// picture of few samples has less than the second.
constexpr double kLeastNoise = 1e-7;
constexpr double kMostNoise = 1e6;

struct Result {
    Image image;
    std::uint32_t samples = 0;
    std::optional<double> noise;  ///< relative; of an even number of samples
    RenderStatistics statistics;
    std::uint64_t peak_bytes = 0;
    double first_frame_seconds = 0.0;  ///< from the start of the process' work to the first whole sample
};

/// Adds samples in growing steps until one of the goals is met.
void render_until_done(Picture& picture, const RenderOptions& options, ProgressLine& progress, Result& result,
                       const Stopwatch& whole) {
    const bool open_ended = !options.time.empty() || options.noise;
    const std::uint32_t most = options.samples.value_or(open_ended ? kMostSamples : kDefaultSamples);
    const double seconds = options.time.empty() ? 0.0 : parse_duration(options.time);
    const Stopwatch sampling;
    progress.begin(fmt::format("{}/{}", options.light, options.reflection));
    while (picture.samples() < most && !progress.cancelled()) {
        std::uint32_t step = std::min(most - picture.samples(), most);
        if (picture.samples() == 0)
            step = 1;
        else if (open_ended)
            step = std::min(step, picture.samples());
        if (options.noise && (picture.samples() + step) % 2 != 0)
            step = picture.samples() + 1 < most ? 1 : step;
        if (seconds > 0.0 && picture.samples() > 0) {
            const double elapsed = sampling.seconds();
            const double fitting = (seconds - elapsed) * picture.samples() / elapsed;
            if (fitting < 1.0) break;
            step = std::min(step, static_cast<std::uint32_t>(std::min(fitting, 1e6)));
        }
        const bool first = picture.samples() == 0;
        picture.add_samples(step, progress);
        if (first) result.first_frame_seconds = whole.seconds();
        if (options.noise && picture.samples() % 2 == 0 && picture.noise().relative <= *options.noise) break;
    }
    if (picture.samples() == 0) throw Interrupted();
    result.image = picture.image();
    result.samples = picture.samples();
    if (picture.samples() % 2 == 0) result.noise = picture.noise().relative;
}

nlohmann::ordered_json to_json(const Result& result, const RenderOptions& options,
                               const DeviceSummary& device) {
    const FrameCounts& counts = result.statistics.counts;
    return {{"utsuri", kVersion},
            {"scene", options.scene},
            {"image", options.output},
            {"device", device_to_json(device)},
            {"light", options.light},
            {"reflection", options.reflection},
            {"width", result.image.width},
            {"height", result.image.height},
            {"seed", options.picture.seed},
            {"specular_depth", options.picture.depth},
            {"kept_light", options.picture.kept_light},
            {"samples", result.samples},
            {"noise", result.noise ? nlohmann::ordered_json(*result.noise) : nlohmann::ordered_json(nullptr)},
            {"prepare_seconds", result.statistics.prepare_seconds},
            {"compile_seconds", result.statistics.compile_seconds},
            {"frame_seconds", result.statistics.frame_seconds},
            {"gpu_seconds", counts.gpu_seconds},
            {"first_frame_seconds", result.first_frame_seconds},
            {"peak_bytes", result.peak_bytes},
            {"rays", counts.rays},
            {"maps", result.statistics.maps},
            {"captured_maps", result.statistics.captured_maps},
            {"least_map_size", result.statistics.least_map_size},
            {"largest_map_size", result.statistics.largest_map_size},
            {"nonfinite", counts.nonfinite},
            {"truncated", counts.truncated}};
}

/// "5 of 18 maps of 256 texels, " or "5 of 18 maps of 8 to 64 texels, "; nothing where there are none.
std::string describe_maps(const RenderStatistics& statistics) {
    if (statistics.maps == 0) return {};
    const bool is_even = statistics.least_map_size == statistics.largest_map_size;
    return fmt::format("{} of {} maps of {}{} texels, ", statistics.captured_maps, statistics.maps,
                       is_even ? "" : fmt::format("{} to ", statistics.least_map_size),
                       statistics.largest_map_size);
}

/// The options that decide how a picture is made.
void add_method_options(CLI::App& command, RenderOptions& options) {
    command.add_option("--light", options.light, "Light at diffuse surfaces: " + list_lights())
        ->capture_default_str();
    command
        .add_option("--reflection", options.reflection, "How reflections are found: " + list_reflections())
        ->capture_default_str();
    command
        .add_option("--spp", options.samples, "Samples per pixel, or the most with --time or --noise [16]")
        ->check(CLI::Range(1u, kMostSamples));
    command.add_option("--time", options.time,
                       "Time for samples, such as 500ms, 10s or 5min; a bare number is seconds");
    command
        .add_option("--noise", options.noise, "Relative standard error of the pixels to reach, such as 0.01")
        ->check(finite_range(kLeastNoise, kMostNoise));
}

/// Sets the options that a run of a trade stands for.
void apply_run(const TradeRun& run, RenderOptions& options) {
    CLI::App parser;
    add_method_options(parser, options);
    add_picture_options(parser, options.picture);
    std::vector<std::string> words = run.options;
    words.insert(words.end(), {"--spp", fmt::format("{}", run.result.samples)});
    std::reverse(words.begin(), words.end());  // as the parser takes them
    parser.parse(words);
}

/// Chooses method and settings by what they were measured to take and to be wrong by.
/// @param given the picture options as the user gave them
/// @returns the choice as JSON
nlohmann::ordered_json choose(RenderOptions& options, const std::vector<std::string>& given, Session& session,
                              const Camera& camera, ProgressLine& progress) {
    const LightMethod& light = find_light(options.light);
    const ComparisonSettings settings = trade_settings(options.picture, all_methods(light), light);
    const Trade trade = kept_or_measured(session, camera, settings, given, options.common, progress);
    const TradePoint point = choose_run(trade, options.choice);
    apply_run(trade.runs[point.run], options);
    progress.clear();
    print_text(options.common, choice_text(trade, point, options.choice));
    return choice_to_json(trade, point, options.choice);
}

void write_picture(const Result& result, const RenderOptions& options, const std::vector<ExrChannels>& aovs) {
    const std::filesystem::path path(options.output);
    if (path.extension() == ".png") {
        return write_png(path, result.image, options.picture.exposure.value_or(auto_exposure(result.image)));
    }
    const ImageMetadata metadata = {
        {"Software", fmt::format("utsuri {}", kVersion)},
        {"utsuri:method", fmt::format("{}/{}", options.light, options.reflection)},
        {"utsuri:samples", fmt::format("{}", result.samples)},
        {"utsuri:scene", options.scene}};
    if (aovs.empty()) return write_exr(path, result.image, ExrPrecision::single, metadata);
    std::vector<ExrChannels> channels = {{{"R", "G", "B"}, &result.image.pixels.front().x}};
    channels.insert(channels.end(), aovs.begin(), aovs.end());
    write_exr_channels(path, result.image.width, result.image.height, channels, metadata);
}

void check_output(const RenderOptions& options) {
    const std::string extension = std::filesystem::path(options.output).extension().string();
    if (extension != ".exr" && extension != ".png") {
        throw UsageError("write", fmt::format("'{}'", options.output),
                         "expected a name that ends in .exr or .png");
    }
    if (!options.aovs.empty() && extension != ".exr") {
        throw UsageError("write AOVs into", fmt::format("'{}'", options.output), "only .exr files hold them");
    }
    check_writable(options.output);
    check_json(options.common);
}

/// Finds mistakes before the work begins.
void check_options(const RenderOptions& options) {
    static_cast<void>(options.picture.map_settings());
    find_method(options.light, options.reflection);
    for (const std::string& time : {options.time, options.choice.within}) {
        if (!time.empty()) parse_duration(time);
    }
    check_output(options);
}

void check_reflection_data(const AovSelection& aovs, const Method& method) {
    if (wants_reflection_errors(aovs) && !method.reflection->traits.predicts_errors) {
        throw UsageError("tell errors of reflections", method_name(method),
                         "only methods that look reflections up in maps have them; use another --reflection");
    }
    if (wants_traced_pixels(aovs) && !method.reflection->traits.has_tolerance) {
        throw UsageError("tell which reflections are traced", method_name(method),
                         "does the same at every mirror; only hybrid chooses: use --reflection hybrid");
    }
}

ExitCode render(RenderOptions options, const std::vector<std::string>& given) {
    const Stopwatch whole;
    const RenderSettings settings = options.picture.render_settings();
    const AovSelection aovs = parse_aovs(options.aovs);
    check_options(options);

    const LoadedScene loaded = load_scene(options.scene);
    const Camera& camera = choose_camera(loaded.scene, options.picture.camera);
    print_notes(options.common, loaded.notes);
    Session session = make_session(options.common, options.picture.light_settings());
    ProgressLine progress(options.common.quiet);
    progress.begin("building the BVH");
    session.set_scene(loaded.scene);
    nlohmann::ordered_json choice;
    if (options.choice.wanted()) choice = choose(options, given, session, camera, progress);
    session.reset_peak_memory();
    const Method method = find_method(options.light, options.reflection);
    check_reflection_data(aovs, method);
    MapSettings maps = options.picture.map_settings();
    maps.predicts_errors = wants_reflection_errors(aovs);
    Picture picture = session.make_picture({method, camera, settings, maps});
    progress.begin("preparing");
    picture.prepare(progress);
    Result result;
    render_until_done(picture, options, progress, result, whole);
    result.statistics = picture.statistics();
    result.peak_bytes = session.memory().peak;

    AovPlanes planes;
    if (!aovs.empty()) {
        planes =
            extract_aovs(session.first_hits(camera, settings.width, settings.height), aovs, session.scene());
        add_reflection_data(planes, picture, aovs);
    }
    write_picture(result, options, planes.channels());
    progress.clear();
    print_text(options.common,
               fmt::format("{}: {} samples, {} (prepare {}, compile {}), {} rays, {}{}\n", options.output,
                           result.samples, format_seconds(result.statistics.frame_seconds),
                           format_seconds(result.statistics.prepare_seconds),
                           format_seconds(result.statistics.compile_seconds),
                           format_count(static_cast<double>(result.statistics.counts.rays)),
                           describe_maps(result.statistics), format_bytes(result.peak_bytes)));
    if (result.statistics.counts.nonfinite > 0) {
        fmt::print(stderr, "warning: {} samples were not finite and were left out\n",
                   result.statistics.counts.nonfinite);
    }
    nlohmann::ordered_json json = to_json(result, options, session.device());
    json["choice"] = choice;
    write_json(options.common, json);
    check_validation(session);
    return progress.cancelled() ? ExitCode::interrupted : ExitCode::success;
}

}  // namespace

void add_render_command(CLI::App& app, Action& action) {
    auto options = std::make_shared<RenderOptions>();
    CLI::App* command = app.add_subcommand("render", "Render one picture");
    command->add_option("scene", options->scene, "glTF scene, .gltf or .glb")->required()->type_name("SCENE");
    command->add_option("-o,--output", options->output, "Picture: .exr (cd/m2) or .png (for display)")
        ->required()
        ->type_name("FILE");
    add_method_options(*command, *options);
    command->add_option(
        "--aov", options->aovs,
        "More channels for the .exr, of the pixel centres, separated by commas: " + aov_names());
    add_choice_options(*command, options->choice);
    for (const char* choice : {"--within", "--error"}) {
        for (const char* fixed : {"--reflection", "--spp", "--time", "--noise"})
            command->get_option(choice)->excludes(fixed);
    }
    add_picture_options(*command, options->picture);
    add_common_options(*command, options->common);
    command->footer(
        "--within and --error look the choice up in what 'utsuri trade' finds for this scene, camera, size "
        "and "
        "device. That is measured once, which takes minutes, and kept in $XDG_CACHE_HOME/utsuri or "
        "~/.cache/utsuri. Maps of a quarter and all of --map-size and fitted ones are tried, from one "
        "capture point "
        "and several.");
    command->callback(
        [=, &action] { action = [=] { return render(*options, given_picture_options(*command)); }; });
}

}  // namespace utsuri
