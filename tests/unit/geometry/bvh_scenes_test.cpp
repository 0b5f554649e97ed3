// SPDX-License-Identifier: Apache-2.0
#include "import/conversion/gltf.h"

#include "geometry/bvh.h"
#include "geometry/bvh_check.h"
#include "scene/world_geometry.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace utsuri {
namespace {

namespace fs = std::filesystem;

TEST(BvhOfScenes, PassesTheChecker) {
    int scenes = 0;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(UTSURI_SOURCE_DIR) / "scenes")) {
        if (entry.path().extension() != ".glb") continue;
        SCOPED_TRACE(entry.path().filename().string());
        const WorldGeometry world = make_world_geometry(import_gltf(entry.path()).scene);
        const Bvh bvh = build_bvh(world.positions, world.triangles);
        EXPECT_EQ(check_bvh(bvh, world.triangles.size()), "");
        EXPECT_LE(bvh.depth, interop::BVH_MAX_DEPTH);
        EXPECT_GT(world.triangles.size(), 0u);
        ++scenes;
    }
    EXPECT_GE(scenes, 3);
}

}  // namespace
}  // namespace utsuri
