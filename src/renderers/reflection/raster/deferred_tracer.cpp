// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/raster/deferred_tracer.h"

#include "renderers/film/film.h"
#include "renderers/film/film_kernel.h"

#include "base/check.h"

#include "interop/bindings.h"
#include "kernels/list_deferred.h"
#include "kernels/trace_deferred.h"

#include <glm/vec4.hpp>

#include <algorithm>

namespace utsuri {
namespace {

/// A band has no more pixels than one dispatch can follow.
std::uint32_t rows_of_bands(const Device& device, std::uint32_t width, std::uint32_t height) {
    return std::min({height, rows_per_band(device, width, sizeof(glm::vec4)),
                     std::max(1u, kMaxGroups * interop::WORKGROUP_SIZE / width)});
}

}  // namespace

bool defers_reflections(const SceneData& data, MapKind kind) {
    return kind == MapKind::hybrid && (data.requirements.glossy || data.requirements.mirror);
}

std::vector<vk::Format> drawn_formats(bool defers_reflections, bool has_mirrored_views) {
    std::vector<vk::Format> formats = {kColourFormat};
    if (has_mirrored_views) formats.push_back(kColourFormat);
    if (defers_reflections) formats.push_back(kWordsFormat);
    return formats;
}

std::optional<Attachment> make_deferred(Device& device, bool defers_reflections, std::uint32_t width,
                                        std::uint32_t height) {
    if (!defers_reflections) return std::nullopt;
    return Attachment(device, width, height, kWordsFormat, "deferred reflections");
}

DeferredTracer::DeferredTracer(Device& device, const Specialization& specialization, const Bindings& bindings,
                               std::uint32_t width, std::uint32_t height)
    : device_(device),
      width_(width),
      height_(height),
      rows_of_bands_(rows_of_bands(device, width, height)),
      drawn_(device, std::uint64_t{width} * rows_of_bands_ * sizeof(glm::vec4), "rows that wait for rays"),
      throughput_(device, drawn_.size(), "their throughput"),
      reflections_(device, drawn_.size(), "their deferred reflections"),
      views_(device, interop::DEFERRED_MOST_VIEWS * sizeof(interop::DeferredView),
             "views with deferred reflections"),
      count_(device, sizeof(interop::DeferredCount), "count of deferred reflections"),
      pixels_(device, std::uint64_t{width} * rows_of_bands_ * sizeof(std::uint32_t),
              "pixels with deferred reflections"),
      list_(device, "list_deferred", kernels::list_deferred, {}, sizeof(interop::DeferredPush)),
      trace_(device, "trace_deferred", kernels::trace_deferred, specialization,
             sizeof(interop::DeferredPush)),
      list_set_(list_.bind(with_lists(bindings))),
      trace_set_(trace_.bind(with_lists(bindings))) {}

Bindings DeferredTracer::with_lists(Bindings bindings) const {
    bindings[interop::BINDING_DRAWN] = &drawn_;
    bindings[interop::BINDING_THROUGHPUT] = &throughput_;
    bindings[interop::BINDING_DEFERRED] = &reflections_;
    bindings[interop::BINDING_DEFERRED_VIEWS] = &views_;
    bindings[interop::BINDING_DEFERRED_COUNT] = &count_;
    bindings[interop::BINDING_DEFERRED_PIXELS] = &pixels_;
    return bindings;
}

void DeferredTracer::warm_up() {
    reflections_.fill_with_zero();
    count_.fill_with_zero();
    device_.run("compile kernels", [&](const vk::raii::CommandBuffer& commands) {
        const interop::DeferredPush nothing{};
        list_.dispatch(commands, list_set_, nothing, 1);
        trace_.dispatch(commands, trace_set_, nothing, 1);
    });
}

void DeferredTracer::record(const vk::raii::CommandBuffer& commands, const DeferredPicture& drawn) const {
    UTSURI_CHECK_LE(drawn.views.size(), interop::DEFERRED_MOST_VIEWS);
    views_.record_update(commands, std::as_bytes(std::span(drawn.views)));
    for (std::uint32_t first = 0; first < height_; first += rows_of_bands_) {
        interop::DeferredPush push{first, std::min(rows_of_bands_, height_ - first), 0};
        drawn.picture.copy_rows(commands, first, push.rows, drawn_);
        drawn.reflections.copy_rows(commands, first, push.rows, reflections_);
        if (drawn.throughput) drawn.throughput->copy_rows(commands, first, push.rows, throughput_);
        const interop::DeferredCount none{0, 1, 1, 0};
        count_.record_update(commands, std::as_bytes(std::span(&none, 1)));
        const std::uint32_t tiles = tile_count(width_, push.rows);
        for (std::uint32_t done = 0; done < tiles; done += kMaxGroups) {
            push.first_tile = done;
            list_.dispatch(commands, list_set_, push, std::min(tiles - done, kMaxGroups));
        }
        trace_.dispatch_indirect(commands, trace_set_, push, count_);
        drawn.picture.replace_rows(commands, first, push.rows, drawn_);
    }
}

}  // namespace utsuri
