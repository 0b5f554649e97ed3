// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/reflection/planar/plane_mirrors.h"
#include "renderers/reflection/raster/draw_list.h"
#include "renderers/reflection/reflectors/reflectors.h"

#include <cstdint>
#include <vector>

namespace utsuri {

/// Triangles that follow each other in a draw list.
struct TriangleRange {
    std::uint32_t first = 0;
    std::uint32_t count = 0;

    [[nodiscard]] std::uint32_t end() const { return first + count; }
};

/// All triangles of a scene in the order in which views draw them: what is no mirror, curved mirrors, then
/// plane mirrors one after the other.
struct MirroredViewTriangles {
    std::vector<std::uint32_t> listed;
    std::vector<std::uint32_t> reflectors;  ///< whose maps each listed one looks up, or NONE
    std::vector<DrawBatch> batches;         ///< of what is no mirror
    TriangleRange curved;
    std::vector<TriangleRange> mirrors;
    SurfaceFeatures curved_features;  ///< what any of them needs
    SurfaceFeatures mirror_features;
};

/// @param curved reflectors with maps: the instances of all triangles in no plane
MirroredViewTriangles list_mirrored_view_triangles(const SceneData& scene, const PlaneMirrors& mirrors,
                                                   const Reflectors& curved);

}  // namespace utsuri
