// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/raster/draw_list.h"

#include <map>

namespace utsuri {

DrawList plan_draws(const SceneData& scene) {
    std::map<SurfaceFeatures, std::vector<std::uint32_t>> groups;
    for (std::uint32_t t = 0; t < scene.triangle_infos.size(); ++t) {
        const SurfaceFeatures features = scene.requirements.surfaces[scene.triangle_infos[t].material];
        if (!features.mirror) groups[features].push_back(t);
    }
    DrawList list;
    for (const auto& [features, triangles] : groups) {
        list.batches.push_back({features, static_cast<std::uint32_t>(list.triangles.size()),
                                static_cast<std::uint32_t>(triangles.size())});
        list.triangles.insert(list.triangles.end(), triangles.begin(), triangles.end());
    }
    return list;
}

}  // namespace utsuri
