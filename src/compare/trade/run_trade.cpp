// SPDX-License-Identifier: Apache-2.0
#include "compare/trade/run_trade.h"

#include "compare/comparison/measure.h"
#include "compare/comparison/reference.h"
#include "compare/trade/trade_sweep.h"

#include "base/command_line.h"
#include "image/shrink.h"
#include "image_io/image_io.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
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

/// A sweep as it goes on. Everything outlives it.
struct Sweep {
    Session& session;
    const Camera& camera;
    const ComparisonSettings& settings;
    Reference& reference;
    Trade& trade;
};

/// A run is measured again by a better reference unless the noise of this one is less than this share of its
/// mean squared error.
constexpr double kSmallNoise = 0.01;

/// Measures a picture, and keeps it itself only where a better reference would change its errors.
void measure_run(const Comparison& basis, TradeRun& run) {
    measure_errors(basis, run.result);
    run.result.flip = Plane();
    if (!(basis.reference_noise_mse >= kSmallNoise * run.result.metrics.mse)) run.result.image = Image();
}

TradeRun finish_run(const Comparison& basis, MethodResult result, std::vector<std::string> options) {
    TradeRun run{std::move(result), std::move(options), {}};
    run.picture =
        encode_jpeg(shrink_to_width(run.result.image, kPictureColumns), basis.exposure, kPictureQuality);
    measure_run(basis, run);
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

void run_setting(const Sweep& sweep, const TradeSetting& setting, const std::string& title,
                 Progress& progress) {
    sweep.session.reset_peak_memory();
    const ComparisonSettings& settings = sweep.settings;
    const PictureSettings picture_settings{setting.method, sweep.camera, settings.render, setting.maps,
                                           title};
    Picture picture = sweep.session.make_picture(picture_settings);
    progress.begin(title + ", preparing");
    picture.prepare(progress);
    progress.begin(title);
    picture.set_camera(sweep.camera);  // so that the time of a frame is what it takes when the eye moves
    std::vector<TradeRun>& runs = sweep.trade.runs;
    const std::size_t first = runs.size();
    for (const std::uint32_t samples : swept_samples(settings.samples)) {
        picture.add_samples(samples - picture.samples(), progress);
        if (picture.samples() < samples) return;
        MemoryUsage memory = sweep.session.memory();
        memory.peak -= sweep.reference.held_bytes();
        runs.push_back(finish_run(sweep.trade.basis, collect_result(picture_settings, picture, memory),
                                  setting.options));
        if (progress.cancelled()) return;
    }
    time_short_frames(picture, sweep.camera, std::span(runs).subspan(first), progress);
}

void run_settings(const Sweep& sweep, Progress& progress) {
    const std::vector<TradeSetting> swept = swept_settings(sweep.settings.methods, sweep.settings.maps);
    for (std::size_t i = 0; i < swept.size() && !progress.cancelled(); ++i) {
        const TradeSetting& setting = swept[i];
        const std::string title =
            fmt::format("{} of {}: {}", i + 1, swept.size(), shell_command(setting.options));
        try {
            run_setting(sweep, setting, title, progress);
        } catch (const Interrupted&) {
            break;
        } catch (const Error& error) {
            sweep.trade.failures.push_back(
                {setting.method, setting.options, error.what(), error.exit_code()});
        }
    }
}

double least_error(const Trade& trade) {
    double least = std::numeric_limits<double>::infinity();
    for (const TradeRun& run : trade.runs)
        least = std::min(least, run.result.metrics.mse);
    return least;
}

/// Adds samples to the reference until it is right enough for all runs, or its time is over, and measures
/// again those whose errors that changes. The exposure stays that of the pictures. If that fails the
/// reference stays as it was told: what runs took minutes for is not lost with it.
void refine_reference(const Sweep& sweep, Progress& progress) try {
    Comparison& basis = sweep.trade.basis;
    const double exposure = basis.exposure;
    while (!progress.cancelled() &&
           sweep.reference.grow(needed_reference_samples(basis, least_error(sweep.trade)), progress)) {
        sweep.reference.tell(basis);
        basis.exposure = exposure;
        progress.begin("measuring");
        for (TradeRun& run : sweep.trade.runs) {
            if (!run.result.image.pixels.empty()) measure_run(basis, run);
        }
    }
} catch (const Error& error) {
    const Method& method = sweep.trade.basis.reference.method;
    sweep.trade.failures.push_back({method, {"a better reference"}, error.what(), error.exit_code()});
}

void measure_noise(Trade& trade) {
    MethodResult half;
    half.image = std::move(trade.basis.reference_half);
    measure_errors(trade.basis, half);
    trade.noise = half.metrics;
    trade.noise_reflective = half.metrics_reflective;
}

}  // namespace

Trade run_trade(Session& session, const Camera& camera, const ComparisonSettings& settings,
                Progress& progress) {
    Trade trade;
    trade.basis = begin_comparison(session, camera, settings);
    Reference reference(session, camera, settings);
    reference.grow(first_reference_samples(settings), progress);
    reference.tell(trade.basis);
    if (progress.cancelled()) throw Interrupted();
    const Sweep sweep{session, camera, settings, reference, trade};
    run_settings(sweep, progress);
    if (!settings.reference_samples) refine_reference(sweep, progress);
    for (TradeRun& run : trade.runs)
        run.result.image = Image();
    measure_noise(trade);
    trade.interrupted = progress.cancelled();
    return trade;
}

}  // namespace utsuri
