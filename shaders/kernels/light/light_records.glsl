// SPDX-License-Identifier: Apache-2.0
// What tells where the light of a triangle is kept: kept_light.glsl reads it, others only hand it on.
#ifndef UTSURI_KERNELS_LIGHT_LIGHT_RECORDS
#define UTSURI_KERNELS_LIGHT_LIGHT_RECORDS

#extension GL_EXT_scalar_block_layout : require

#include "interop/bindings.h"
#include "interop/light_mesh.h"

layout(scalar, set = METHOD_SET, binding = BINDING_LIGHT_MESH_NODES) readonly restrict buffer LightMeshNodes { LightMeshNode light_nodes[]; };

/// A LightMeshNode, member by member. Those of triangles come first.
uvec4 light_record(uint node) {
    LightMeshNode n = light_nodes[node];
    return uvec4(n.split, n.first, n.second, n.third);
}

#endif
