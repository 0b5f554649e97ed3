// SPDX-License-Identifier: Apache-2.0
// What a kernel is told of the scene before it is compiled.
#ifndef UTSURI_LIB_SCENE_CONSTANTS
#define UTSURI_LIB_SCENE_CONSTANTS

#include "interop/bvh.h"
#include "interop/specialization.h"

layout(constant_id = SPEC_STACK_SIZE) const uint STACK_SIZE = BVH_MAX_DEPTH;
layout(constant_id = SPEC_HAS_TEXTURES) const bool HAS_TEXTURES = true;
layout(constant_id = SPEC_HAS_TRIANGLE_LIGHTS) const bool HAS_TRIANGLE_LIGHTS = true;
layout(constant_id = SPEC_HAS_PUNCTUAL_LIGHTS) const bool HAS_PUNCTUAL_LIGHTS = true;
layout(constant_id = SPEC_HAS_GLOSSY) const bool HAS_GLOSSY = true;
layout(constant_id = SPEC_HAS_MIRROR) const bool HAS_MIRROR = true;
layout(constant_id = SPEC_EXCLUDES_INSTANCE) const bool EXCLUDES_INSTANCE = false;
/// Lights that are nowhere, the first of all, and all of them, which from MOST_TOLD_LIGHTS on may be more: scenes with many
/// lights share their kernels.
layout(constant_id = SPEC_INFINITE_LIGHTS) const uint INFINITE_LIGHTS = 0u;
layout(constant_id = SPEC_LIGHT_COUNT) const uint LIGHT_COUNT = 0u;
/// Light without shadows is summed in closed form: samples tell the shadows alone.
layout(constant_id = SPEC_SUMS_LIGHTS) const bool SUMS_LIGHTS = false;
/// Index of the environment among the lights, or NONE.
layout(constant_id = SPEC_ENVIRONMENT_LIGHT) const uint ENVIRONMENT_LIGHT = 0u;
const bool HAS_ENVIRONMENT = ENVIRONMENT_LIGHT != NONE;
layout(constant_id = SPEC_HAS_LAYERS) const bool HAS_LAYERS = false;

#endif
