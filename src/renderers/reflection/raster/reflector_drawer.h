// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/reflection/reflectors/map_kind.h"
#include "renderers/reflection/reflectors/reflectors.h"
#include "renderers/reflection/reflectors/tolerance.h"

#include "gpu/kernel.h"
#include "gpu/raster_pipeline.h"

#include "interop/raster.h"

#include <optional>

namespace utsuri {

/// How whole polygons address maps of a kind: a MAP_KIND_ of interop/reflection.h.
std::uint32_t whole_map_kind(MapKind kind);

/// Draws the polygons of reflectors with what they reflect. Where reflection vectors are found per vertex,
/// polygons that straddle faces of the polyhedron of maps are cut along the boundaries by a kernel, and the
/// pieces drawn indirectly.
class ReflectorDrawer {
  public:
    /// @param reflectors with at least one polygon
    /// @param faces of the polyhedron; empty for sphere maps
    /// @param specialization of the fragment stage
    /// @param bindings of scene, kept light, maps and BINDING_FRAME
    /// @param most_cut_pieces see MapSettings, > 0
    /// @param tolerance of MapKind::hybrid
    ReflectorDrawer(Device& device, const SceneData& data, const Reflectors& reflectors, MapKind kind,
                    const std::vector<interop::MapFace>& faces, std::optional<std::uint32_t> most_cut_pieces,
                    Tolerance::Of tolerance, const Specialization& specialization, const Bindings& bindings);

    /// The pass over vertices and polygons: what a new eye costs.
    /// @param eye all but its range of vertices, which is found here
    /// @returns seconds on the device
    double set_eye(const interop::ReflectVerticesPush& eye);

    /// Records a draw of one triangle by each pipeline, so that drivers compile them.
    void warm_up(const vk::raii::CommandBuffer& commands) const;

    /// Records the draws, inside draw_into(), after the depth of what is not reflective.
    void draw(const vk::raii::CommandBuffer& commands, const interop::ViewPush& push) const;

    [[nodiscard]] std::uint32_t polygon_count() const { return clip_.polygons; }
    /// Buffers of the polygons and what their vertices reflect, added to others.
    [[nodiscard]] Bindings with_polygons(Bindings others) const;
    /// Constants of the stages that draw whole polygons as a kind of map would, added to others.
    [[nodiscard]] Specialization specialise(const Specialization& others, MapKind kind,
                                            std::size_t faces) const;

    /// What the last set_eye() made of the polygons, for tests and statistics.
    struct Pieces {
        std::vector<interop::Piece> whole;
        std::vector<interop::Piece> cut;
        std::vector<interop::PieceCorner> cut_corners;  ///< three to a piece
    };
    [[nodiscard]] Pieces pieces() const;

  private:
    /// A kernel that runs once to count and once more to write, and where its counts are summed in between.
    struct TwoRuns {
        Kernel count;
        Kernel write;
        BindingSet count_set;
        BindingSet sum_set;
        BindingSet write_set;
    };
    /// What cutting polygons takes.
    struct Clipping {
        Kernel prefix_sum;
        TwoRuns sort;
        TwoRuns cut;
        RasterPipeline draw_whole;
        RasterPipeline draw_cut;
        BindingSet draw_whole_set;
        BindingSet draw_cut_set;
    };

    /// Comes before whole polygons, so that a pixel looks up or traces only what it shows: backs of closed
    /// mirrors would be followed through every reflection inside them. Pieces of cut polygons do without.
    struct DepthPass {
        RasterPipeline pipeline;
        BindingSet bindings;
    };

    [[nodiscard]] DepthPass make_depth_pass(const Specialization& specialization,
                                            const std::vector<vk::Format>& formats,
                                            const Bindings& bindings) const;
    [[nodiscard]] TwoRuns make_two_runs(const std::string& name, std::span<const std::uint32_t> spirv,
                                        Specialization specialization, const Kernel& prefix_sum,
                                        const Buffer& counts, const Bindings& all) const;
    [[nodiscard]] Clipping make_clipping(const Specialization& specialization,
                                         const Bindings& bindings) const;
    void run_twice(const vk::raii::CommandBuffer& commands, const TwoRuns& runs) const;

    Device& device_;
    SurfaceFeatures features_;
    std::uint32_t vertex_count_;
    interop::ClipPush clip_{};
    Buffer vertices_;
    Buffer triangles_;
    Buffer vertex_reflections_;
    Buffer straddling_;
    Buffer drawn_polygons_;
    Buffer cut_counts_;
    Buffer whole_pieces_;
    Buffer cut_pieces_;
    Buffer cut_corners_;
    Buffer draw_arguments_;
    Kernel vertex_kernel_;
    BindingSet vertex_set_;
    std::optional<DepthPass> depth_;
    RasterPipeline whole_;
    BindingSet whole_set_;
    std::optional<Clipping> clipping_;
};

}  // namespace utsuri
