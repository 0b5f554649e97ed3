// SPDX-License-Identifier: Apache-2.0
// Light on surfaces of a scene in which something moved: simulated anew only where its shadow was or is,
// and the light that a scene would have which was always so.
#include "renderers/light/direct/light_cache.h"
#include "support/light_scenes.h"
#include "support/methods.h"
#include "support/test_device.h"

#include <glm/ext/matrix_transform.hpp>

#include <array>
#include <cmath>
#include <random>
#include <set>

namespace utsuri::test {
namespace {

constexpr std::uint32_t kSeed = 3;
/// Coarse, and finer where light changes: points come and go with it.
constexpr LightSettings kCoarse = [] {
    LightSettings settings = evenly_kept(1.0 / 20.0, 8, kSeed);
    settings.refinement = 4.0;
    return settings;
}();

Light lamp(LightType type, const glm::dvec3& position, const glm::dvec3& direction) {
    Light light;
    light.type = type;
    light.position = position;
    light.direction = glm::normalize(direction);
    light.intensity = {3.0f, 2.0f, 1.0f};
    return light;
}

/// A room without a ceiling; what moves in it is instance 1.
constexpr std::uint32_t kBlock = 1;
Scene unlit_scene() {
    Scene scene;
    add(scene, quad({-2, 0, -2}, {0, 0, 4}, {4, 0, 0}), lambert(glm::vec3(0.5f)));
    add(scene, block({-0.25f, 0.5f, -0.25f}, {0.25f, 0.75f, 0.25f}), lambert(glm::vec3(0.5f)));
    add(scene, quad({-2, 0, -2}, {4, 0, 0}, {0, 2, 0}), lambert(glm::vec3(0.5f)));
    return scene;
}

/// Kinds of light, and how much of all light a small thing's shadow can be: on its points, and where it was
/// and is cast.
struct Lit {
    const char* name;
    void (*add_lights)(Scene& scene);
    double most_rays;
};

const Lit kLit[] = {
    {"a point light",
     [](Scene& scene) {
         scene.lights.push_back(lamp(LightType::point, {0.5, 1.75, 0.25}, {0, -1, 0}));
     },
     0.5},
    {"a spot",
     [](Scene& scene) {
         scene.lights.push_back(lamp(LightType::spot, {0, 1.75, 0}, {0, -1, 0}));
     },
     0.5},
    {"a sun",
     [](Scene& scene) {
         scene.lights.push_back(lamp(LightType::directional, {}, {0.25, -1, 0.125}));
     },
     0.4},
    {"a panel",
     [](Scene& scene) {
         add(scene, ceiling({0.25f, 1.75f, 0}, 0.25f), emitter(glm::vec3(1.0f)));
     },
     0.6},
    {"forty lamps in a row",
     [](Scene& scene) {
         for (int i = 0; i < 40; ++i)
             scene.lights.push_back(lamp(LightType::point, {-1.5, 1.75, -1.5 + 0.02 * i}, {0, -1, 0}));
     },
     0.6},
    {"forty suns",
     [](Scene& scene) {
         for (int i = 0; i < 40; ++i)
             scene.lights.push_back(lamp(LightType::directional, {}, {0.25, -1, 0.01 * i}));
     },
     0.6},
    {"a ball that shines",
     [](Scene& scene) {
         add(scene, icosphere({1.5f, 1.5f, 1.5f}, 0.125f, 2), emitter(glm::vec3(1.0f)));
     },
     0.6},
    {"surroundings", [](Scene& scene) { scene.environment = glm::vec3(1.0f); }, 1.0},
    {"a sun, a lamp and a panel",
     [](Scene& scene) {
         scene.lights.push_back(lamp(LightType::directional, {}, {0.25, -1, 0.125}));
         scene.lights.push_back(lamp(LightType::point, {1.5, 0.5, 1.5}, {0, -1, 0}));
         add(scene, ceiling({0.25f, 1.75f, 0}, 0.25f), emitter(glm::vec3(1.0f)));
     },
     0.9},
};

Scene with_block_moved(Scene scene, const glm::dmat4& by) {
    glm::dmat4& place = scene.instances[kBlock].world_from_object;
    place = by * place;
    return scene;
}

class ChangedLight : public DeviceTest {
  protected:
    void prepare(const Scene& scene) {
        light_.reset();
        data_ = prepare_scene_data(scene);
        gpu_scene_ = std::make_unique<GpuScene>(device(), data_);
        light_ = std::make_unique<LightCache>(device(), data_, *gpu_scene_, kCoarse);
        light_->fill(silent_);
    }

    SceneChange change(const Scene& scene) {
        SceneChange change = update_scene_data(data_, scene);
        gpu_scene_->update(data_);
        return change;
    }

    /// @returns rays that taking over the scene as it is now took
    std::uint64_t follow(const Scene& scene) {
        const SceneChange changed = change(scene);
        EXPECT_FALSE(changed.lights);
        light_->update(changed, silent_);
        return light_->cost().counts.rays;
    }

