// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/raster/draw_list.h"

#include <map>

namespace utsuri {

DrawList plan_draws(const SceneData& scene, MapKind kind) {
    std::map<SurfaceFeatures, std::vector<std::uint32_t>> groups;
    for (std::uint32_t t = 0; t < scene.triangle_infos.size(); ++t) {
        SurfaceFeatures features = scene.requirements.surfaces[scene.triangle_infos[t].material];
        features.textured = features.textured || traces_lobes(kind, features);
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

bool traces_lobes(MapKind kind, const SurfaceFeatures& features) {
    return kind == MapKind::hybrid && features.glossy;
}

Specialization drawing_constants(const Specialization& scene, const SurfaceFeatures& features, bool traces) {
    return traces ? scene : with_features(scene, features);
}

}  // namespace utsuri
