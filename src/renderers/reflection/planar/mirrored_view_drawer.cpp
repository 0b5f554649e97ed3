// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/planar/mirrored_view_drawer.h"

#include "renderers/device_scene/scene_constants.h"
#include "renderers/film/frame_camera.h"
#include "renderers/reflection/raster/deferred_tracer.h"

#include "interop/bindings.h"
#include "interop/specialization.h"
#include "kernels/draw_curved_vert.h"
#include "kernels/draw_depth_vert.h"
#include "kernels/draw_environment_vert.h"
#include "kernels/draw_mirrored_curved_frag.h"
#include "kernels/draw_mirrored_depth_frag.h"
#include "kernels/draw_mirrored_depth_vert.h"
#include "kernels/draw_mirrored_environment_frag.h"
#include "kernels/draw_mirrored_hybrid_environment_frag.h"
#include "kernels/draw_mirrored_hybrid_frag.h"
#include "kernels/draw_mirrored_hybrid_mirror_frag.h"
#include "kernels/draw_mirrored_hybrid_scene_frag.h"
#include "kernels/draw_mirrored_mirror_frag.h"
#include "kernels/draw_mirrored_scene_frag.h"
#include "kernels/draw_predicted_curved_vert.h"
#include "kernels/draw_scene_vert.h"

#include <algorithm>

