// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection_map/frame_drawer.h"

#include "base/error.h"
#include "base/sampler.h"

#include "interop/bindings.h"
#include "kernels/add_drawn.h"
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
    if (!data.requirements.environment) return {0.0f, 0.0f, 0.0f, 1.0f};
    const glm::vec3& radiance = data.lights.front().intensity;
    return {radiance.x, radiance.y, radiance.z, 1.0f};
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

FrameDrawer::FrameDrawer(Device& device, const SceneData& data, const Specialization& specialization,
                         const Bindings& bindings, std::uint32_t width, std::uint32_t height)
    : device_(checked(device)),
      triangles_(static_cast<std::uint32_t>(data.bvh.triangles.size())),
      near_plane_(static_cast<float>(kNearShare * glm::length(glm::dvec3(data.bounds.extent())))),
      background_(background(data)),
      colour_(device, width, height, kColourFormat, "drawn picture"),
      depth_(device, width, height, kDepthFormat, "depth of the drawn picture"),
      drawn_(device, std::uint64_t{width} * rows_of_bands(device, width, height) * sizeof(glm::vec4),
             "drawn rows"),
      counters_(device, sizeof(interop::Counters), "drawing counters"),
      pipeline_(device, "draw_scene", kernels::draw_scene_vert, kernels::draw_scene_frag, specialization,
                sizeof(interop::RasterPush)),
      pipeline_bindings_(pipeline_.bind(bindings)),
      add_kernel_(device, "add_drawn", kernels::add_drawn, {}, sizeof(interop::AddDrawnPush)) {}

void FrameDrawer::warm_up() {
    draw({}, std::min(triangles_, 1u), nullptr, {});
}

double FrameDrawer::draw(const interop::RasterPush& push, std::uint32_t triangles, const Film* film,
                         const std::vector<BindingSet>& sets) {
    return device_.run("draw the scene", [&](const vk::raii::CommandBuffer& commands) {
        draw_into(commands, colour_, depth_, background_,
                  [&] { pipeline_.draw(commands, pipeline_bindings_, push, triangles); });
        for (std::size_t i = 0; i < sets.size(); ++i) {
            const Film::Band& band = film->bands()[i];
            colour_.copy_rows(commands, band.first_row, band.rows, drawn_);
            const interop::AddDrawnPush add{film->width() * band.rows, push.sample_index};
            add_kernel_.dispatch(commands, sets[i], add, (add.pixels + 63) / 64);
        }
    });
}

FrameCounts FrameDrawer::add_samples(Film& film, const interop::CameraInfo& camera, std::uint32_t seed,
                                     std::uint32_t count, Progress& progress) {
    std::vector<BindingSet> sets;
    for (const Film::Band& band : film.bands()) {
        sets.push_back(add_kernel_.bind({{interop::BINDING_FILM, &band.pixels},
                                         {interop::BINDING_DRAWN, &drawn_},
                                         {interop::BINDING_COUNTERS, &counters_}}));
    }
    interop::RasterPush push{};
    push.camera = camera;
    push.near_plane = near_plane_;
    push.seed = seed;
    push.pixel = 1.0f / glm::vec2(film.width(), film.height());
    counters_.fill_with_zero();
    FrameCounts counts;
    for (std::uint32_t done = 0; done < count && !progress.cancelled(); ++done) {
        push.sample_index = film.samples();
        push.jitter = sample_2d(sampler_key({0, 0}, seed, push.sample_index & 1u), push.sample_index >> 1, 0);
        counts.gpu_seconds += draw(push, triangles_, &film, sets);
        film.note_samples(1);
        progress.update(done + 1, count);
    }
    counts.nonfinite = counters_.download_records<interop::Counters>(1).front().nonfinite;
    return counts;
}

}  // namespace utsuri
