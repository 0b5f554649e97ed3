// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/scene.h"

#include <filesystem>

namespace utsuri {

/// A scene and what became of the file's contents on the way in.
struct ImportResult {
    Scene scene;
    Notes ignored;  ///< glTF features present but not used, by name and place
    Notes dropped;  ///< geometry that cannot be drawn, with counts
    Notes added;    ///< what the file lacks and the importer supplied: normals, a camera, an environment
};

/// Reads glTF 2.0, as .gltf or .glb (told apart by content), with external, embedded or data-URI resources.
/// Only what the default scene uses is imported: one Mesh and Instance per primitive, one Texture per image.
/// Extensions used: KHR_lights_punctual, KHR_materials_emissive_strength, KHR_materials_ior,
/// KHR_materials_specular, KHR_mesh_quantization.
/// @throws InputError naming the file and the JSON path if the file is missing, damaged, breaks the
/// specification in a way that changes the picture, or requires an extension not listed here.
ImportResult import_gltf(const std::filesystem::path& path);

}  // namespace utsuri
