// SPDX-License-Identifier: Apache-2.0
#include "compare/trade/run_trade.h"

#include "compare/comparison/measure.h"
#include "compare/trade/trade_sweep.h"

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
void time_short_frames(Picture& picture, const Camera& camera, std::span<TradeRun> runs, Progress& progress) {
    const auto is_short = [](const TradeRun& run) { return run.result.frame_seconds < kShortFrameSeconds; };
    runs = runs.first(static_cast<std::size_t>(std::count_if(runs.begin(), runs.end(), is_short)));
    std::vector<std::vector<double>> times;
    for (const TradeRun& run : runs)
        times.push_back({run.result.frame_seconds});
    for (std::size_t timing = 1; timing < kShortFrameTimings && !runs.empty(); ++timing) {
        picture.set_camera(camera);
        const double start = picture.statistics().frame_seconds;
        for (std::size_t i = 0; i < runs.size(); ++i) {
            picture.add_samples(runs[i].result.samples - picture.samples(), progress);
            if (progress.cancelled()) return;
            times[i].push_back(picture.statistics().frame_seconds - start);
        }
    }
    for (std::size_t i = 0; i < runs.size(); ++i)
        runs[i].result.frame_seconds = median(times[i]);
}

void run_setting(Session& session, const Camera& camera, const TradeSetting& setting,
                 const ComparisonSettings& settings, const std::string& title, Progress& progress,
                 Trade& trade) {
    session.reset_peak_memory();
    const PictureSettings picture_settings{setting.method, camera, settings.render, setting.maps, title};
    Picture picture = session.make_picture(picture_settings);
    progress.begin(title + ", preparing");
    picture.prepare(progress);
    progress.begin(title);
    picture.set_camera(camera);  // so that the time of a frame is what it takes when the eye moves
    const std::size_t first = trade.runs.size();
    for (const std::uint32_t samples : swept_samples(settings.samples)) {
        picture.add_samples(samples - picture.samples(), progress);
        if (picture.samples() < samples) return;
        trade.runs.push_back(finish_run(
            trade.basis, collect_result(picture_settings, picture, session.memory()), setting.options));
        if (progress.cancelled()) return;
    }
    time_short_frames(picture, camera, std::span(trade.runs).subspan(first), progress);
}

Comparison render_reference(Session& session, const Camera& camera, ComparisonSettings settings,
                            Progress& progress) {
    settings.methods.clear();
    Comparison basis = run_comparison(session, camera, settings, progress);
    if (basis.interrupted) throw Interrupted();
    return basis;
}

}  // namespace

Trade run_trade(Session& session, const Camera& camera, const ComparisonSettings& settings,
                Progress& progress) {
    Trade trade;
    trade.basis = render_reference(session, camera, settings, progress);
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
            run_setting(session, camera, setting, settings, title, progress, trade);
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
