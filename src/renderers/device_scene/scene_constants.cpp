// SPDX-License-Identifier: Apache-2.0
#include "renderers/device_scene/scene_constants.h"

#include "interop/specialization.h"

#include <algorithm>
#include <cstdint>

namespace utsuri {

namespace {

/// Depths of trees are told apart by so much: the fewer there are, the more scenes share their kernels.
constexpr std::uint32_t kDepthStep = 8;

std::uint32_t rounded_up(std::uint32_t depth) {
    return (depth + kDepthStep - 1) / kDepthStep * kDepthStep;
}

/// Kernels have to know whether there are lights beside those that are nowhere.
std::uint32_t told_lights(const SceneData& data) {
    const auto lights = static_cast<std::uint32_t>(data.lights.size());
    return std::min(lights, std::max(interop::MOST_TOLD_LIGHTS, data.infinite_lights() + 1));
}

}  // namespace

Specialization scene_constants(const SceneData& data) {
    const Requirements& needs = data.requirements;
    return {{interop::SPEC_STACK_SIZE, rounded_up(data.bvh.depth)},
            {interop::SPEC_HAS_TEXTURES, needs.textures > 0 ? 1 : 0},
            {interop::SPEC_HAS_TRIANGLE_LIGHTS, needs.emissive_triangles > 0 ? 1 : 0},
            {interop::SPEC_HAS_PUNCTUAL_LIGHTS, needs.punctual_lights > 0 ? 1 : 0},
            {interop::SPEC_ENVIRONMENT_LIGHT, data.environment_light().value_or(interop::NONE)},
            {interop::SPEC_HAS_GLOSSY, needs.glossy ? 1 : 0},
            {interop::SPEC_HAS_MIRROR, needs.mirror ? 1 : 0},
            {interop::SPEC_HAS_LAYERS, data.layer_distance > 0.0f ? 1 : 0},
            {interop::SPEC_INFINITE_LIGHTS, data.infinite_lights()},
            {interop::SPEC_LIGHT_COUNT, told_lights(data)}};
}

Specialization depth_constants(const Specialization& specialization) {
    return {{interop::SPEC_HAS_LAYERS, specialization.at(interop::SPEC_HAS_LAYERS)}};
}

Specialization with_features(Specialization specialization, const SurfaceFeatures& features) {
    specialization[interop::SPEC_HAS_TEXTURES] = features.textured ? 1 : 0;
    specialization[interop::SPEC_HAS_GLOSSY] = features.glossy ? 1 : 0;
    return specialization;
}

}  // namespace utsuri
