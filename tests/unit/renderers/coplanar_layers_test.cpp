// SPDX-License-Identifier: Apache-2.0
// Which of surfaces in one plane lies on top.
#include "renderers/device_scene/coplanar_layers.h"

#include "renderers/device_scene/scene_triangles.h"
#include "support/light_scenes.h"

#include <gtest/gtest.h>

#include <set>

namespace utsuri::test {
namespace {

/// A sheet of edge 2 * half about a point of a plane that is parallel to no axis.
Mesh sheet(float half, glm::vec2 middle = {0, 0}, float height = 0.0f) {
    const glm::vec3 u = {0.8f, 0.0f, 0.6f};
    const glm::vec3 v = {-0.36f, 0.8f, 0.48f};
    const glm::vec3 n = {-0.48f, -0.6f, 0.64f};
    const glm::vec3 corner = (middle.x - half) * u + (middle.y - half) * v + height * n;
    return quad(corner, 2.0f * half * u, 2.0f * half * v);
}

Scene scene_of(const std::vector<Mesh>& meshes) {
    Scene scene;
    for (const Mesh& mesh : meshes)
        add(scene, mesh, lambert(glm::vec3(0.5f)));
    return scene;
}

/// The layers on triangles of each instance.
std::vector<std::set<std::uint32_t>> layers_of(const Scene& scene) {
    const SceneData data = prepare_scene_data(scene);
    std::vector<std::set<std::uint32_t>> layers(scene.instances.size());
    for (const interop::TriangleInfo& info : data.triangle_infos)
        layers[info.instance].insert(info.layers);
    return layers;
}

using Layers = std::vector<std::set<std::uint32_t>>;

TEST(CoplanarLayers, TheSmallerLiesOnTopWhateverTheOrder) {
    EXPECT_EQ(layers_of(scene_of({sheet(2.0f), sheet(0.5f, {1.2f, -0.6f})})), (Layers{{0, 1}, {0}}));
    EXPECT_EQ(layers_of(scene_of({sheet(0.5f, {1.2f, -0.6f}), sheet(2.0f)})), (Layers{{0}, {0, 1}}));
    EXPECT_EQ(layers_of(scene_of({sheet(0.5f), flipped(sheet(2.0f))})), (Layers{{0}, {1}}));
}

TEST(CoplanarLayers, OfEqualOnesTheLater) {
    EXPECT_EQ(layers_of(scene_of({sheet(1.0f), sheet(1.0f)})), (Layers{{1}, {0}}));
}

TEST(CoplanarLayers, OneOnTopOfTheOther) {
    EXPECT_EQ(layers_of(scene_of({sheet(0.1f), sheet(2.0f), sheet(0.5f)})), (Layers{{0}, {2}, {1}}));
    // Two beside each other on one are one layer.
    EXPECT_EQ(layers_of(scene_of({sheet(0.1f, {0.5f, 0.5f}), sheet(2.0f), sheet(0.1f, {-0.5f, -0.5f})})),
              (Layers{{0}, {1}, {0}}));
}

TEST(CoplanarLayers, NeighboursDoNotOverlap) {
    EXPECT_EQ(layers_of(scene_of({sheet(1.0f), sheet(1.0f, {2.0f, 0.0f}), sheet(0.5f, {1.5f, 1.5f})})),
              (Layers{{0}, {0}, {0}}));
    EXPECT_EQ(layers_of(scene_of({icosphere({1, 2, 3}, 1.0f, 3), room({-3, -3, -3}, {5, 5, 5})})),
              (Layers{{0}, {0}}));
    EXPECT_EQ(prepare_scene_data(scene_of({sheet(1.0f)})).layer_distance, 0.0f);
}

// Coordinates are of a few metres: what is a tenth of a millimetre apart is no matter of rounding.
TEST(CoplanarLayers, WhatIsOffThePlaneDoesNotCount) {
    EXPECT_EQ(layers_of(scene_of({sheet(2.0f), sheet(0.5f, {0, 0}, 1e-4f)})), (Layers{{0}, {0}}));
    EXPECT_EQ(layers_of(scene_of({sheet(2.0f), sheet(0.5f, {0, 0}, -1e-4f)})), (Layers{{0}, {0}}));
}

TEST(CoplanarLayers, ABoxStandsOnItsFloor) {
    const Layers layers = layers_of(scene_of({ground(2.0f), block({-0.5f, 0, -0.5f}, {0.3f, 1, 0.7f})}));
    EXPECT_EQ(layers, (Layers{{1}, {0}}));
}

TEST(CoplanarLayers, ScaleDoesNotMatter) {
    const Scene scene = scene_of({sheet(0.1f), sheet(2.0f), sheet(0.5f)});
    const Layers layers = layers_of(scene);
    for (const double factor : {0x1p-40, 0x1p40}) {
        EXPECT_EQ(layers_of(scaled(scene, factor)), layers);
        EXPECT_EQ(static_cast<double>(prepare_scene_data(scaled(scene, factor)).layer_distance),
                  factor * static_cast<double>(prepare_scene_data(scene).layer_distance));
    }
}

}  // namespace
}  // namespace utsuri::test
