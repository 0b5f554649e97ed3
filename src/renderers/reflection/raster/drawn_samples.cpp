// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/raster/drawn_samples.h"

#include "base/error.h"
#include "base/sampler.h"

#include "interop/bindings.h"
#include "kernels/add_drawn.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <vector>

namespace utsuri {
namespace {

/// Distance of the near plane, as a share of the diagonal of the scene. With reversed floating point depth a
/// small one costs no precision.
constexpr double kNearShare = 0x1p-24;

std::uint32_t rows_of_bands(const Device& device, std::uint32_t width, std::uint32_t height) {
    return std::min(height, rows_per_band(device, width, sizeof(interop::FilmPixel)));
}

}  // namespace

Device& require_graphics(Device& device) {
    if (!device.summary().draws) {
        throw DeviceError("draw the scene", device.summary().name,
                          "this device has no raster pipeline; use --reflection trace, or another device");
    }
    return device;
}

std::array<float, 4> background_of(const SceneData& data) {
    const std::optional<std::uint32_t> environment = data.environment_light();
    if (!environment) return {0.0f, 0.0f, 0.0f, interop::DRAWN_PLAIN};
    const glm::vec3& radiance = data.lights[*environment].intensity;
    return {radiance.x, radiance.y, radiance.z, interop::DRAWN_PLAIN};
}

float near_plane(const SceneData& data) {
    return static_cast<float>(kNearShare * glm::length(glm::dvec3(data.bounds.extent())));
}

interop::FrameInfo frame_info(const SceneData& data, std::uint32_t width, std::uint32_t height) {
    interop::FrameInfo frame{};
    frame.jitter = {0.5f, 0.5f};
    frame.pixel_size = 1.0f / glm::vec2(width, height);
    frame.width = width;
    frame.near_plane = near_plane(data);
    return frame;
}

DrawnSamples::DrawnSamples(Device& device, std::uint32_t width, std::uint32_t height,
                           const Buffer& map_states)
    : device_(device),
      drawn_(device, std::uint64_t{width} * rows_of_bands(device, width, height) * sizeof(glm::vec4),
             "drawn rows"),
      counters_(device, "drawing counters"),
      add_kernel_(device, "add_drawn", kernels::add_drawn, {}, sizeof(interop::AddDrawnPush)),
      map_states_(map_states) {}

void DrawnSamples::begin(const Film& film) {
    sets_.clear();
    for (const Film::Band& band : film.bands()) {
        sets_.push_back(add_kernel_.bind({{interop::BINDING_FILM, &band.pixels},
                                          {interop::BINDING_DRAWN, &drawn_},
                                          {interop::BINDING_COUNTERS, &counters_.buffer()},
                                          {interop::BINDING_MAP_STATES, &map_states_}}));
    }
    counters_.clear();
}

double DrawnSamples::draw(const Film& film, interop::FrameInfo frame, const Attachment& colour,
                          const RecordPicture& record) {
    frame.sample_index = film.samples();
    frame.jitter =
        sample_2d(sampler_key({0, 0}, frame.seed, frame.sample_index & 1u), frame.sample_index >> 1, 0);
    return device_.run("draw the scene", [&](const vk::raii::CommandBuffer& commands) {
        record(commands, frame);
        for (std::size_t i = 0; i < sets_.size(); ++i) {
            const Film::Band& band = film.bands()[i];
            colour.copy_rows(commands, band.first_row, band.rows, drawn_);
            const interop::AddDrawnPush add{film.width() * band.rows, frame.sample_index};
            add_kernel_.dispatch(commands, sets_[i], add, group_count(add.pixels));
        }
    });
}

FrameCounts DrawnSamples::counts() const {
    return counters_.read("draw the scene", "pixels", "a smaller --depth");
}

}  // namespace utsuri
