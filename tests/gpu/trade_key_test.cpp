// SPDX-License-Identifier: Apache-2.0
// What a kept trade is valid for: nothing that changes pictures or times may leave its key as it was.
#include "compare/trade/trade_cache.h"
#include "support/scenes.h"
#include "support/test_device.h"

#include <nlohmann/json.hpp>

namespace utsuri::test {
namespace {

class TradeKey : public DeviceTest {
  protected:
    static Scene small_scene() {
        Scene scene;
        add(scene, quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), lambert(glm::vec3(0.5f)));
        Light light;
        light.position = glm::dvec3(0, 0, 2);
        light.intensity = glm::vec3(4.0f);
        scene.lights = {light};
        return scene;
    }
    static ComparisonSettings settings() {
        ComparisonSettings settings;
        settings.methods = all_methods(light_methods().front());
        return settings;
    }
    static Camera camera() { return look_at({0, 0, 3}, {0, 0, 0}); }

    static std::string key(const Scene& scene, const Camera& eye, const ComparisonSettings& settings,
                           const std::vector<std::string>& options = {}) {
        Session session;
        session.set_scene(scene);
        return trade_key(session, eye, settings, options).dump();
    }
};

TEST_F(TradeKey, SameForTheSame) {
    EXPECT_EQ(key(small_scene(), camera(), settings()), key(small_scene(), camera(), settings()));
}

TEST_F(TradeKey, FollowsTheScene) {
    const std::string before = key(small_scene(), camera(), settings());
    Scene scene = small_scene();
    scene.meshes[0].positions[2].z = 0.125f;
    EXPECT_NE(key(scene, camera(), settings()), before);
    scene = small_scene();
    scene.materials[0].base_colour.x += 0.125f;
    EXPECT_NE(key(scene, camera(), settings()), before);
    scene = small_scene();
    scene.lights[0].intensity *= 2.0f;
    EXPECT_NE(key(scene, camera(), settings()), before);
    scene = small_scene();
    scene.environment = glm::vec3(1.0f);
    EXPECT_NE(key(scene, camera(), settings()), before);
}

TEST_F(TradeKey, FollowsCameraPictureOptionsAndSweep) {
    const std::string before = key(small_scene(), camera(), settings());
    EXPECT_NE(key(small_scene(), look_at({0, 0.5, 3}, {0, 0, 0}), settings()), before);
    EXPECT_NE(key(small_scene(), look_at({0, 0, 3}, {0, 0, 0}, 0.5), settings()), before);
    EXPECT_NE(key(small_scene(), camera(), settings(), {"--seed", "5"}), before);
    ComparisonSettings other = settings();
    other.render.width = 100;
    EXPECT_NE(key(small_scene(), camera(), other), before);
    other = settings();
    other.samples = 32;
    EXPECT_NE(key(small_scene(), camera(), other), before);
    other = settings();
    other.reference_samples = 64;
    EXPECT_NE(key(small_scene(), camera(), other), before);
    other = settings();
    other.reference_seconds = 64.0;
    EXPECT_NE(key(small_scene(), camera(), other), before);
    other = settings();
    other.maps.size = 64;
    EXPECT_NE(key(small_scene(), camera(), other), before);
    other = settings();
    other.methods.pop_back();
    EXPECT_NE(key(small_scene(), camera(), other), before);
    other = settings();
    other.maps.polyhedron = platonic_solid("octahedron");
    EXPECT_NE(key(small_scene(), camera(), other), before);
    other = settings();
    other.maps.proxy =
        GivenProxy{"room.txt", {{{1, 0, 0}, 2}, {{-1, -1, -1}, 2}, {{0, 1, 0}, 2}, {{0, 0, 1}, 2}}};
    const std::string with_proxy = key(small_scene(), camera(), other);
    EXPECT_NE(with_proxy, before);
    other.maps.proxy->planes[1].offset = 3;
    EXPECT_NE(key(small_scene(), camera(), other), with_proxy);
}

}  // namespace
}  // namespace utsuri::test
