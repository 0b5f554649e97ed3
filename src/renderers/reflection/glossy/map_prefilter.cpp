// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/glossy/map_prefilter.h"

#include "gpu/budgeted_run.h"

#include "interop/bindings.h"
#include "interop/frame.h"
#include "interop/specialization.h"
#include "kernels/halve_map.h"
#include "kernels/prefilter_map.h"

#include <bit>

namespace utsuri {
namespace {

constexpr std::uint32_t kFaces = interop::GLOSSY_MAP_FACES;

/// Texels before a level of what is captured, whose edge halves from level to level.
std::uint32_t first_of_source_level(std::uint32_t size, std::uint32_t level) {
    const std::uint32_t at_level = size >> level;
    return 8 * (size * size - at_level * at_level);
}

/// The camera of a face of a cube about a point: x and y of shaders/lib/cube.glsl, rows from y = -1 upwards.
interop::CameraInfo face_camera(const glm::vec3& point, std::uint32_t face) {
    const auto axis = [&](std::uint32_t offset) {
        glm::vec3 unit(0.0f);
        unit[static_cast<int>((face / 2 + offset) % 3)] = 1.0f;
        return unit;
    };
    return {point, axis(1), -axis(2), face % 2 == 0 ? axis(0) : -axis(0)};
}

Specialization convolve_constants(const ConvolvedMaps& maps) {
    return {{interop::SPEC_KEEPS_DISTANCES, maps.keeps_distances ? 1u : 0u}};
}

}  // namespace

std::uint64_t prefiltered_texels(std::uint32_t level_size) {
    const std::uint64_t stride = std::uint64_t{level_size} + std::uint64_t{2} * interop::GLOSSY_MAP_BORDER;
    return kFaces * stride * stride;
}

std::uint64_t MapPrefilter::source_texels(std::uint32_t size) {
    return std::uint64_t{first_of_source_level(size, static_cast<std::uint32_t>(std::bit_width(size)) - 1)} +
           kFaces;
}

MapPrefilter::MapPrefilter(Device& device, const GpuScene& scene, const SurfaceLight& light,
                           const ConvolvedMaps& maps, std::uint32_t largest_source)
    : device_(device),
      tracer_(device, scene, light, interop::PROJECTION_PERSPECTIVE),
      halver_(device, "halve_map", kernels::halve_map, convolve_constants(maps),
              sizeof(interop::HalveMapPush)),
      convolver_(device, "prefilter_map", kernels::prefilter_map, convolve_constants(maps),
                 sizeof(interop::PrefilterMapPush)),
      source_(device, source_texels(largest_source) * sizeof(glm::vec3), "source of glossy maps"),
      inverse_distances_(device, (maps.keeps_distances ? source_texels(largest_source) : 1) * sizeof(float),
                         "inverse distances of the source of glossy maps"),
      halve_set_(halver_.bind({{interop::BINDING_MAP_TEXELS, &source_},
                               {interop::BINDING_MAP_INVERSE_DISTANCES, &inverse_distances_}})),
      convolve_set_(convolver_.bind({{interop::BINDING_MAP_TEXELS, &source_},
                                     {interop::BINDING_MAP_INVERSE_DISTANCES, &inverse_distances_},
                                     {interop::BINDING_GLOSSY_TEXELS, &maps.texels},
                                     {interop::BINDING_GLOSSY_INVERSE_DISTANCES, &maps.inverse_distances}})) {
    if (maps.keeps_distances) measurer_.emplace(device, scene, inverse_distances_);
}

void MapPrefilter::warm_up() {
    Film film(device_, interop::TILE_SIZE, interop::TILE_SIZE, "warm-up film");
    tracer_.warm_up(film, source_);
    device_.run("compile kernels", [&](const vk::raii::CommandBuffer& commands) {
        halver_.dispatch(commands, halve_set_, interop::HalveMapPush{}, 1);
        convolver_.dispatch(commands, convolve_set_, interop::PrefilterMapPush{}, 1);
    });
    if (measurer_) measurer_->warm_up();
}

FrameCounts MapPrefilter::capture(const glm::vec3& point, std::uint32_t size, FrameSettings frame,
                                  std::uint32_t samples) {
    FrameCounts counts;
    Film film(device_, size, size, "glossy map film");
    const std::uint32_t seed = frame.seed;
    for (std::uint32_t face = 0; face < kFaces; ++face) {
        frame.camera = face_camera(point, face);
        frame.seed = seed + face;
        accumulate(counts, tracer_.trace(film, frame, samples, source_, face * size * size));
    }
    if (measurer_) accumulate(counts, measurer_->measure(point, size, frame.excluded_instance));
    counts.gpu_seconds += device_.run("halve maps", [&](const vk::raii::CommandBuffer& commands) {
        for (std::uint32_t level = 1; size >> level > 0; ++level) {
            const std::uint32_t edge = size >> level;
            halver_.dispatch_over(commands, halve_set_,
                                  interop::HalveMapPush{first_of_source_level(size, level - 1),
                                                        first_of_source_level(size, level), edge, 0, 0},
                                  kFaces * edge * edge);
        }
    });
    return counts;
}

double MapPrefilter::convolve(const interop::PrefilterMapPush& push) {
    return run_in_budget(device_, "prefilter maps", convolver_, convolve_set_, push,
                         static_cast<std::uint32_t>(prefiltered_texels(push.size)), budget_);
}

}  // namespace utsuri
