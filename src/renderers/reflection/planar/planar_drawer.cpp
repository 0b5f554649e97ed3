// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/planar/planar_drawer.h"

#include "renderers/reflection/raster/drawn_samples.h"

#include "interop/bindings.h"

namespace utsuri {
namespace {

std::uint64_t picture_bytes(std::uint32_t width, std::uint32_t height) {
    return std::uint64_t{width} * height * sizeof(glm::vec4);
}

}  // namespace

PlanarDrawer::PlanarDrawer(Device& device, const SceneData& data, const PlaneMirrors& mirrors,
                           const Reflectors& curved, MapKind kind, const std::vector<interop::MapFace>& faces,
                           const Specialization& specialization, const Bindings& bindings,
                           std::uint32_t width, std::uint32_t height)
    : device_(require_graphics(device)),
      frame_(*bindings.at(interop::BINDING_FRAME)),
      background_(background_of(data)),
      colour_(device, width, height, kColourFormat, "drawn picture"),
      throughput_(device, width, height, kColourFormat, "throughput of the drawn picture"),
      deferred_(make_deferred(device, defers_reflections(data, kind), width, height)),
      depth_(device, width, height, kDepthFormat, "depth of the drawn picture"),
      drawn_before_(device, picture_bytes(width, height), "picture before a view"),
      throughput_before_(device, picture_bytes(width, height), "throughput before a view"),
      drawer_(device, data, mirrors, curved, kind, faces, specialization, with_pictures(bindings)) {}

Bindings PlanarDrawer::with_pictures(Bindings bindings) const {
    bindings[interop::BINDING_DRAWN] = &drawn_before_;
    bindings[interop::BINDING_THROUGHPUT] = &throughput_before_;
    return bindings;
}

std::vector<ColourTarget> PlanarDrawer::targets(const std::optional<std::array<float, 4>>& background) const {
    std::vector targets = {ColourTarget{colour_, background}, ColourTarget{throughput_, background}};
    if (!deferred_) return targets;
    targets.push_back({*deferred_, background ? std::optional(kNothingDeferred) : std::nullopt});
    return targets;
}

void PlanarDrawer::warm_up() {
    device_.run("compile pipelines", [&](const vk::raii::CommandBuffer& commands) {
        draw_into(commands, targets(background_), depth_, [&] { drawer_.warm_up(commands); });
    });
}

void PlanarDrawer::record(const vk::raii::CommandBuffer& commands, const std::vector<MirroredView>& views,
                          const interop::FrameInfo& frame) const {
    frame_.record_update(commands, std::as_bytes(std::span(&frame, 1)));
    std::optional<std::array<float, 4>> background = background_;
    for (std::uint32_t next = 0; next < views.size();) {
        if (next > 0) {
            colour_.copy_rows(commands, 0, colour_.height(), drawn_before_);
            throughput_.copy_rows(commands, 0, throughput_.height(), throughput_before_);
        }
        const std::uint32_t reflections = views[next].reflections;
        draw_into(commands, targets(background), depth_, [&] {
            for (; next < views.size() && views[next].reflections == reflections; ++next)
                drawer_.draw(commands, views, next);
        });
        background.reset();
    }
}

DeferredPicture PlanarDrawer::deferred_picture(const std::vector<MirroredView>& views) const {
    std::vector<interop::DeferredView> deferred;
    deferred.reserve(views.size());
    for (const MirroredView& view : views)
        deferred.push_back({glm::vec3(view.eye.position), view.reflections});
    return {colour_, deferred_.value(), &throughput_, std::move(deferred)};
}

}  // namespace utsuri
