// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/camera.h"
#include "scene/light.h"
#include "scene/material.h"
#include "scene/texture.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace utsuri {

/// Indexed triangles in object space. Counter-clockwise seen from the front.
struct Mesh {
    std::string name;
    std::vector<glm::vec3> positions;   ///< finite
    std::vector<glm::vec3> normals;     ///< unit, one per position
    std::vector<glm::vec2> texcoords;   ///< finite, one per position, or none at all
    std::vector<glm::uvec3> triangles;  ///< indices into positions, all in range
};

/// A mesh placed in the world with one material. An instance is what the reflection methods call an object.
struct Instance {
    std::string name;
    std::uint32_t mesh = 0;             ///< index into Scene::meshes
    std::uint32_t material = 0;         ///< index into Scene::materials
    glm::dmat4 world_from_object{1.0};  ///< affine, may mirror; takes no vertex further than 3.4e38 m
};

/// What is dropped or ignored on the way in, one line each, for example
/// "meshes[3].primitives[0]: 2 triangles of zero area dropped".
using Notes = std::vector<std::string>;

/// A scene as plain data: no parsing, no GPU. World space is right-handed, +Y up, metres. What the importer
/// returns is valid; check_scene() tells it of any other.
struct Scene {
    std::string name;
    std::vector<Mesh> meshes;
    std::vector<Instance> instances;
    std::vector<Material> materials;
    std::vector<Texture> textures;
    std::vector<Light> lights;
    std::vector<Camera> cameras;  ///< to choose from; may be empty, but not for the program
    glm::vec3 environment{0.0f};  ///< cd/m2, >= 0, of the uniform environment that escaping rays see
};

}  // namespace utsuri
