// SPDX-License-Identifier: Apache-2.0
// The smallest and the largest maps.
#include "support/estimate.h"
#include "support/methods.h"
#include "support/test_device.h"

#include "base/error.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace utsuri::test {
namespace {

constexpr float kRadiance = 3.0f;
constexpr std::uint32_t kLargest = 4096;

/// A mirror ball in a uniform environment, which it shows whatever the maps are like.
Scene furnace() {
    Scene scene;
    scene.environment = glm::vec3(kRadiance);
    add(scene, icosphere(glm::vec3(0.0f), 1.0f, 2), mirror());
    return scene;
}

class MapSizes : public DeviceTest {
  protected:
    static MapSettings settings(std::uint32_t size) {
        MapSettings settings{size, 1, {}};
        settings.shares_room = false;
        return settings;
    }

    /// Pixels that show the ball lie within [least, kRadiance], as all others do.
    static void expect_uniform(MapKind kind, std::uint32_t size, float least = kRadiance) {
        const Camera camera = look_at(glm::dvec3(0, 0.5, 3), glm::dvec3(0));
        const Traced result =
            render_with_maps(device(), furnace(), camera, {24, 16, 0, 4}, kind, settings(size), 1);
        EXPECT_EQ(result.statistics.counts.nonfinite + result.statistics.prepare_counts.nonfinite, 0u);
        const float tolerance = kRadiance * static_cast<float>(kRounding);
        for (const glm::vec3& pixel : result.image.pixels) {
            for (int c = 0; c < 3; ++c) {
                ASSERT_GE(pixel[c], least - tolerance) << "kind of map " << static_cast<int>(kind);
                ASSERT_LE(pixel[c], kRadiance + tolerance) << "kind of map " << static_cast<int>(kind);
            }
        }
    }

    /// What is wrong with maps of this size, or nothing if the device can hold them.
    static std::optional<std::string> refusal(const SceneData& data, MapKind kind, std::uint32_t size) {
        try {
            std::vector<interop::ProxyPlane> planes;
            const ReflectionMaps maps(device(), data, kind, settings(size), MapView(), planes);
            return std::nullopt;
        } catch (const UsageError& error) {
            return error.what();
        }
    }
};

// The only texel of a sphere map reaches beyond its circle, where there is nothing.
TEST_F(MapSizes, OneTexelShowsUniformSurroundings) {
    for (const MapKind kind : kMapKinds)
        expect_uniform(kind, 1, kind == MapKind::sphere ? 0.0f : kRadiance);
}

// Where 4096 texels do not fit into a buffer of the device, the error tells the largest size that does; one
// more is too many.
TEST_F(MapSizes, LargestThatFitsIsTold) {
    const SceneData data = prepare_scene_data(furnace());
    for (const MapKind kind : kMapKinds) {
        const std::optional<std::string> problem = refusal(data, kind, kLargest);
        if (!problem) continue;
        const std::string words = "--map-size may be at most ";
        const std::size_t at = problem->find(words);
        ASSERT_NE(at, std::string::npos) << *problem;
        const auto most = static_cast<std::uint32_t>(std::stoul(problem->substr(at + words.size())));
        EXPECT_EQ(refusal(data, kind, most), std::nullopt) << most;
        EXPECT_THAT(refusal(data, kind, most + 1).value_or("fits"), testing::HasSubstr(words)) << most + 1;
    }
}

// A map and its border, [size + 2]^2 texels of 12 bytes, in one buffer of the device.
TEST_F(MapSizes, LargestThatFitsIsRendered) {
    const std::uint64_t texels = device().summary().storage_range_bytes / 12 / interop::CUBE_FACES;
    const auto edge = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(texels)));
    expect_uniform(MapKind::cube, std::min(kLargest, edge - 2));
}

// At a size of which no buffer of this device holds a hundred, smaller ones are made, and the picture is what
// it is by rays: uniform. Who asks for just that size is refused, but by `hybrid`, which traces what is too
// coarse.
TEST_F(MapSizes, OfManyReflectorsShareTheRoom) {
    Scene scene;
    scene.environment = glm::vec3(kRadiance);
    for (int i = 0; i < 100; ++i)
        add(scene, icosphere(glm::vec3(i % 10, 0, i / 10), 0.4f, 1), mirror());
    const SceneData data = prepare_scene_data(scene);
    const Camera camera = look_at(glm::dvec3(4.5, 6, 16), glm::dvec3(4.5, 0, 4.5));
    for (const MapKind kind : kMapKinds) {
        SCOPED_TRACE(static_cast<int>(kind));
        const std::uint64_t maps = kind == MapKind::sphere ? 1 : interop::CUBE_FACES;
        const std::uint64_t map_bytes = device().summary().storage_range_bytes / 100 / maps;
        MapSettings sharing{
            static_cast<std::uint32_t>(std::sqrt(static_cast<double>(map_bytes) / 12.0)), 1, {}};
        if (sharing.size > kLargest) continue;  // the device holds a hundred maps of any size
        EXPECT_EQ(refusal(data, kind, sharing.size) == std::nullopt, kind == MapKind::hybrid);
        const Traced result = render_with_maps(device(), scene, camera, {24, 16, 0, 4}, kind, sharing, 1);
        EXPECT_LT(result.statistics.least_map_size, sharing.size);
        EXPECT_GE(result.statistics.least_map_size, 1u);
        EXPECT_LE(result.statistics.largest_map_size, sharing.size);
        // A sphere map of few texels shows what lies beyond its rim.
        const double radiance{kRadiance};
        const double dimmest = kind == MapKind::sphere ? 0.0 : radiance * (1.0 - 8.0 * kRounding);
        for (const glm::vec3& pixel : result.image.pixels) {
            for (int c = 0; c < 3; ++c) {
                ASSERT_GE(static_cast<double>(pixel[c]), dimmest);
                ASSERT_LE(static_cast<double>(pixel[c]), radiance * (1.0 + 8.0 * kRounding));
            }
        }
    }
}

}  // namespace
}  // namespace utsuri::test