namespace utsuri {
namespace {

Specialization with_faces(Specialization specialization, std::size_t faces) {
    specialization[interop::SPEC_FACE_COUNT] = static_cast<std::uint32_t>(faces);
    return specialization;
}

}  // namespace

MirroredViewDrawer::MirroredViewDrawer(Device& device, const SceneData& data, const PlaneMirrors& mirrors,
                                       const Reflectors& curved, MapKind kind,
                                       const std::vector<interop::MapFace>& faces,
                                       const Specialization& specialization, const Bindings& bindings)
    : MirroredViewDrawer(device, data, list_mirrored_view_triangles(data, mirrors, curved), kind, faces,
                         specialization, bindings) {}

MirroredViewDrawer::MirroredViewDrawer(Device& device, const SceneData& data, MirroredViewTriangles triangles,
                                       MapKind kind, const std::vector<interop::MapFace>& faces,
                                       const Specialization& specialization, const Bindings& bindings)
    : device_(device),
      defers_(defers_reflections(data, kind)),
      triangles_(std::move(triangles)),
      list_(make_buffer<std::uint32_t>(device, triangles_.listed, "draw list")),
      listed_reflectors_(
          make_buffer<std::uint32_t>(device, triangles_.reflectors, "reflectors of the draw list")),
      eye_depth_(make_pass("draw_depth", kernels::draw_depth_vert, {}, DepthTest::nearer,
                           depth_constants(specialization), bindings)) {
    using Stage = std::span<const std::uint32_t>;
    const Stage scene =
        defers_ ? Stage(kernels::draw_mirrored_hybrid_scene_frag) : Stage(kernels::draw_mirrored_scene_frag);
    for (const DrawBatch& batch : triangles_.batches) {
        batches_.push_back(
            {make_pass("draw_mirrored_scene", kernels::draw_scene_vert, scene, DepthTest::equal,
                       with_features(specialization, batch.features), bindings),
             {batch.first, batch.count}});
    }
    if (triangles_.curved.count > 0) {
        const Stage vertex =
            defers_ ? Stage(kernels::draw_predicted_curved_vert) : Stage(kernels::draw_curved_vert);
        const Stage fragment =
            defers_ ? Stage(kernels::draw_mirrored_hybrid_frag) : Stage(kernels::draw_mirrored_curved_frag);
        curved_.emplace(make_pass(
            "draw_mirrored_curved", vertex, fragment, DepthTest::equal,
            with_faces(with_features(specialization, triangles_.curved_features), faces.size()), bindings));
    }
    if (triangles_.mirrors.empty()) return;
    view_depth_.emplace(make_pass("draw_mirrored_depth", kernels::draw_mirrored_depth_vert,
                                  kernels::draw_mirrored_depth_frag, DepthTest::nearer,
                                  depth_constants(specialization), bindings));
    const Stage mirror = defers_ ? Stage(kernels::draw_mirrored_hybrid_mirror_frag)
                                 : Stage(kernels::draw_mirrored_mirror_frag);
    mirrors_.emplace(make_pass("draw_mirrored_mirror", kernels::draw_scene_vert, mirror, DepthTest::equal,
                               with_features(specialization, triangles_.mirror_features), bindings));
    if (!data.requirements.environment) return;
    const Stage environment = defers_ ? Stage(kernels::draw_mirrored_hybrid_environment_frag)
                                      : Stage(kernels::draw_mirrored_environment_frag);
    environment_.emplace(make_pass("draw_mirrored_environment", kernels::draw_environment_vert, environment,
                                   DepthTest::equal, specialization, bindings));
}

Bindings MirroredViewDrawer::all_bindings(Bindings bindings) const {
    bindings.merge(Bindings{{interop::BINDING_DRAW_LIST, &list_},
                            {interop::BINDING_LISTED_REFLECTORS, &listed_reflectors_}});
    return bindings;
}

MirroredViewDrawer::Pass MirroredViewDrawer::make_pass(
    const std::string& name, std::span<const std::uint32_t> vertex, std::span<const std::uint32_t> fragment,
    const DepthTest depth, const Specialization& specialization, const Bindings& bindings) const {
    // Depth is drawn first, so that a pixel shades only what it shows.
    const bool writes_colour = depth == DepthTest::equal;
    RasterPipeline pipeline(device_, name, vertex, fragment, specialization, sizeof(interop::ViewPush),
                            {depth, 0.0f}, {drawn_formats(defers_, true), writes_colour});
    BindingSet set = pipeline.bind(all_bindings(bindings));
    return {std::move(pipeline), std::move(set)};
}

void MirroredViewDrawer::warm_up(const vk::raii::CommandBuffer& commands) const {
    if (triangles_.listed.empty()) return;
    const interop::ViewPush nothing{};
    eye_depth_.pipeline.draw(commands, eye_depth_.bindings, nothing, 0, 1);
    for (const Batch& batch : batches_)
        batch.pass.pipeline.draw(commands, batch.pass.bindings, nothing, batch.range.first, 1);
    for (const std::optional<Pass>* pass : {&curved_, &view_depth_, &mirrors_, &environment_}) {
        if (*pass) (*pass)->pipeline.draw(commands, (*pass)->bindings, nothing, 0, 1);
    }
}

void MirroredViewDrawer::draw(const vk::raii::CommandBuffer& commands, const std::vector<MirroredView>& views,
                              std::uint32_t index) const {
    const MirroredView& view = views[index];
    limit_to(commands, view.window);
    interop::ViewPush push{};
    const PixelRect& picture = views.front().window;
    push.camera = make_camera_info(view.eye, glm::dvec3(0.0), picture.width, picture.height);
    push.normal = glm::vec3(view.normal);
    push.offset = static_cast<float>(view.offset);
    push.number = interop::VIEW_OF_EYE + index;
    push.reflections = view.reflections;
    draw_depth(commands, view, push);
    for (const Batch& batch : batches_)
        batch.pass.pipeline.draw(commands, batch.pass.bindings, push, batch.range.first, batch.range.count);
    if (curved_)
        curved_->pipeline.draw(commands, curved_->bindings, push, triangles_.curved.first,
                               triangles_.curved.count);
    draw_mirrors(commands, view, push);
    if (environment_ && view.mirror != interop::NONE)
        environment_->pipeline.draw(commands, environment_->bindings, push, 0, 1);
}

void MirroredViewDrawer::draw_depth(const vk::raii::CommandBuffer& commands, const MirroredView& view,
                                    const interop::ViewPush& push) const {
    const Pass& pass = view.mirror == interop::NONE ? eye_depth_ : *view_depth_;
    std::uint32_t first = 0;
    for (const std::uint32_t unseen : view.unseen) {
        const TriangleRange& range = triangles_.mirrors[unseen];
        pass.pipeline.draw(commands, pass.bindings, push, first, range.first - first);
        first = range.end();
    }
    const auto end = static_cast<std::uint32_t>(triangles_.listed.size());
    pass.pipeline.draw(commands, pass.bindings, push, first, end - first);
}

void MirroredViewDrawer::draw_mirrors(const vk::raii::CommandBuffer& commands, const MirroredView& view,
                                      interop::ViewPush push) const {
    auto shown = view.shown.begin();
    auto unseen = view.unseen.begin();
    for (std::uint32_t mirror = 0; mirror < triangles_.mirrors.size(); ++mirror) {
        if (unseen != view.unseen.end() && *unseen == mirror) {
            ++unseen;
            continue;
        }
        push.next = interop::VIEW_TRUNCATED;
        if (shown != view.shown.end() && shown->mirror == mirror)
            push.next = interop::VIEW_OF_EYE + (shown++)->view;
        const TriangleRange& range = triangles_.mirrors[mirror];
        mirrors_->pipeline.draw(commands, mirrors_->bindings, push, range.first, range.count);
    }
}

}  // namespace utsuri
