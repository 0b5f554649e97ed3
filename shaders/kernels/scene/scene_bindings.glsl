// SPDX-License-Identifier: Apache-2.0
// The scene's buffers.
#ifndef UTSURI_KERNELS_SCENE_SCENE_BINDINGS
#define UTSURI_KERNELS_SCENE_SCENE_BINDINGS

#extension GL_EXT_scalar_block_layout : require

#include "interop/bindings.h"
#include "interop/bvh.h"
#include "interop/scene.h"
#include "lib/scene_constants.glsl"

layout(std430, set = SCENE_SET, binding = BINDING_BVH_NODES) readonly restrict buffer BvhNodes { BvhNode bvh_nodes[]; };
layout(scalar, set = SCENE_SET, binding = BINDING_BVH_TRIANGLES) readonly restrict buffer BvhTriangles { BvhTriangle bvh_triangles[]; };
layout(scalar, set = SCENE_SET, binding = BINDING_TRIANGLE_INFOS) readonly restrict buffer TriangleInfos { TriangleInfo triangle_infos[]; };
layout(scalar, set = SCENE_SET, binding = BINDING_NORMALS) readonly restrict buffer Normals { vec3 normals[]; };
layout(scalar, set = SCENE_SET, binding = BINDING_TEXCOORDS) readonly restrict buffer Texcoords { vec2 texcoords[]; };
layout(scalar, set = SCENE_SET, binding = BINDING_MATERIALS) readonly restrict buffer Materials { MaterialInfo materials[]; };
layout(scalar, set = SCENE_SET, binding = BINDING_LIGHTS) readonly restrict buffer Lights { LightInfo lights[]; };
layout(scalar, set = SCENE_SET, binding = BINDING_TEXELS) readonly restrict buffer Texels { uint texels[]; };

#endif
