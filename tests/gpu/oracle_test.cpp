// SPDX-License-Identifier: Apache-2.0
#include "support/scenes.h"
#include "support/test_device.h"
#include "support/triangle_soup.h"

#include "gpu/oracle_comparison.h"

namespace utsuri {
namespace {

using EmbreeComparison = DeviceTest;

Scene scene_of(Mesh mesh) {
    Scene scene;
    test::add(scene, std::move(mesh), test::lambert(glm::vec3(0.5f)));
    return scene;
}

TEST_F(EmbreeComparison, RandomTriangles) {
    test::compare_with_embree(device(), scene_of(test::to_mesh(test::random_soup(200000, 0.02f))));
}

TEST_F(EmbreeComparison, NestedSphereAndGrids) {
    Scene scene = scene_of(test::icosphere({0.1f, 0.2f, 0.3f}, 0.9f, 4));
    for (const int axis : {0, 1, 2})
        test::add(scene, test::to_mesh(test::flat_grid(8, axis)), test::mirror());
    test::compare_with_embree(device(), scene);
}

}  // namespace
}  // namespace utsuri
