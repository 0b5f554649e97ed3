// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/raster/frame_drawer.h"

#include "renderers/device_scene/scene_constants.h"
#include "renderers/reflection/raster/drawn_samples.h"

#include "interop/bindings.h"
#include "interop/specialization.h"
#include "kernels/draw_depth_vert.h"
#include "kernels/draw_hybrid_scene_frag.h"
#include "kernels/draw_scene_frag.h"
#include "kernels/draw_scene_vert.h"

namespace utsuri {
FrameDrawer::FrameDrawer(Device& device, const SceneData& data, MapKind kind,
                         const Specialization& specialization, const Bindings& bindings,
                         const ReflectorDrawer* reflectors, std::uint32_t width, std::uint32_t height)
    : FrameDrawer(device, data, plan_draws(data), kind, specialization, bindings, reflectors, width, height) {
}

FrameDrawer::FrameDrawer(Device& device, const SceneData& data, const DrawList& list, MapKind kind,
                         const Specialization& specialization, const Bindings& bindings,
                         const ReflectorDrawer* reflectors, std::uint32_t width, std::uint32_t height)
    : device_(require_graphics(device)),
      reflectors_(reflectors),
      frame_(*bindings.at(interop::BINDING_FRAME)),
      background_(background_of(data)),
      colour_(device, width, height, kColourFormat, "drawn picture"),
      deferred_(make_deferred(device, defers_reflections(data, kind), width, height)),
      depth_(device, width, height, kDepthFormat, "depth of the drawn picture"),
      triangles_(make_buffer<std::uint32_t>(device, list.triangles, "draw list")),
      triangle_count_(static_cast<std::uint32_t>(list.triangles.size())),
      depth_pass_(device, "draw_depth", kernels::draw_depth_vert, {}, depth_constants(specialization),
                  sizeof(interop::ViewPush), {}, {drawn_formats(deferred_.has_value(), false)}),
      depth_bindings_(depth_pass_.bind(with_draw_list(bindings))),
      batches_(make_batches(list.batches, specialization, bindings)) {}

Bindings FrameDrawer::with_draw_list(Bindings bindings) const {
    bindings[interop::BINDING_DRAW_LIST] = &triangles_;
    return bindings;
}

std::vector<FrameDrawer::Batch> FrameDrawer::make_batches(const std::vector<DrawBatch>& planned,
                                                          const Specialization& specialization,
                                                          const Bindings& bindings) {
    const auto fragment = deferred_.has_value()
                              ? std::span<const std::uint32_t>(kernels::draw_hybrid_scene_frag)
                              : std::span<const std::uint32_t>(kernels::draw_scene_frag);
    std::vector<Batch> batches;
    for (const DrawBatch& batch : planned) {
        RasterPipeline pipeline(device_, "draw_scene", kernels::draw_scene_vert, fragment,
                                with_features(specialization, batch.features), sizeof(interop::ViewPush),
                                DepthState{DepthTest::equal, 0.0f},
                                {drawn_formats(deferred_.has_value(), false)});
        BindingSet set = pipeline.bind(with_draw_list(bindings));
        batches.push_back({std::move(pipeline), std::move(set), batch.first, batch.count});
    }
    return batches;
}

void FrameDrawer::draw_cleared(const vk::raii::CommandBuffer& commands,
                               const std::function<void()>& record) const {
    std::vector targets = {ColourTarget{colour_, background_}};
    if (deferred_) targets.push_back({*deferred_, kNothingDeferred});
    draw_into(commands, targets, depth_, record);
}

void FrameDrawer::warm_up() {
    const interop::ViewPush nothing{};
    device_.run("compile pipelines", [&](const vk::raii::CommandBuffer& commands) {
        draw_cleared(commands, [&] {
            if (triangle_count_ > 0) depth_pass_.draw(commands, depth_bindings_, nothing, 0, 1);
            if (reflectors_) reflectors_->warm_up(commands);
            for (const Batch& batch : batches_)
                batch.pipeline.draw(commands, batch.bindings, nothing, batch.first, 1);
        });
    });
}

void FrameDrawer::record(const vk::raii::CommandBuffer& commands, const interop::CameraInfo& camera,
                         const interop::FrameInfo& frame) const {
    frame_.record_update(commands, std::as_bytes(std::span(&frame, 1)));
    interop::ViewPush view{};
    view.camera = camera;
    view.number = interop::VIEW_OF_EYE;
    draw_cleared(commands, [&] {
        // Depth first: a pixel shades only what it shows.
        depth_pass_.draw(commands, depth_bindings_, view, 0, triangle_count_);
        if (reflectors_) reflectors_->draw(commands, view);
        for (const Batch& batch : batches_)
            batch.pipeline.draw(commands, batch.bindings, view, batch.first, batch.count);
    });
}

DeferredPicture FrameDrawer::deferred_picture(const interop::CameraInfo& camera) const {
    return {colour_, deferred_.value(), nullptr, {{camera.origin, 0}}};
}

}  // namespace utsuri
