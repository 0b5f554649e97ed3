// SPDX-License-Identifier: Apache-2.0
#include "scene/check_scene.h"

#include "support/scenes.h"

#include "base/error.h"

#include <glm/ext/matrix_transform.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace utsuri {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kMostFloat = std::numeric_limits<float>::max();

/// Two quads, one of them textured, a light of each type and a camera.
Scene valid_scene() {
    Scene scene;
    test::add(scene, test::quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), test::lambert(glm::vec3(0.5f)));
    test::add(scene, test::quad({0, 0, 4}, {1, 0, 0}, {0, 1, 0}), test::emitter(glm::vec3(3.0f)));
    scene.textures.push_back({"", 2, 3, std::vector<std::uint8_t>(24, 100)});
    scene.materials[0].base_colour_texture.texture = 0;
    for (const LightType type : {LightType::point, LightType::spot, LightType::directional}) {
        Light light;
        light.type = type;
        scene.lights.push_back(light);
    }
    scene.cameras.push_back(test::look_at({0, 1, 5}, {0, 0, 0}));
    scene.environment = glm::vec3(0.1f);
    return scene;
}

std::string error_of(const Scene& scene) {
    try {
        check_scene(scene);
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

/// What is wrong with valid_scene() after something was done to it.
template <typename Spoil>
std::string error_after(const Spoil& spoil) {
    Scene scene = valid_scene();
    spoil(scene);
    return error_of(scene);
}

TEST(CheckScene, PassesWhatIsValid) {
    EXPECT_THAT(error_of(valid_scene()), IsEmpty());
    EXPECT_THAT(error_of(Scene()), IsEmpty());
}

TEST(CheckScene, FindsIndicesOutOfRange) {
    EXPECT_EQ(error_after([](Scene& s) { s.instances[1].material = 2; }),
              "use scene instances[1].material: is 2; must be below the number of materials, 2");
    EXPECT_EQ(error_after([](Scene& s) { s.instances[0].mesh = 7; }),
              "use scene instances[0].mesh: is 7; must be below the number of meshes, 2");
    EXPECT_EQ(error_after([](Scene& s) { s.meshes.clear(); }),
              "use scene instances[0].mesh: is 0; must be below the number of meshes, 0");
    for (int corner = 0; corner < 3; ++corner) {
        EXPECT_THAT(error_after([&](Scene& s) { s.meshes[1].triangles[1][corner] = 4; }),
                    HasSubstr("meshes[1].triangles[1]: joins positions"));
    }
    EXPECT_EQ(
        error_after([](Scene& s) { s.materials[0].base_colour_texture.texture = 1; }),
        "use scene materials[0].base_colour_texture.texture: is 1; must be below the number of textures, "
        "1");
    EXPECT_THAT(error_after([](Scene& s) { s.materials[1].metallic_roughness_texture.texture = 5; }),
                HasSubstr("materials[1].metallic_roughness_texture"));
    EXPECT_THAT(error_after([](Scene& s) { s.materials[1].specular_colour_texture.texture = 5; }),
                HasSubstr("materials[1].specular_colour_texture"));
    EXPECT_THAT(error_after([](Scene& s) { s.materials[1].specular_colour.y = -1.0f; }),
                HasSubstr("materials[1].specular_colour: is"));
    EXPECT_THAT(error_after([](Scene& s) { s.materials[1].emissive_texture.texture = 5; }),
                HasSubstr("materials[1].emissive_texture"));
}

TEST(CheckScene, FindsArraysOfWrongLength) {
    EXPECT_EQ(error_after([](Scene& s) { s.meshes[1].normals.clear(); }),
              "use scene meshes[1].normals: has 0 entries; must have one for each position, 4");
    EXPECT_THAT(error_after([](Scene& s) { s.meshes[1].normals.emplace_back(0, 0, 1); }),
                HasSubstr("meshes[1].normals: has 5"));
    EXPECT_THAT(error_after([](Scene& s) { s.meshes[0].texcoords.pop_back(); }),
                HasSubstr("meshes[0].texcoords: has 3"));
    EXPECT_THAT(error_after([](Scene& s) { s.meshes[0].texcoords.clear(); }), IsEmpty());
}

TEST(CheckScene, FindsTexturesOfOtherSizesThanTheirTexels) {
    EXPECT_EQ(error_after([](Scene& s) { s.textures[0].rgba.pop_back(); }),
              "use scene textures[0].rgba: has 23 bytes; must have 4 for each of 2 x 3 texels");
    EXPECT_THAT(error_after([](Scene& s) { s.textures[0].rgba.resize(16); }), HasSubstr("has 16 bytes"));
    EXPECT_THAT(error_after([](Scene& s) { s.textures[0].width = 0; }), HasSubstr("textures[0].width"));
    EXPECT_THAT(error_after([](Scene& s) { s.textures[0].height = 0; }), HasSubstr("textures[0].height"));
    // Four times the product of the edges is 2^64.
    EXPECT_THAT(error_after([](Scene& s) {
                    s.textures[0] = {"", 1u << 31, 1u << 31, {}};
                }),
                HasSubstr("has 0 bytes"));
}

TEST(CheckScene, FindsVerticesThatAreNotFinite) {
    for (const float bad : {kNan, kInfinity, -kInfinity}) {
        EXPECT_THAT(error_after([&](Scene& s) { s.meshes[0].positions[2].y = bad; }),
                    HasSubstr("meshes[0].positions[2]: is not finite"));
        EXPECT_THAT(error_after([&](Scene& s) { s.meshes[0].normals[3].x = bad; }),
                    HasSubstr("meshes[0].normals[3]"));
        EXPECT_THAT(error_after([&](Scene& s) { s.meshes[0].texcoords[1].y = bad; }),
                    HasSubstr("meshes[0].texcoords[1]"));
    }
    EXPECT_THAT(error_after([](Scene& s) { s.meshes[0].normals[3] = glm::vec3(0.0f); }),
                HasSubstr("meshes[0].normals[3]: is zero"));
}

TEST(CheckScene, FindsTransformsThatLeaveTheRangeOfFloat) {
    const auto error_with = [](const glm::dmat4& transform) {
        return error_after([&](Scene& s) { s.instances[1].world_from_object = transform; });
    };
    glm::dmat4 transform(1.0);
    transform[1][2] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(error_with(transform), HasSubstr("instances[1].world_from_object: is not finite"));
    transform = glm::dmat4(1.0);
    transform[0][3] = 0.5;
    EXPECT_THAT(error_with(transform), HasSubstr("has 0.5 in the last row of column 0; must be 0"));
    // The farthest corner is 4 m away along z.
    const double most = static_cast<double>(kMostFloat);
    EXPECT_THAT(error_with(glm::scale(glm::dmat4(1.0), glm::dvec3(0.25 * most))), IsEmpty());
    EXPECT_THAT(error_with(glm::scale(glm::dmat4(1.0), glm::dvec3(0.26 * most))), HasSubstr("m away"));
    EXPECT_THAT(error_with(glm::translate(glm::dmat4(1.0), glm::dvec3(0, 2.0 * most, 0))),
                HasSubstr("must be within the range of float32"));
}

TEST(CheckScene, FindsMaterialsOutOfRange) {
    const auto error_with = [](float Material::*member, float value) {
        return error_after([&](Scene& s) { s.materials[1].*member = value; });
    };
    for (float Material::*const share : {&Material::metallic, &Material::roughness, &Material::specular}) {
        for (const float good : {0.0f, 0.5f, 1.0f})
            EXPECT_THAT(error_with(share, good), IsEmpty());
        for (const float bad : {-1e-6f, std::nextafter(1.0f, 2.0f), kNan})
            EXPECT_THAT(error_with(share, bad), HasSubstr("must be in [0, 1]"));
    }
    EXPECT_THAT(error_with(&Material::ior, 1.0f), IsEmpty());
    for (const float bad : {0.99f, 0.0f, kInfinity, kNan})
        EXPECT_THAT(error_with(&Material::ior, bad), HasSubstr("materials[1].ior"));
    for (int c = 0; c < 3; ++c) {
        EXPECT_EQ(error_after([&](Scene& s) { s.materials[0].base_colour[c] = 1.5f; }),
                  "use scene materials[0].base_colour: is 1.5; must be in [0, 1]");
        for (const float bad : {-1.0f, kNan}) {
            EXPECT_THAT(error_after([&](Scene& s) { s.materials[1].emissive[c] = bad; }),
                        HasSubstr("materials[1].emissive"));
        }
    }
}

TEST(CheckScene, FindsLightsOutOfRange) {
    const double infinite = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
        const std::string place = "lights[" + std::to_string(i) + "].";
        EXPECT_THAT(error_after([&](Scene& s) { s.lights[i].intensity.y = -1.0f; }),
                    HasSubstr(place + "intensity"));
        EXPECT_THAT(error_after([&](Scene& s) { s.lights[i].intensity.y = kNan; }),
                    HasSubstr(place + "intensity"));
        EXPECT_THAT(error_after([&](Scene& s) { s.lights[i].range = -1.0; }), HasSubstr(place + "range"));
        EXPECT_THAT(error_after([&](Scene& s) { s.lights[i].range = infinite; }), IsEmpty());
    }
    // 0 is a point light, 1 a spot, 2 directional: what a type does not use does not matter.
    const auto with_position = [&](std::size_t i) {
        return error_after([&](Scene& s) { s.lights[i].position.x = infinite; });
    };
    EXPECT_THAT(with_position(0), HasSubstr("lights[0].position"));
    EXPECT_THAT(with_position(1), HasSubstr("lights[1].position"));
    EXPECT_THAT(with_position(2), IsEmpty());
    const auto with_direction = [](std::size_t i) {
        return error_after([&](Scene& s) { s.lights[i].direction = {0, 0, -2}; });
    };
    EXPECT_THAT(with_direction(0), IsEmpty());
    EXPECT_EQ(with_direction(1), "use scene lights[1].direction: has length 2; must be a unit vector");
    EXPECT_THAT(with_direction(2), HasSubstr("lights[2].direction"));
    EXPECT_THAT(error_after([](Scene& s) {
                    s.lights[2].direction = {0.577, -0.577, 0.577};
                }),
                IsEmpty())
        << "three decimals are enough";
}

TEST(CheckScene, FindsConesOutOfRange) {
    const auto with_cone = [](double inner, double outer) {
        return error_after([&](Scene& s) {
            s.lights[1].inner_cone_angle = inner;
            s.lights[1].outer_cone_angle = outer;
        });
    };
    const double right = 0.5 * std::numbers::pi;
    EXPECT_THAT(with_cone(0.0, right), IsEmpty());
    // Rounded to float32 it is larger.
    EXPECT_THAT(with_cone(0.0, static_cast<double>(static_cast<float>(right))), IsEmpty());
    EXPECT_THAT(with_cone(0.0, 1.6), HasSubstr("lights[1].outer_cone_angle"));
    EXPECT_THAT(with_cone(0.0, 0.0), HasSubstr("lights[1].outer_cone_angle"));
    EXPECT_THAT(with_cone(0.51, 0.5), HasSubstr("lights[1].inner_cone_angle"));
    EXPECT_THAT(with_cone(-0.1, 0.5), HasSubstr("lights[1].inner_cone_angle"));
}

TEST(CheckScene, FindsSurroundingsThatAreNoLight) {
    EXPECT_EQ(error_after([](Scene& s) {
                  s.environment = {0.5f, -1.0f, 0.0f};
              }),
              "use scene environment: is (0.5, -1, 0) cd/m2; must be at least 0 each");
    EXPECT_THAT(error_after([](Scene& s) { s.environment.z = kNan; }), HasSubstr("environment"));
}

TEST(CheckScene, FindsCamerasOutOfRange) {
    const auto fault = [](const auto& spoil) {
        Scene scene = valid_scene();
        spoil(scene.cameras[0]);
        const auto found = find_fault(scene.cameras[0]);
        EXPECT_EQ(found.has_value(), !error_of(scene).empty());
        return found ? found->name : std::string();
    };
    EXPECT_EQ(fault([](Camera&) {}), "");
    EXPECT_EQ(fault([](Camera& c) { c.position.y = std::numeric_limits<double>::infinity(); }), "position");
    for (const double bad : {0.0, -1.0, std::numbers::pi, std::numeric_limits<double>::quiet_NaN()})
        EXPECT_EQ(fault([&](Camera& c) { c.vertical_fov = bad; }), "vertical_fov");
    EXPECT_EQ(fault([](Camera& c) { c.vertical_fov = 3.1415; }), "");
    EXPECT_EQ(fault([](Camera& c) { c.right *= 2.0; }), "right");
    EXPECT_EQ(fault([](Camera& c) { c.up = c.right; }), "up");
    EXPECT_EQ(fault([](Camera& c) { c.forward = glm::dvec3(0.0); }), "forward");
    EXPECT_EQ(fault([](Camera& c) { c.forward.x = std::numeric_limits<double>::quiet_NaN(); }), "forward");
    EXPECT_THAT(error_after([](Scene& s) { s.cameras[0].vertical_fov = 4.0; }),
                HasSubstr("cameras[0].vertical_fov: is 4; must be above 0 and below pi, in radians"));
}

// Numbers of vertices have 32 bits.
TEST(CheckScene, FindsMoreVerticesThanCanBeNumbered) {
    Scene scene;
    Mesh mesh;
    mesh.positions.assign(1u << 16, glm::vec3(0.0f));
    mesh.normals.assign(1u << 16, glm::vec3(0, 0, 1));
    test::add(scene, mesh, test::lambert(glm::vec3(0.5f)));
    scene.instances.resize((1u << 16) - 1, scene.instances[0]);
    EXPECT_THAT(error_of(scene), IsEmpty());
    scene.instances.push_back(scene.instances[0]);
    EXPECT_THAT(error_of(scene), HasSubstr("use scene instances: have 4294967296 vertices"));
}

// The renderers count what comes of it, or leave it out.
TEST(CheckScene, PassesWhatIsOddButCanBeRendered) {
    EXPECT_THAT(error_after([](Scene& s) { s.environment = glm::vec3(kInfinity); }), IsEmpty());
    EXPECT_THAT(error_after([](Scene& s) { s.lights[0].intensity = glm::vec3(kInfinity); }), IsEmpty());
    EXPECT_THAT(error_after([](Scene& s) { s.materials[1].emissive = glm::vec3(kInfinity); }), IsEmpty());
    EXPECT_THAT(error_after([](Scene& s) { s.meshes[0].triangles[0] = {2, 2, 2}; }), IsEmpty());
    EXPECT_THAT(error_after([](Scene& s) { s.meshes[0].triangles.clear(); }), IsEmpty());
    EXPECT_THAT(error_after([](Scene& s) { s.meshes.push_back(s.meshes[0]); }), IsEmpty());
    EXPECT_THAT(error_after([](Scene& s) { s.instances.clear(); }), IsEmpty());
    EXPECT_THAT(error_after([](Scene& s) { s.cameras.clear(); }), IsEmpty());
    EXPECT_THAT(error_after([](Scene& s) { s.lights.clear(); }), IsEmpty());
    for (const double scale : {0.0, -1.0, 0x1p-60, 0x1p60}) {
        EXPECT_THAT(error_after([&](Scene& s) {
                        s.instances[0].world_from_object = glm::scale(glm::dmat4(1.0), glm::dvec3(scale));
                    }),
                    IsEmpty());
    }
}

}  // namespace
}  // namespace utsuri
