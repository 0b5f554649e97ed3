// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection_map/frame_drawer.h"

#include "base/error.h"
#include "base/sampler.h"

#include "interop/bindings.h"
#include "interop/specialization.h"
#include "kernels/add_drawn.h"
#include "kernels/draw_depth_vert.h"
#include "kernels/draw_scene_frag.h"
#include "kernels/draw_scene_vert.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>

namespace utsuri {
namespace {

/// Distance of the near plane, as a share of the diagonal of the scene. With reversed floating point depth a
/// small one costs no precision.
constexpr double kNearShare = 0x1p-24;

std::array<float, 4> background(const SceneData& data) {
    if (!data.requirements.environment) return {0.0f, 0.0f, 0.0f, interop::DRAWN_PLAIN};
    const glm::vec3& radiance = data.lights.front().intensity;
    return {radiance.x, radiance.y, radiance.z, interop::DRAWN_PLAIN};
}

/// @throws DeviceError if the device has no raster pipeline
Device& checked(Device& device) {
    if (!device.summary().draws) {
        throw DeviceError("draw the scene", device.summary().name,
                          "this device has no raster pipeline; use --reflection trace, or another device");
    }
    return device;
}

std::uint32_t rows_of_bands(const Device& device, std::uint32_t width, std::uint32_t height) {
    return std::min(height, rows_per_band(device, width, sizeof(interop::FilmPixel)));
}

}  // namespace

float near_plane(const SceneData& data) {
    return static_cast<float>(kNearShare * glm::length(glm::dvec3(data.bounds.extent())));
}

FrameDrawer::FrameDrawer(Device& device, const SceneData& data, const Specialization& specialization,
                         const Bindings& bindings, const ReflectorDrawer* reflectors, std::uint32_t width,
                         std::uint32_t height)
    : FrameDrawer(device, data, plan_draws(data), specialization, bindings, reflectors, width, height) {}

FrameDrawer::FrameDrawer(Device& device, const SceneData& data, const DrawList& list,
                         const Specialization& specialization, const Bindings& bindings,
                         const ReflectorDrawer* reflectors, std::uint32_t width, std::uint32_t height)
    : device_(checked(device)),
      reflectors_(reflectors),
      near_plane_(near_plane(data)),
      background_(background(data)),
      colour_(device, width, height, kColourFormat, "drawn picture"),
      depth_(device, width, height, kDepthFormat, "depth of the drawn picture"),
      drawn_(device, std::uint64_t{width} * rows_of_bands(device, width, height) * sizeof(glm::vec4),
             "drawn rows"),
      counters_(device, sizeof(interop::Counters), "drawing counters"),
      triangles_(make_buffer<std::uint32_t>(device, list.triangles, "draw list")),
      triangle_count_(static_cast<std::uint32_t>(list.triangles.size())),
      depth_pass_(device, "draw_depth", kernels::draw_depth_vert, {}, {}, sizeof(interop::RasterPush)),
      depth_bindings_(depth_pass_.bind(with_draw_list(bindings))),
      batches_(make_batches(list.batches, specialization, bindings)),
      add_kernel_(device, "add_drawn", kernels::add_drawn, {}, sizeof(interop::AddDrawnPush)) {}

Bindings FrameDrawer::with_draw_list(Bindings bindings) const {
    bindings[interop::BINDING_DRAW_LIST] = &triangles_;
    return bindings;
}

std::vector<FrameDrawer::Batch> FrameDrawer::make_batches(const std::vector<DrawBatch>& planned,
                                                          const Specialization& specialization,
                                                          const Bindings& bindings) {
    std::vector<Batch> batches;
    for (const DrawBatch& batch : planned) {
        Specialization constants = specialization;
        constants[interop::SPEC_HAS_TEXTURES] = batch.features.textured ? 1 : 0;
        constants[interop::SPEC_HAS_GLOSSY] = batch.features.glossy ? 1 : 0;
        RasterPipeline pipeline(device_, "draw_scene", kernels::draw_scene_vert, kernels::draw_scene_frag,
                                constants, sizeof(interop::RasterPush), DepthState{DepthTest::equal, 0.0f});
        BindingSet set = pipeline.bind(with_draw_list(bindings));
        batches.push_back({std::move(pipeline), std::move(set), batch.first, batch.count});
    }
    return batches;
}

void FrameDrawer::warm_up() {
    const interop::RasterPush nothing{};
    device_.run("compile pipelines", [&](const vk::raii::CommandBuffer& commands) {
        draw_into(commands, colour_, depth_, background_, [&] {
            if (triangle_count_ > 0) depth_pass_.draw(commands, depth_bindings_, nothing, 0, 1);
            if (reflectors_) reflectors_->warm_up(commands);
            for (const Batch& batch : batches_)
                batch.pipeline.draw(commands, batch.bindings, nothing, batch.first, 1);
        });
    });
}

double FrameDrawer::draw(const interop::RasterPush& push, const Film& film,
                         const std::vector<BindingSet>& sets) {
    return device_.run("draw the scene", [&](const vk::raii::CommandBuffer& commands) {
        draw_into(commands, colour_, depth_, background_, [&] {
            // Depth first: a pixel shades only what it shows.
            depth_pass_.draw(commands, depth_bindings_, push, 0, triangle_count_);
            if (reflectors_) reflectors_->draw(commands, push);
            for (const Batch& batch : batches_)
                batch.pipeline.draw(commands, batch.bindings, push, batch.first, batch.count);
        });
        for (std::size_t i = 0; i < sets.size(); ++i) {
            const Film::Band& band = film.bands()[i];
            colour_.copy_rows(commands, band.first_row, band.rows, drawn_);
            const interop::AddDrawnPush add{film.width() * band.rows, push.sample_index};
            add_kernel_.dispatch(commands, sets[i], add, (add.pixels + 63) / 64);
        }
    });
}

FrameCounts FrameDrawer::add_samples(Film& film, const DrawSettings& settings, std::uint32_t count,
                                     Progress& progress) {
    std::vector<BindingSet> sets;
    for (const Film::Band& band : film.bands()) {
        sets.push_back(add_kernel_.bind({{interop::BINDING_FILM, &band.pixels},
                                         {interop::BINDING_DRAWN, &drawn_},
                                         {interop::BINDING_COUNTERS, &counters_}}));
    }
    interop::RasterPush push{};
    push.camera = settings.camera;
    push.near_plane = near_plane_;
    push.seed = settings.seed;
    push.specular_depth = settings.specular_depth;
    push.excluded_instance = interop::NONE;
    push.tolerance = settings.tolerance;
    push.pixel = 1.0f / glm::vec2(film.width(), film.height());
    counters_.fill_with_zero();
    FrameCounts counts;
    for (std::uint32_t done = 0; done < count && !progress.cancelled(); ++done) {
        push.sample_index = film.samples();
        push.jitter =
            sample_2d(sampler_key({0, 0}, settings.seed, push.sample_index & 1u), push.sample_index >> 1, 0);
        counts.gpu_seconds += draw(push, film, sets);
        film.note_samples(1);
        progress.update(done + 1, count);
    }
    const auto totals = counters_.download_records<interop::Counters>(1).front();
    counts.nonfinite = totals.nonfinite;
    counts.lookups = totals.lookups;
    counts.traced = totals.traced;
    counts.rays = totals.rays;
    return counts;
}

}  // namespace utsuri
