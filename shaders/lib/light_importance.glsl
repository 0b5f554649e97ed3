// SPDX-License-Identifier: Apache-2.0
// How much light a cluster of lights may bring to a point, shadows apart (Conty Estevez and Kulla 2018, section 4).
#ifndef UTSURI_LIB_LIGHT_IMPORTANCE
#define UTSURI_LIB_LIGHT_IMPORTANCE

#include "interop/light_tree.h"
#include "lib/numeric.glsl"
#include "lib/surface.glsl"

/// Of a unit vector packed on an octahedron (Cigolle et al. 2014).
vec3 octahedral_axis(uint packed) {
    vec2 p = unpackSnorm2x16(packed);
    vec3 axis = vec3(p, 1.0 - abs(p.x) - abs(p.y));
    float folded = max(-axis.z, 0.0);
    axis.x += axis.x >= 0.0 ? -folded : folded;
    axis.y += axis.y >= 0.0 ? -folded : folded;
    return normalize(axis);
}

/// The cosine of max(0, a - b).
float cosine_less(float cos_a, float cos_b) {
    if (cos_a >= cos_b) return 1.0;
    return cos_a * cos_b + sqrt(max(0.0, 1.0 - cos_a * cos_a) * max(0.0, 1.0 - cos_b * cos_b));
}

/// Zero only where no light of the cluster shines on the receiver's side.
float light_importance(LightCluster cluster, Receiver receiver) {
    /// Cosines are rounded by less.
    const float ROUNDING = 1.0 / 65536.0;
    vec3 way = cluster.centre - receiver.position;
    float distance_squared = dot(way, way);
    float radius_squared = cluster.radius * cluster.radius;
    if (distance_squared <= radius_squared) return radius_squared > 0.0 ? cluster.power / radius_squared : 0.0;
    vec3 direction = way * inversesqrt(distance_squared);
    float cos_ball = sqrt(1.0 - radius_squared / distance_squared);
    float received = cosine_less(dot(receiver.normal, direction), cos_ball);
    float emitted = -dot(octahedral_axis(cluster.axis), direction);
    if ((cluster.child & LIGHT_CLUSTER_BOTH_SIDES) != 0u) emitted = abs(emitted);
    emitted = cosine_less(cosine_less(emitted, cluster.cos_spread), cos_ball);
    if (min(received, emitted) < -ROUNDING) return 0.0;
    return cluster.power * max(received, ROUNDING) * max(emitted, ROUNDING) / distance_squared;
}

#endif
