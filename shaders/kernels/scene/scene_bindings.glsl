// SPDX-License-Identifier: Apache-2.0
// The scene as every tracing kernel sees it: specialization constants and buffers.
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_control_flow_attributes : require

#include "interop/bindings.h"
#include "interop/bvh.h"
#include "interop/scene.h"
#include "interop/specialization.h"

layout(constant_id = SPEC_STACK_SIZE) const uint STACK_SIZE = BVH_MAX_DEPTH;
layout(constant_id = SPEC_HAS_TEXTURES) const bool HAS_TEXTURES = true;
layout(constant_id = SPEC_HAS_TRIANGLE_LIGHTS) const bool HAS_TRIANGLE_LIGHTS = true;
layout(constant_id = SPEC_HAS_PUNCTUAL_LIGHTS) const bool HAS_PUNCTUAL_LIGHTS = true;
layout(constant_id = SPEC_HAS_ENVIRONMENT) const bool HAS_ENVIRONMENT = true;
layout(constant_id = SPEC_HAS_GLOSSY) const bool HAS_GLOSSY = true;
layout(constant_id = SPEC_HAS_SPECULAR) const bool HAS_SPECULAR = true;
layout(constant_id = SPEC_EXCLUDES_INSTANCE) const bool EXCLUDES_INSTANCE = false;
layout(constant_id = SPEC_LIGHT_COUNT) const uint LIGHT_COUNT = 0u;
/// The environment, where there is one, is the first light.
const uint ENVIRONMENT_LIGHT = 0u;

layout(std430, binding = BINDING_BVH_NODES) readonly restrict buffer BvhNodes { BvhNode bvh_nodes[]; };
layout(scalar, binding = BINDING_BVH_TRIANGLES) readonly restrict buffer BvhTriangles { BvhTriangle bvh_triangles[]; };
layout(scalar, binding = BINDING_TRIANGLE_INFOS) readonly restrict buffer TriangleInfos { TriangleInfo triangle_infos[]; };
layout(scalar, binding = BINDING_NORMALS) readonly restrict buffer Normals { vec3 normals[]; };
layout(scalar, binding = BINDING_TEXCOORDS) readonly restrict buffer Texcoords { vec2 texcoords[]; };
layout(scalar, binding = BINDING_MATERIALS) readonly restrict buffer Materials { MaterialInfo materials[]; };
layout(scalar, binding = BINDING_LIGHTS) readonly restrict buffer Lights { LightInfo lights[]; };
layout(scalar, binding = BINDING_LIGHT_TABLE) readonly restrict buffer LightTable { LightTableEntry light_table[]; };
layout(scalar, binding = BINDING_TEXTURE_HEADERS) readonly restrict buffer TextureHeaders { TextureHeader texture_headers[]; };
layout(scalar, binding = BINDING_TEXELS) readonly restrict buffer Texels { uint texels[]; };
