// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/raster/reflector_drawer.h"

#include "renderers/device_scene/scene_constants.h"
#include "renderers/reflection/raster/deferred_tracer.h"

#include "base/check.h"

#include "interop/bindings.h"
#include "interop/specialization.h"
#include "kernels/cut_polygons.h"
#include "kernels/draw_cut_pieces_vert.h"
#include "kernels/draw_distance_reflector_frag.h"
#include "kernels/draw_hybrid_reflector_frag.h"
#include "kernels/draw_predicted_reflectors_vert.h"
#include "kernels/draw_radiance_hybrid_reflector_frag.h"
#include "kernels/draw_reflector_depth_vert.h"
#include "kernels/draw_reflector_frag.h"
#include "kernels/draw_reflectors_vert.h"
#include "kernels/draw_whole_pieces_vert.h"
#include "kernels/prefix_sum.h"
#include "kernels/reflect_vertices.h"
#include "kernels/sort_polygons.h"

#include <algorithm>
#include <numeric>

namespace utsuri {
namespace {

/// Room for cut pieces: most polygons lie within a face; those that straddle give some five pieces. What
/// finds no room is drawn whole.
std::uint32_t room_for_cut_pieces(std::size_t polygons) {
    constexpr std::size_t kSpare = 4096;
    return static_cast<std::uint32_t>(polygons / 2 + kSpare);
}

/// How far whole polygons are drawn behind their pieces, in units in the last place of their depth: more than
/// the rounding by which the two may differ, so that they show in gaps alone.
constexpr float kBehindPieces = 16.0f;

/// What any of the reflectors needs.
SurfaceFeatures features_of(const SceneData& data, const Reflectors& reflectors) {
    SurfaceFeatures all;
    for (const interop::ReflectorTriangle& triangle : reflectors.triangles)
        all = all | data.requirements.surfaces[data.triangle_infos[triangle.triangle].material];
    return all;
}

std::span<const std::uint32_t> whole_fragment(MapKind kind, Tolerance::Of tolerance) {
    if (kind == MapKind::distance) return kernels::draw_distance_reflector_frag;
    if (kind == MapKind::hybrid) {
        return tolerance == Tolerance::Of::radiance
                   ? std::span<const std::uint32_t>(kernels::draw_radiance_hybrid_reflector_frag)
                   : std::span<const std::uint32_t>(kernels::draw_hybrid_reflector_frag);
    }
    return kernels::draw_reflector_frag;
}

std::span<const std::uint32_t> whole_vertex(MapKind kind) {
    return kind == MapKind::hybrid ? std::span<const std::uint32_t>(kernels::draw_predicted_reflectors_vert)
                                   : std::span<const std::uint32_t>(kernels::draw_reflectors_vert);
}

/// Of polygons drawn whole: behind pieces if there are any, else after their depth.
DepthState whole_depth(MapKind kind) {
    return kind == MapKind::polygon ? DepthState{DepthTest::nearer, kBehindPieces}
                                    : DepthState{DepthTest::equal, 0.0f};
}

Specialization add_constants(Specialization specialization, const SurfaceFeatures& features,
                             std::uint32_t map_kind, std::size_t faces) {
    specialization = with_features(std::move(specialization), features);
    specialization[interop::SPEC_MAP_KIND] = map_kind;
    specialization[interop::SPEC_FACE_COUNT] = static_cast<std::uint32_t>(faces);
    return specialization;
}

/// The last one first: of those at the same place the first shows then, as it does to rays.
std::vector<std::uint32_t> all_polygons(std::uint32_t count) {
    std::vector<std::uint32_t> polygons(count);
    std::iota(polygons.rbegin(), polygons.rend(), 0u);
    return polygons;
}

}  // namespace

std::uint32_t whole_map_kind(MapKind kind) {
    switch (kind) {
        case MapKind::polygon:
            return interop::MAP_KIND_POLYGON;
        case MapKind::sphere:
            return interop::MAP_KIND_SPHERE;
        case MapKind::cube:
            return interop::MAP_KIND_CUBE;
        case MapKind::proxy:
            return interop::MAP_KIND_PROXY;
        case MapKind::distance:
        case MapKind::hybrid:
            return interop::MAP_KIND_DISTANCE;
    }
    fail_check(__FILE__, __LINE__, "a kind of map that cannot be drawn");
}

ReflectorDrawer::ReflectorDrawer(Device& device, const SceneData& data, const Reflectors& reflectors,
                                 MapKind kind, const std::vector<interop::MapFace>& faces,
                                 std::optional<std::uint32_t> most_cut_pieces, Tolerance::Of tolerance,
                                 const Specialization& specialization, const Bindings& bindings)
    : device_(device),
      features_(features_of(data, reflectors)),
      vertex_count_(static_cast<std::uint32_t>(reflectors.vertices.size())),
      clip_{static_cast<std::uint32_t>(reflectors.triangles.size()), static_cast<std::uint32_t>(faces.size()),
            kind == MapKind::polygon
                ? most_cut_pieces.value_or(room_for_cut_pieces(reflectors.triangles.size()))
                : 1,
            0, 0},
      vertices_(make_buffer<interop::ReflectorVertex>(device, reflectors.vertices, "reflector vertices")),
      triangles_(
          make_buffer<interop::ReflectorTriangle>(device, reflectors.triangles, "reflector triangles")),
      vertex_reflections_(device, std::max(1u, vertex_count_) * sizeof(interop::VertexReflection),
                          "vertex reflections"),
      straddling_(device, (clip_.polygons + 1) * sizeof(std::uint32_t), "straddling polygons before each"),
      drawn_polygons_(
          make_buffer<std::uint32_t>(device, all_polygons(clip_.polygons), "polygons drawn whole")),
      cut_counts_(device, (clip_.polygons + 1) * sizeof(std::uint32_t), "cut pieces before each"),
      whole_pieces_(device, std::max(1u, clip_.polygons) * sizeof(interop::Piece), "whole pieces"),
      cut_pieces_(device, clip_.most_cut * sizeof(interop::Piece), "cut pieces"),
      cut_corners_(device, 3 * std::uint64_t{clip_.most_cut} * sizeof(interop::PieceCorner),
                   "corners of cut pieces"),
      draw_arguments_(device, 3 * sizeof(interop::DrawArguments), "draw arguments"),
      vertex_kernel_(device, "reflect_vertices", kernels::reflect_vertices, {},
                     sizeof(interop::ReflectVerticesPush)),
      vertex_set_(vertex_kernel_.bind(with_polygons({}))),
      whole_(device, "draw_reflectors", whole_vertex(kind), whole_fragment(kind, tolerance),
             specialise(specialization, kind, faces.size()), sizeof(interop::ViewPush), whole_depth(kind),
             {drawn_formats(defers_reflections(data, kind), false)}),
      whole_set_(whole_.bind(with_polygons(bindings))) {
    for (Buffer* buffer : {&whole_pieces_, &cut_pieces_, &cut_corners_, &draw_arguments_})
        buffer->fill_with_zero();
    if (kind == MapKind::polygon) {
        clipping_.emplace(make_clipping(
            add_constants(specialization, features_, interop::MAP_KIND_PIECES, faces.size()), bindings));
    } else {
        depth_.emplace(make_depth_pass(depth_constants(specialization),
                                       drawn_formats(defers_reflections(data, kind), false), bindings));
    }
}

Specialization ReflectorDrawer::specialise(const Specialization& others, MapKind kind,
                                           std::size_t faces) const {
    return add_constants(others, features_, whole_map_kind(kind), faces);
}

Bindings ReflectorDrawer::with_polygons(Bindings others) const {
    others.merge(Bindings{{interop::BINDING_REFLECTOR_VERTICES, &vertices_},
                          {interop::BINDING_REFLECTOR_TRIANGLES, &triangles_},
                          {interop::BINDING_VERTEX_REFLECTIONS, &vertex_reflections_},
                          {interop::BINDING_STRADDLING, &straddling_},
                          {interop::BINDING_DRAWN_POLYGONS, &drawn_polygons_},
                          {interop::BINDING_CUT_COUNTS, &cut_counts_},
                          {interop::BINDING_WHOLE_PIECES, &whole_pieces_},
                          {interop::BINDING_CUT_PIECES, &cut_pieces_},
                          {interop::BINDING_CUT_CORNERS, &cut_corners_},
                          {interop::BINDING_DRAW_ARGUMENTS, &draw_arguments_}});
    return others;
}

ReflectorDrawer::DepthPass ReflectorDrawer::make_depth_pass(const Specialization& specialization,
                                                            const std::vector<vk::Format>& formats,
                                                            const Bindings& bindings) const {
    RasterPipeline pipeline(device_, "draw_reflector_depth", kernels::draw_reflector_depth_vert, {},
                            specialization, sizeof(interop::ViewPush), {}, {formats});
    BindingSet set = pipeline.bind(with_polygons(bindings));
    return {std::move(pipeline), std::move(set)};
}

ReflectorDrawer::TwoRuns ReflectorDrawer::make_two_runs(const std::string& name,
                                                        std::span<const std::uint32_t> spirv,
                                                        Specialization specialization,
                                                        const Kernel& prefix_sum, const Buffer& counts,
                                                        const Bindings& all) const {
    Kernel count(device_, name + ", counting", spirv, specialization, sizeof(interop::ClipPush));
    specialization[interop::SPEC_WRITES] = 1;
    Kernel write(device_, name + ", writing", spirv, specialization, sizeof(interop::ClipPush));
    BindingSet count_set = count.bind(all);
    BindingSet sum_set = prefix_sum.bind({{interop::BINDING_SUMMED_COUNTS, &counts}});
    BindingSet write_set = write.bind(all);
    return {std::move(count), std::move(write), std::move(count_set), std::move(sum_set),
            std::move(write_set)};
}

ReflectorDrawer::Clipping ReflectorDrawer::make_clipping(const Specialization& specialization,
                                                         const Bindings& bindings) const {
    const Bindings all = with_polygons(bindings);
    Kernel prefix_sum(device_, "prefix_sum", kernels::prefix_sum, {}, sizeof(interop::PrefixSumPush));
    TwoRuns sort =
        make_two_runs("sort_polygons", kernels::sort_polygons, specialization, prefix_sum, straddling_, all);
    TwoRuns cut =
        make_two_runs("cut_polygons", kernels::cut_polygons, specialization, prefix_sum, cut_counts_, all);
    RasterPipeline draw_whole(device_, "draw_whole_pieces", kernels::draw_whole_pieces_vert,
                              kernels::draw_reflector_frag, specialization, sizeof(interop::ViewPush));
    RasterPipeline draw_cut(device_, "draw_cut_pieces", kernels::draw_cut_pieces_vert,
                            kernels::draw_reflector_frag, specialization, sizeof(interop::ViewPush));
    BindingSet draw_whole_set = draw_whole.bind(all);
    BindingSet draw_cut_set = draw_cut.bind(all);
    return {std::move(prefix_sum), std::move(sort),           std::move(cut),         std::move(draw_whole),
            std::move(draw_cut),   std::move(draw_whole_set), std::move(draw_cut_set)};
}

void ReflectorDrawer::run_twice(const vk::raii::CommandBuffer& commands, const TwoRuns& runs) const {
    runs.count.dispatch_over(commands, runs.count_set, clip_, clip_.polygons);
    clipping_->prefix_sum.dispatch(commands, runs.sum_set, interop::PrefixSumPush{clip_.polygons}, 1);
    runs.write.dispatch_over(commands, runs.write_set, clip_, clip_.polygons);
}

double ReflectorDrawer::set_eye(const interop::ReflectVerticesPush& eye) {
    return device_.run("reflect vertices", [&](const vk::raii::CommandBuffer& commands) {
        vertex_kernel_.dispatch_over(commands, vertex_set_, eye, vertex_count_);
        if (!clipping_) return;
        run_twice(commands, clipping_->sort);
        run_twice(commands, clipping_->cut);
    });
}

void ReflectorDrawer::warm_up(const vk::raii::CommandBuffer& commands) const {
    const interop::ViewPush nothing{};
    if (clipping_) {
        clipping_->draw_whole.draw(commands, clipping_->draw_whole_set, nothing, 0, 1);
        clipping_->draw_cut.draw(commands, clipping_->draw_cut_set, nothing, 0, 1);
    }
    if (depth_) depth_->pipeline.draw(commands, depth_->bindings, nothing, 0, 1);
    whole_.draw(commands, whole_set_, nothing, 0, 1);
}

void ReflectorDrawer::draw(const vk::raii::CommandBuffer& commands, const interop::ViewPush& push) const {
    if (depth_) {
        depth_->pipeline.draw(commands, depth_->bindings, push, 0, clip_.polygons);
        return whole_.draw(commands, whole_set_, push, 0, clip_.polygons);
    }
    clipping_->draw_whole.draw_indirect(commands, clipping_->draw_whole_set, push, draw_arguments_, 0);
    clipping_->draw_cut.draw_indirect(commands, clipping_->draw_cut_set, push, draw_arguments_, 1);
    // Of a cut polygon's outline next to one that is not cut there rounding can leave a pixel open.
    whole_.draw_indirect(commands, whole_set_, push, draw_arguments_, 2);
}

ReflectorDrawer::Pieces ReflectorDrawer::pieces() const {
    const auto arguments = draw_arguments_.download_records<interop::DrawArguments>(3);
    return {whole_pieces_.download_records<interop::Piece>(arguments[0].vertex_count / 3),
            cut_pieces_.download_records<interop::Piece>(arguments[1].vertex_count / 3),
            cut_corners_.download_records<interop::PieceCorner>(arguments[1].vertex_count)};
}

}  // namespace utsuri