    /// Light of the scene as it is, with nothing kept from before.
    std::unique_ptr<LightCache> anew() {
        auto light = std::make_unique<LightCache>(device(), data_, *gpu_scene_, kCoarse);
        light->fill(silent_);
        return light;
    }

    /// How a triangle is split and what is kept on it, in the order of its tree.
    static void describe(const LightMesh& mesh, std::uint32_t node, std::vector<float>& description) {
        const MeshNode& n = mesh.nodes[node];
        description.push_back(static_cast<float>(n.split));
        if (n.split != kMeshLeaf) {
            description.push_back(n.share);
            describe(mesh, n.child, description);
            describe(mesh, n.child + 1, description);
            return;
        }
        for (const std::uint32_t p : n.points) {
            if (p == interop::NONE) continue;
            for (const glm::vec3& side : {mesh.points[p].front, mesh.points[p].back})
                description.insert(description.end(), {side.x, side.y, side.z});
        }
    }
    static void add_points(const LightMesh& mesh, std::uint32_t node, std::set<std::uint32_t>& points) {
        const MeshNode& n = mesh.nodes[node];
        if (n.split == kMeshLeaf) {
            points.insert(n.points.begin(), n.points.end());
        } else {
            add_points(mesh, n.child, points);
            add_points(mesh, n.child + 1, points);
        }
    }
    static std::vector<float> described(const LightMesh& mesh, std::uint32_t triangle) {
        std::vector<float> description;
        describe(mesh, triangle, description);
        return description;
    }

    /// Triangles with other points, or with other light at them, ascending.
    [[nodiscard]] std::vector<std::uint32_t> differing(const LightMesh& a, const LightMesh& b) const {
        std::vector<std::uint32_t> differing;
        for (std::uint32_t t = 0; t < data_.triangle_infos.size(); ++t) {
            if (described(a, t) != described(b, t)) differing.push_back(t);
        }
        return differing;
    }
    [[nodiscard]] std::size_t differing(const LightCache& a, const LightCache& b) const {
        EXPECT_EQ(a.mesh().points.size(), b.mesh().points.size());
        return differing(a.mesh(), b.mesh()).size();
    }

