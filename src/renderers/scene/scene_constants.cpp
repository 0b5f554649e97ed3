// SPDX-License-Identifier: Apache-2.0
#include "renderers/scene/scene_constants.h"

#include "interop/specialization.h"

#include <bit>

namespace utsuri {

Specialization scene_constants(const SceneData& data) {
    const Requirements& needs = data.requirements;
    return {{interop::SPEC_STACK_SIZE, data.bvh.depth},
            {interop::SPEC_HAS_TEXTURES, needs.textures > 0 ? 1 : 0},
            {interop::SPEC_HAS_TRIANGLE_LIGHTS, needs.emissive_triangles > 0 ? 1 : 0},
            {interop::SPEC_HAS_PUNCTUAL_LIGHTS, needs.punctual_lights > 0 ? 1 : 0},
            {interop::SPEC_ENVIRONMENT_LIGHT, data.environment_light().value_or(interop::NONE)},
            {interop::SPEC_HAS_GLOSSY, needs.glossy ? 1 : 0},
            {interop::SPEC_HAS_MIRROR, needs.mirror ? 1 : 0},
            {interop::SPEC_LAYER_DISTANCE, std::bit_cast<std::uint32_t>(data.layer_distance)},
            {interop::SPEC_LIGHT_COUNT, static_cast<std::uint32_t>(data.lights.size())}};
}

Specialization depth_constants(const Specialization& specialization) {
    return {{interop::SPEC_LAYER_DISTANCE, specialization.at(interop::SPEC_LAYER_DISTANCE)}};
}

Specialization with_features(Specialization specialization, const SurfaceFeatures& features) {
    specialization[interop::SPEC_HAS_TEXTURES] = features.textured ? 1 : 0;
    specialization[interop::SPEC_HAS_GLOSSY] = features.glossy ? 1 : 0;
    return specialization;
}

}  // namespace utsuri
