// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/planar/mirrored_view_triangles.h"

namespace utsuri {

MirroredViewTriangles list_mirrored_view_triangles(const SceneData& scene, const PlaneMirrors& mirrors,
                                                   const Reflectors& curved) {
    DrawList matte = plan_draws(scene);
    MirroredViewTriangles result;
    result.listed = std::move(matte.triangles);
    result.batches = std::move(matte.batches);
    const auto append = [&](const std::vector<std::uint32_t>& triangles, SurfaceFeatures& needed) {
        const TriangleRange range{static_cast<std::uint32_t>(result.listed.size()),
                                  static_cast<std::uint32_t>(triangles.size())};
        for (const std::uint32_t triangle : triangles)
            needed = needed | scene.requirements.surfaces[scene.triangle_infos[triangle].material];
        result.listed.insert(result.listed.end(), triangles.begin(), triangles.end());
        return range;
    };
    result.curved = append(mirrors.others, result.curved_features);
    for (const PlaneMirror& mirror : mirrors.mirrors)
        result.mirrors.push_back(append(mirror.triangles, result.mirror_features));
    for (const std::uint32_t triangle : result.listed)
        result.reflectors.push_back(curved.instance_reflectors[scene.triangle_infos[triangle].instance]);
    return result;
}

}  // namespace utsuri
