// SPDX-License-Identifier: Apache-2.0
// Test of a ray against the eight quantised boxes of a node (Ylitie, Karras and Laine 2017, section 4), made
// conservative: no box that the exact ray touches is ever missed.
#ifndef UTSURI_LIB_BVH_NODE
#define UTSURI_LIB_BVH_NODE

#extension GL_EXT_control_flow_attributes : require

#include "interop/bvh.h"
#include "lib/numeric.glsl"

struct BoxRay {
    vec3 origin;
    vec3 reciprocal;    ///< of the direction, finite
    uint octant;        ///< 7 - (bit a set where the direction is negative on axis a)
};

BoxRay make_box_ray(vec3 origin, vec3 direction) {
    // A component this far below the largest one cannot move the ray by a rounding error; it only avoids 1 / 0.
    float smallest = max_component(abs(direction)) * 8.67361737988403547e-19;  // 2^-60
    vec3 magnitude = max(abs(direction), vec3(smallest));
    bvec3 negative = lessThan(direction, vec3(0.0));
    uint octant = 7u - (uint(negative.x) | (uint(negative.y) << 1) | (uint(negative.z) << 2));
    return BoxRay(origin, mix(1.0 / magnitude, -1.0 / magnitude, negative), octant);
}

float byte_of(uint word, uint index) {
    return float(bitfieldExtract(word, int(index * 8u), 8));
}

/// Bits of what the ray hits within [0, t_max]: triangles from bit 0 on, nodes from BVH_NODE_BITS on, with those that
/// the ray should visit first at the higher bits.
uint hit_children(BvhNode node, BoxRay ray, float t_max) {
    uvec3 exponents = (uvec3(node.origin_exponents.w) << uvec3(23u, 15u, 7u)) & 0x7f800000u;
    vec3 scale = uintBitsToFloat(exponents) * ray.reciprocal;
    vec3 base = (uintBitsToFloat(node.origin_exponents.xyz) - ray.origin) * ray.reciprocal;
    // A plane is met at t = base + q * scale. Subtraction, reciprocal (2.5 ulp on a GPU), two products and the sum
    // together err by under 10 unit roundoffs of |base| + 255 |scale|; 16 leaves room for the triangle test's own.
    vec3 slack = (abs(base) + 255.0 * abs(scale)) * (16.0 * UNIT_ROUNDOFF);
    vec3 near_base = base - slack;
    vec3 far_base = base + slack;

    bool positive_x = (ray.octant & 1u) != 0u;
    bool positive_y = (ray.octant & 2u) != 0u;
    bool positive_z = (ray.octant & 4u) != 0u;
    uvec2 near_x = positive_x ? node.lower_xy.xy : node.lower_z_upper_x.zw;
    uvec2 far_x = positive_x ? node.lower_z_upper_x.zw : node.lower_xy.xy;
    uvec2 near_y = positive_y ? node.lower_xy.zw : node.upper_yz.xy;
    uvec2 far_y = positive_y ? node.upper_yz.xy : node.lower_xy.zw;
    uvec2 near_z = positive_z ? node.lower_z_upper_x.xy : node.upper_yz.zw;
    uvec2 far_z = positive_z ? node.upper_yz.zw : node.lower_z_upper_x.xy;

    uint octants = ray.octant * 0x01010101u;
    uint hits = 0u;
    [[unroll]] for (uint part = 0u; part < 2u; ++part) {
        uint meta = part == 0u ? node.bases_meta.z : node.bases_meta.w;
        // Slots that hold nodes have both bits 3 and 4 set (24 + slot): only their positions are permuted.
        uint is_node = (meta & (meta << 1)) & 0x10101010u;
        uint node_bytes = (is_node >> 4) * 0xffu;
        uint positions = (meta ^ (octants & node_bytes)) & 0x1f1f1f1fu;
        uint bits = (meta >> 5) & 0x07070707u;
        uint words[6] = uint[6](near_x[part], far_x[part], near_y[part], far_y[part], near_z[part], far_z[part]);
        [[unroll]] for (uint i = 0u; i < 4u; ++i) {
            vec3 t_near = vec3(byte_of(words[0], i), byte_of(words[2], i), byte_of(words[4], i)) * scale + near_base;
            vec3 t_far = vec3(byte_of(words[1], i), byte_of(words[3], i), byte_of(words[5], i)) * scale + far_base;
            bool hit = max(max_component(t_near), 0.0) <= min(min(t_far.x, t_far.y), min(t_far.z, t_max));
            uint shifted = bitfieldExtract(bits, int(i * 8u), 8) << bitfieldExtract(positions, int(i * 8u), 8);
            hits |= hit ? shifted : 0u;
        }
    }
    return hits;
}

#endif
