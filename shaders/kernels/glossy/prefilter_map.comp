// SPDX-License-Identifier: Apache-2.0
// One level of a glossy map: what the GGX lobe of one width reflects of a cube of maps to a viewer at its normal, weighted by
// the cosine (the first factor of the split sum, Karis 2013). Not sampled but summed over blocks of texels, small where the
// lobe bends: without noise however small and bright lights are, and exact where all is uniform. Where distances are kept, so
// is one over the distance that the light comes from.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "interop/bindings.h"
#include "interop/glossy_map.h"
#include "interop/specialization.h"
#include "interop/workgroup.h"
#include "lib/cube.glsl"
#include "lib/light_distance.glsl"

layout(local_size_x = WORKGROUP_SIZE) in;

layout(constant_id = SPEC_KEEPS_DISTANCES) const bool KEEPS_DISTANCES = false;

layout(push_constant, scalar) uniform Push { PrefilterMapPush push; };

layout(scalar, set = METHOD_SET, binding = BINDING_MAP_TEXELS) readonly restrict buffer MapTexels { vec3 map_texels[]; };
layout(scalar, set = METHOD_SET, binding = BINDING_GLOSSY_TEXELS) writeonly restrict buffer GlossyTexels { vec3 glossy_texels[]; };
layout(scalar, set = METHOD_SET, binding = BINDING_MAP_INVERSE_DISTANCES) readonly restrict buffer MapInverseDistances {
    float map_inverse_distances[];
};
layout(scalar, set = METHOD_SET, binding = BINDING_GLOSSY_INVERSE_DISTANCES) writeonly restrict buffer GlossyInverseDistances {
    float glossy_inverse_distances[];
};

/// Half the edge of a block, at most, as a share of the angle over which the lobe changes: there, 4/3 of its square is the
/// error of taking the lobe at the block's centre. Blocks of wide lobes are no larger than this.
const float BLOCK_SHARE = 1.0 / 16.0;

/// Blocks of a quadtree over each face in Morton order, the larger before what they consist of.
struct Block {
    uint level;  ///< 0: texels
    uvec2 place;
};

/// The lobe over the solid angle of light from direction l, up to a factor, where normal and viewer lie along n.
/// @param chord2 |l - n|^2, which knows small angles better than the cosine
float lobe_weight(float chord2) {
    float cos_i = 1.0 - 0.5 * chord2;
    if (cos_i <= 0.0) return 0.0;
    float sin2_h = 0.25 * chord2;
    // Times alpha^2: narrow lobes would overflow.
    float ratio = push.alpha / (push.alpha * push.alpha * (1.0 - sin2_h) + sin2_h) * push.alpha;
    return ratio * ratio * cos_i;
}

bool next_block(inout Block block, uint top) {
    while (block.level < top) {
        if ((block.place.x & 1u) == 0u) {
            block.place.x += 1u;
            return true;
        }
        if ((block.place.y & 1u) == 0u) {
            block.place += uvec2(-1, 1);
            return true;
        }
        block.place >>= 1;
        block.level += 1u;
    }
    return false;
}

/// What the lobe reflects and, last, from how far away, as LightDistance has it.
vec4 sum_blocks(vec3 n) {
    uint top = uint(findMSB(push.source_size));
    vec3 sum = vec3(0.0);
    LightDistance distance = LightDistance(0.0, 0.0);
    float weights = 0.0;
    for (uint face = 0u; face < GLOSSY_MAP_FACES; ++face) {
        Block block = Block(top, uvec2(0u));
        bool more = true;
        while (more) {
            uint edge = push.source_size >> block.level;
            vec2 p = cube_place(block.place, edge);
            vec3 from_n = normalize(cube_vector(vec3(p, 1.0), face)) - n;
            float chord2 = dot(from_n, from_n);
            if (block.level > 0u && 1.0 > BLOCK_SHARE * float(edge) * min(2.0 * push.alpha + sqrt(chord2), 1.0)) {
                block = Block(block.level - 1u, 2u * block.place);
                continue;
            }
            float weight = lobe_weight(chord2) * cube_solid_angle(p) / float(edge * edge);
            if (weight > 0.0) {
                uint source = cube_level(push.source_size, block.level) + (face * edge + block.place.y) * edge + block.place.x;
                sum += weight * map_texels[source];
                if (KEEPS_DISTANCES) add_light(distance, weight * map_texels[source], map_inverse_distances[source]);
                weights += weight;
            }
            more = next_block(block, top);
        }
    }
    return vec4(sum / weights, distance.inverse);
}

void main() {
    uint index = push.begin + gl_GlobalInvocationID.x;
    if (index >= push.end) return;
    uint stride = push.size + 2u * GLOSSY_MAP_BORDER;
    vec2 texel = vec2(index % stride, index / stride % stride) - float(GLOSSY_MAP_BORDER);
    vec2 p = (texel + 0.5) * (2.0 / float(push.size)) - 1.0;
    uint face = index / (stride * stride);
    vec4 seen = sum_blocks(normalize(cube_vector(vec3(p, 1.0), face)));
    glossy_texels[push.first_texel + index] = seen.rgb;
    if (KEEPS_DISTANCES) glossy_inverse_distances[push.first_texel + index] = seen.w;
}
