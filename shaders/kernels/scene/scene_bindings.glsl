// SPDX-License-Identifier: Apache-2.0
// The scene's buffers.
#ifndef UTSURI_KERNELS_SCENE_SCENE_BINDINGS
#define UTSURI_KERNELS_SCENE_SCENE_BINDINGS

#extension GL_EXT_scalar_block_layout : require

#include "interop/bindings.h"
#include "interop/bvh.h"
#include "interop/scene.h"
#include "lib/scene_constants.glsl"

// What rays walk through is read as texels of four words: see binding_set.h.
layout(set = SCENE_SET, binding = BINDING_BVH_NODES) uniform usamplerBuffer bvh_nodes;
layout(set = SCENE_SET, binding = BINDING_BVH_TRIANGLES) uniform usamplerBuffer bvh_triangles;
layout(set = SCENE_SET, binding = BINDING_LIGHT_TREE) uniform usamplerBuffer light_tree;
layout(scalar, set = SCENE_SET, binding = BINDING_TRIANGLE_INFOS) readonly restrict buffer TriangleInfos { TriangleInfo triangle_infos[]; };
layout(scalar, set = SCENE_SET, binding = BINDING_NORMALS) readonly restrict buffer Normals { vec3 normals[]; };
layout(scalar, set = SCENE_SET, binding = BINDING_TEXCOORDS) readonly restrict buffer Texcoords { vec2 texcoords[]; };
layout(scalar, set = SCENE_SET, binding = BINDING_MATERIALS) readonly restrict buffer Materials { MaterialInfo materials[]; };
layout(scalar, set = SCENE_SET, binding = BINDING_LIGHTS) readonly restrict buffer Lights { LightInfo lights[]; };
layout(scalar, set = SCENE_SET, binding = BINDING_TEXELS) readonly restrict buffer Texels { uint texels[]; };

BvhNode bvh_node(uint index) {
    int texel = 5 * int(index);
    return BvhNode(texelFetch(bvh_nodes, texel), texelFetch(bvh_nodes, texel + 1), texelFetch(bvh_nodes, texel + 2),
                   texelFetch(bvh_nodes, texel + 3), texelFetch(bvh_nodes, texel + 4));
}

/// Its nine words lie in three texels, wherever they begin.
BvhTriangle bvh_triangle(uint index) {
    uint word = 9u * index;
    int texel = int(word >> 2u);
    uvec4 a = texelFetch(bvh_triangles, texel);
    uvec4 b = texelFetch(bvh_triangles, texel + 1);
    uvec4 c = texelFetch(bvh_triangles, texel + 2);
    if ((word & 1u) != 0u) {
        a = uvec4(a.yzw, b.x);
        b = uvec4(b.yzw, c.x);
        c.xyz = c.yzw;
    }
    if ((word & 2u) != 0u) {
        a = uvec4(a.zw, b.xy);
        b = uvec4(b.zw, c.xy);
        c.x = c.z;
    }
    return BvhTriangle(uintBitsToFloat(a.xyz), uintBitsToFloat(uvec3(a.w, b.xy)), uintBitsToFloat(uvec3(b.zw, c.x)));
}

/// One of its vertices, whose three words lie in two texels.
vec3 bvh_vertex(uint triangle, uint corner) {
    uint word = 9u * triangle + 3u * corner;
    int texel = int(word >> 2u);
    uvec4 a = texelFetch(bvh_triangles, texel);
    if ((word & 3u) > 1u) {
        uvec4 b = texelFetch(bvh_triangles, texel + 1);
        return uintBitsToFloat((word & 1u) != 0u ? uvec3(a.w, b.xy) : uvec3(a.zw, b.x));
    }
    return uintBitsToFloat((word & 1u) != 0u ? a.yzw : a.xyz);
}

#endif