    Progress silent_;
    SceneData data_;
    std::unique_ptr<GpuScene> gpu_scene_;
    std::unique_ptr<LightCache> light_;
};

TEST_F(ChangedLight, IsThatOfASceneWhichWasAlwaysSo) {
    for (const Lit& lit : kLit) {
        SCOPED_TRACE(lit.name);
        Scene scene = unlit_scene();
        lit.add_lights(scene);
        prepare(scene);
        std::mt19937 random(7);
        std::uniform_real_distribution<double> place(-1.0, 1.0);
        std::uint64_t rays = 0;
        std::uint64_t rays_anew = 0;
        for (int step = 0; step < 8; ++step) {
            const glm::dvec3 by(place(random), 0.5 * place(random), place(random));
            const glm::dmat4 turned = glm::rotate(glm::dmat4(1.0), place(random), glm::dvec3(0, 1, 0));
            rays += follow(with_block_moved(scene, glm::translate(glm::dmat4(1.0), by) * turned));
            const std::unique_ptr<LightCache> as_it_is = anew();
            rays_anew += as_it_is->cost().counts.rays;
            EXPECT_EQ(differing(*light_, *as_it_is), 0u) << "step " << step;
            EXPECT_FALSE(light_->changed().empty()) << "step " << step;
        }
        EXPECT_LE(static_cast<double>(rays), lit.most_rays * static_cast<double>(rays_anew));
    }
}

// Each update compares with what the one before it read; points stay, or are others on some triangles.
TEST_F(ChangedLight, IsToldByTheTrianglesThatSendItOut) {
    Scene scene = unlit_scene();
    scene.lights.push_back(lamp(LightType::point, {0.5, 1.75, 0.25}, {0, -1, 0}));
    prepare(scene);
    const glm::dmat4 here(1.0);
    const std::array places = {
        glm::translate(here, glm::dvec3(0.25, 0, 0.25)), glm::translate(here, glm::dvec3(-0.5, 0.25, 0)),
        glm::scale(here, glm::dvec3(2.0)), glm::rotate(here, 0.5, glm::dvec3(0, 1, 0)), here};
    for (std::size_t i = 0; i < places.size(); ++i) {
        const LightMesh before = light_->mesh();
        follow(with_block_moved(scene, places[i]));
        EXPECT_FALSE(light_->changed().empty()) << "step " << i;
        EXPECT_EQ(light_->changed(), differing(before, light_->mesh())) << "step " << i;
    }
}

TEST_F(ChangedLight, IsAllOfItAfterAnUpdateThatWasInterrupted) {
    struct Cancelled : Progress {
        [[nodiscard]] bool cancelled() const override { return true; }
    } cancelled;
    Scene scene = unlit_scene();
    scene.lights.push_back(lamp(LightType::point, {0.5, 1.75, 0.25}, {0, -1, 0}));
    prepare(scene);
    const Scene moved = with_block_moved(scene, glm::translate(glm::dmat4(1.0), glm::dvec3(0.25, 0, 0.25)));
    follow(moved);
    const SceneChange back = change(scene);
    EXPECT_THROW(light_->update(back, cancelled), Interrupted);
    light_->fill(silent_);
    EXPECT_EQ(light_->changed().size(), data_.triangle_infos.size());
    EXPECT_EQ(differing(*light_, *anew()), 0u);
    const LightMesh before = light_->mesh();
    follow(moved);
    EXPECT_EQ(light_->changed(), differing(before, light_->mesh()));
    EXPECT_EQ(differing(*light_, *anew()), 0u);
}

// On triangles thinner than rounding allows for, light is simulated a good way off the point it is kept at;
// more things than boxes move.
TEST_F(ChangedLight, OnThinStripsUnderManyThingsIsThatOfASceneWhichWasAlwaysSo) {
    Scene scene;
    for (int i = 0; i < 12; ++i)
        add(scene, block({-0.1f, 0.5f, -0.1f}, {0.1f, 0.6f, 0.1f}), lambert(glm::vec3(0.5f)));
    for (int i = 0; i < 6; ++i) {
        const float z = -0.5f + 0.2f * static_cast<float>(i);
        add(scene, quad({-5, 0, z}, {0, 0, 0.0005f * std::exp2(static_cast<float>(2 * i))}, {10, 0, 0}),
            lambert(glm::vec3(0.5f)));
    }
    scene.lights.push_back(lamp(LightType::point, {0.5, 1.75, 0.25}, {0, -1, 0}));
    prepare(scene);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-1.0, 1.0);
    for (int step = 0; step < 6; ++step) {
        Scene moved = scene;
        for (std::size_t i = 0; i < 12; ++i) {
            moved.instances[i].world_from_object = glm::translate(
                glm::dmat4(1.0), glm::dvec3(4.0 * place(random), 0.25 * place(random), place(random)));
        }
        follow(moved);
        EXPECT_EQ(differing(*light_, *anew()), 0u) << "step " << step;
    }
}

// Behind the lamp nothing can cast a shadow: only the thing itself is lit anew, 12 triangles of it.
TEST_F(ChangedLight, IsSimulatedOnlyOnAThingThatCastsNoShadow) {
    Scene scene = unlit_scene();
    scene.lights.push_back(lamp(LightType::point, {0, 0.25, 0}, {0, -1, 0}));
    prepare(with_block_moved(scene, glm::translate(glm::dmat4(1.0), glm::dvec3(0.5, 1.0, 1.5))));
    const std::uint64_t rays =
        follow(with_block_moved(scene, glm::translate(glm::dmat4(1.0), glm::dvec3(0.75, 1.0, 1.25))));
    std::set<std::uint32_t> points;
    for (std::uint32_t t = 0; t < data_.triangle_infos.size(); ++t) {
        if (data_.triangle_infos[t].instance == kBlock) add_points(light_->mesh(), t, points);
    }
    EXPECT_GT(rays, 0u);
    // A side of each point sees the lamp, and as many points tell that there are enough of them.
    EXPECT_LE(rays, 2 * points.size() * kCoarse.samples);
    EXPECT_EQ(differing(*light_, *anew()), 0u);
}

// A thing that leaves its scene's bounds makes all points wider apart, but for a few at corners.
TEST_F(ChangedLight, IsSimulatedAnewWherePointsAreOthers) {
    Scene scene = unlit_scene();
    scene.lights.push_back(lamp(LightType::point, {0.5, 1.75, 0.25}, {0, -1, 0}));
    prepare(scene);
    follow(with_block_moved(scene, glm::translate(glm::dmat4(1.0), glm::dvec3(0, 6, 0))));
    const std::unique_ptr<LightCache> as_it_is = anew();
    EXPECT_LE(light_->cost().counts.rays, as_it_is->cost().counts.rays);
    EXPECT_EQ(differing(*light_, *as_it_is), 0u);
}

// What two changes moved is not known from the second alone.
TEST_F(ChangedLight, IsSimulatedAnewAfterAChangeThatWasNotFollowed) {
    Scene scene = unlit_scene();
    scene.lights.push_back(lamp(LightType::point, {0.5, 1.75, 0.25}, {0, -1, 0}));
    prepare(scene);
    change(with_block_moved(scene, glm::translate(glm::dmat4(1.0), glm::dvec3(1, 0, 0))));
    follow(with_block_moved(scene, glm::translate(glm::dmat4(1.0), glm::dvec3(1, 0, 0.25))));
    EXPECT_EQ(differing(*light_, *anew()), 0u);
}

}  // namespace
}  // namespace utsuri::test
