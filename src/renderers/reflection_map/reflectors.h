// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/common/scene_data.h"

#include "interop/reflection.h"

#include <cstdint>
#include <vector>

namespace utsuri {

/// The reflective instances of a scene and their vertices, as reflection mapping needs them.
struct Reflectors {
    std::vector<std::uint32_t> instances;            ///< scene instance of each reflector
    std::vector<std::uint32_t> instance_reflectors;  ///< one per scene instance: its reflector, or NONE
    std::vector<interop::ReflectorVertex> vertices;
    std::vector<std::uint32_t> vertex_slots;  ///< one per scene vertex: its place in `vertices`, or NONE
};

Reflectors find_reflectors(const SceneData& scene);

}  // namespace utsuri
