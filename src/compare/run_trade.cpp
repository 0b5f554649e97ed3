// SPDX-License-Identifier: Apache-2.0
#include "compare/run_trade.h"

#include "compare/measure.h"
#include "compare/trade_sweep.h"

#include "base/command_line.h"
#include "image/shrink.h"
#include "image_io/image_io.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

namespace utsuri {
namespace {

/// Of the pictures that the page shows: about 50 kB each.
constexpr std::uint32_t kPictureColumns = 512;
constexpr int kPictureQuality = 85;

/// Frames that take less are timed again, since what else the machine does disturbs them most.
constexpr double kShortFrameSeconds = 0.25;
/// Timings of a short frame, the median of which counts; odd.
constexpr std::size_t kShortFrameTimings = 3;

/// Measures a picture and keeps it as JPEG only.
TradeRun finish_run(const Comparison& basis, MethodResult result, std::vector<std::string> options) {
    measure_errors(basis, result);
    TradeRun run{std::move(result), std::move(options), {}};
    run.picture =
        encode_jpeg(shrink_to_width(run.result.image, kPictureColumns), basis.exposure, kPictureQuality);
    run.result.image = Image();
    run.result.flip = Plane();
    return run;
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Renders the same pictures anew, up to the last short one, and takes the median of the times.
void time_short_frames(Renderer& renderer, Film& film, const Camera& camera, std::span<TradeRun> runs,
                       Progress& progress) {
    const auto is_short = [](const TradeRun& run) { return run.result.frame_seconds < kShortFrameSeconds; };
    runs = runs.first(static_cast<std::size_t>(std::count_if(runs.begin(), runs.end(), is_short)));
    std::vector<std::vector<double>> times;
    for (const TradeRun& run : runs)
        times.push_back({run.result.frame_seconds});
    for (std::size_t timing = 1; timing < kShortFrameTimings && !runs.empty(); ++timing) {
        film.clear();
        renderer.look_from(camera);
        const double start = renderer.statistics().frame_seconds;
        for (std::size_t i = 0; i < runs.size(); ++i) {
            renderer.add_samples(film, runs[i].result.samples - film.samples(), progress);
            if (progress.cancelled()) return;
            times[i].push_back(renderer.statistics().frame_seconds - start);
        }
    }
    for (std::size_t i = 0; i < runs.size(); ++i)
        runs[i].result.frame_seconds = median(times[i]);
}

void run_setting(const RenderInput& input, const TradeSetting& setting, const ComparisonSettings& settings,
                 const std::string& title, Progress& progress, Trade& trade) {
    input.device.reset_peak_memory();
    const std::unique_ptr<Renderer> renderer =
        make_renderer(setting.method, input, settings.render, setting.maps);
    progress.begin(title + ", preparing");
    renderer->prepare(progress);
    Film film(input.device, settings.render.width, settings.render.height, title);
    progress.begin(title);
    renderer->look_from(input.camera);  // so that the time of a frame is what it takes when the eye moves
    const std::size_t first = trade.runs.size();
    for (const std::uint32_t samples : swept_samples(settings.samples)) {
        renderer->add_samples(film, samples - film.samples(), progress);
        if (film.samples() < samples) return;
        trade.runs.push_back(finish_run(
            trade.basis, collect_result(setting.method, setting.maps, *renderer, film, input.device),
            setting.options));
        if (progress.cancelled()) return;
    }
    time_short_frames(*renderer, film, input.camera, std::span(trade.runs).subspan(first), progress);
}

Comparison render_reference(const RenderInput& input, ComparisonSettings settings, Progress& progress) {
    settings.methods.clear();
    Comparison basis = run_comparison(input, settings, progress);
    if (basis.interrupted) throw Interrupted();
    return basis;
}

}  // namespace

Trade run_trade(const RenderInput& input, const ComparisonSettings& settings, Progress& progress) {
    Trade trade;
    trade.basis = render_reference(input, settings, progress);
    MethodResult half;
    half.image = std::move(trade.basis.reference_half);
    measure_errors(trade.basis, half);
    trade.noise = half.metrics;
    trade.noise_reflective = half.metrics_reflective;

    const std::vector<TradeSetting> sweep = swept_settings(settings.methods, settings.maps);
    for (std::size_t i = 0; i < sweep.size() && !progress.cancelled(); ++i) {
        const TradeSetting& setting = sweep[i];
        const std::string title =
            fmt::format("{} of {}: {}", i + 1, sweep.size(), shell_command(setting.options));
        try {
            run_setting(input, setting, settings, title, progress, trade);
        } catch (const Interrupted&) {
            break;
        } catch (const Error& error) {
            trade.failures.push_back({setting.method, setting.options, error.what(), error.exit_code()});
        }
    }
    trade.interrupted = progress.cancelled();
    return trade;
}

}  // namespace utsuri
