// SPDX-License-Identifier: Apache-2.0
#include "renderers/film/film_kernel.h"

#include "base/stopwatch.h"

#include "interop/bindings.h"

#include <algorithm>

namespace utsuri {
namespace {

/// Ray queries that one invocation may make in a dispatch. Mesa's software driver ends all loops of an
/// invocation after 65535 iterations together; a query takes some tens, 128 at most in scenes of a million
/// triangles.
constexpr std::uint32_t kQueriesPerInvocation = 512;

/// Samples that keep within kQueriesPerInvocation: for each surface of a specular chain there is a ray to
/// find it and a shadow ray; beyond the last one a ray of its glossy lobe.
std::uint32_t most_samples_per_dispatch(std::uint32_t max_depth) {
    const std::uint64_t queries = 2 * (std::uint64_t{max_depth} + 1) + 1;
    return static_cast<std::uint32_t>(std::max<std::uint64_t>(1, kQueriesPerInvocation / queries));
}

}  // namespace

std::uint32_t tile_count(std::uint32_t width, std::uint32_t rows) {
    const auto tiles = [](std::uint32_t pixels) {
        return (pixels + interop::TILE_SIZE - 1) / interop::TILE_SIZE;
    };
    return tiles(width) * tiles(rows);
}

FilmKernel::FilmKernel(Device& device, const std::string& name, std::span<const std::uint32_t> spirv,
                       const Specialization& specialization, Bindings bindings)
    : device_(&device),
      kernel_(device, name, spirv, specialization, sizeof(interop::FramePush)),
      bindings_(std::move(bindings)),
      counters_(device, name + " counters") {
    bindings_[interop::BINDING_COUNTERS] = &counters_.buffer();
}

double FilmKernel::warm_up(Film& film) {
    const Stopwatch stopwatch;
    const Film::Band& band = film.bands().front();
    Bindings bindings = bindings_;
    bindings[interop::BINDING_FILM] = &band.pixels;
    const BindingSet set = kernel_.bind(bindings);
    interop::FramePush push{};
    push.width = film.width();
    push.height = film.height();
    device_->run("compile a kernel",
                 [&](const vk::raii::CommandBuffer& commands) { kernel_.dispatch(commands, set, push, 1); });
    return stopwatch.seconds();
}

FrameCounts FilmKernel::add_samples(Film& film, const FrameSettings& settings, std::uint32_t count,
                                    Progress& progress) {
    FrameCounts counts;
    interop::FramePush push{};
    push.camera = settings.camera;
    push.width = film.width();
    push.height = film.height();
    push.seed = settings.seed;
    push.max_depth = settings.max_depth;
    push.excluded_instance = settings.excluded_instance;
    std::vector<BindingSet> sets;
    for (const Film::Band& band : film.bands()) {
        Bindings bindings = bindings_;
        bindings[interop::BINDING_FILM] = &band.pixels;
        sets.push_back(kernel_.bind(bindings));
    }
    const std::uint64_t tiles = tile_count(film.width(), film.height());
    std::uint32_t done = 0;
    while (done < count && !progress.cancelled()) {
        // Small pictures take several samples in a dispatch; in large ones a dispatch is a part of one
        // sample.
        const std::uint64_t fitting = std::clamp<std::uint64_t>(
            budget_.next_units() / tiles, 1, most_samples_per_dispatch(settings.max_depth));
        const auto now = static_cast<std::uint32_t>(std::min<std::uint64_t>(count - done, fitting));
        push.sample_begin = film.samples();
        push.sample_end = film.samples() + now;
        for (std::size_t i = 0; i < sets.size(); ++i)
            add_band(film, film.bands()[i], sets[i], push, counts);
        film.note_samples(now);
        done += now;
        progress.update(done, count);
    }
    return counts;
}

void FilmKernel::add_band(const Film& film, const Film::Band& band, const BindingSet& bindings,
                          interop::FramePush push, FrameCounts& counts) {
    push.first_row = band.first_row;
    push.rows = band.rows;
    const std::uint32_t tiles = tile_count(film.width(), band.rows);
    const std::uint32_t samples = push.sample_end - push.sample_begin;
    for (std::uint32_t done = 0; done < tiles;) {
        const std::uint64_t fitting = std::max<std::uint64_t>(1, budget_.next_units() / samples);
        const std::uint32_t now = static_cast<std::uint32_t>(
            std::min<std::uint64_t>({tiles - done, fitting, std::uint64_t{kMaxGroups}}));
        push.first_tile = done;
        counters_.clear();
        const double seconds = device_->run("render", [&](const vk::raii::CommandBuffer& commands) {
            kernel_.dispatch(commands, bindings, push, now);
        });
        budget_.record(std::uint64_t{now} * samples, seconds);
        accumulate(counts, counters_.read("render", "pixels", "a smaller --depth"));
        counts.gpu_seconds += seconds;
        done += now;
    }
}

}  // namespace utsuri
