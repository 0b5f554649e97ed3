// SPDX-License-Identifier: Apache-2.0
// Choosing a light for a point, by what it may bring there, shadows apart. Lights that are nowhere, the environment and
// directional ones, are chosen by power; the others by walking down a tree.
#ifndef UTSURI_KERNELS_SCENE_LIGHT_CHOICE
#define UTSURI_KERNELS_SCENE_LIGHT_CHOICE

#include "interop/light_tree.h"
#include "kernels/scene/scene_bindings.glsl"
#include "lib/light_importance.glsl"

uint light_count() {
    return LIGHT_COUNT == 0u ? 0u : uint(lights.length());
}

LightCluster light_cluster(uint index) {
    uvec4 a = texelFetch(light_tree, 2 * int(index));
    uvec4 b = texelFetch(light_tree, 2 * int(index) + 1);
    return LightCluster(uintBitsToFloat(a.xyz), uintBitsToFloat(a.w), uintBitsToFloat(b.x), b.y, uintBitsToFloat(b.z), b.w);
}

LightTreeNode light_tree_node(uint index) {
    return LightTreeNode(light_cluster(2u * index), light_cluster(2u * index + 1u));
}

struct LightChoice {
    uint light;         ///< or NONE, where no light reaches the point
    float probability;  ///< with which choose_light() takes it
};

/// How probable the first child of a node is; below 0 where neither brings anything.
float first_probability(LightTreeNode node, Receiver receiver) {
    float first = light_importance(node.first, receiver);
    float second = light_importance(node.second, receiver);
    return first + second > 0.0 ? first / (first + second) : -1.0;
}

/// @param child a light or a node of the tree, as LightCluster::child refers to it
/// @param probability that it is chosen
/// @param u is stretched: what is left of it is uniform again
LightChoice choose_in_tree(Receiver receiver, uint child, float probability, inout float u) {
    while ((child & LIGHT_CLUSTER_LEAF) == 0u) {
        LightTreeNode node = light_tree_node(child & LIGHT_CLUSTER_INDEX);
        float first = first_probability(node, receiver);
        if (first < 0.0) return LightChoice(NONE, 0.0);
        bool takes_first = u < first;
        float taken = takes_first ? first : 1.0 - first;
        u = min((takes_first ? u : u - first) / taken, ONE_BELOW_1);
        probability *= taken;
        child = takes_first ? node.first.child : node.second.child;
    }
    return LightChoice(child & LIGHT_CLUSTER_INDEX, probability);
}

/// @param u in [0, 1), used up
LightChoice choose_light(Receiver receiver, float u) {
    float rest = 1.0;
    for (uint i = 0u; i < INFINITE_LIGHTS; ++i) {
        float probability = lights[i].probability;
        // What rounding leaves after the last one is its own.
        if (u < probability || i + 1u == LIGHT_COUNT) return LightChoice(i, probability);
        u -= probability;
        rest -= probability;
    }
    float probability = INFINITE_LIGHTS > 0u ? lights[INFINITE_LIGHTS].probability : 1.0;
    u = min(u / rest, ONE_BELOW_1);
    return choose_in_tree(receiver, 0u, probability, u);
}

/// The probability with which choose_light() takes a light for a point.
float choice_probability(uint light, Receiver receiver) {
    LightInfo info = lights[light];
    if (light < INFINITE_LIGHTS) return info.probability;
    float probability = INFINITE_LIGHTS > 0u ? info.probability : 1.0;
    uint child = 0u;
    for (uint level = 0u; level < info.path_length; ++level) {
        LightTreeNode node = light_tree_node(child & LIGHT_CLUSTER_INDEX);
        bool takes_first = ((info.path >> level) & 1u) == 0u;
        float first = first_probability(node, receiver);
        if (first < 0.0) return 0.0;
        probability *= takes_first ? first : 1.0 - first;
        child = takes_first ? node.first.child : node.second.child;
    }
    return probability;
}

#endif
