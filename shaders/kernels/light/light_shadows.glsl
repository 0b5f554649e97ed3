// SPDX-License-Identifier: Apache-2.0
// What of the lights' sums arrives at a point: of each group of lights, rays tell the share that is not in shadow (Heitz, Hill
// and McGuire 2018). No noise where nothing or all of a group is in shadow, whatever the others do.
#ifndef UTSURI_KERNELS_LIGHT_LIGHT_SHADOWS
#define UTSURI_KERNELS_LIGHT_LIGHT_SHADOWS

#include "interop/frame.h"
#include "kernels/light/light_sums.glsl"
#include "kernels/scene/direct_light.glsl"

/// Samples of a group after which it counts as lit for good where it is in no shadow so far, and as dark where it is in full
/// shadow: a little light missed there shows more than a little shadow missed in full light. Where it is so at both ends of the
/// edge that a place lies on, few samples confirm it.
/// @param expected whether it is
uint lit_after(uint samples, bool expected) {
    return expected ? max(4u, samples / 16u) : max(8u, samples / 4u);
}
uint dark_after(uint samples, bool expected) {
    return expected ? max(2u, samples / 16u) : max(8u, samples / 2u);
}

/// Groups that are lit or dark, a bit each.
struct GroupStates {
    uint lit;
    uint dark;
};

/// The samples of one group, as far as they are taken.
struct GroupShadow {
    uint group;    ///< or NONE
    uint samples;  ///< at most
    uint taken;
    uint rays;     ///< of samples that would bring light
    uint lit;      ///< of these, how many do
    vec3 sampled;  ///< what they would bring
    vec3 visible;  ///< what they bring
};

/// Groups that are still to be looked at, and what is known of the others.
struct Shadows {
    float left;    ///< what groups to come would bring without shadows
    vec3 light;    ///< what those before bring
    uint samples;  ///< that may still be taken, but for one of each group
};

float strength_of(vec3 irradiance) {
    return irradiance.x + irradiance.y + irradiance.z;
}

/// The strongest group to come, with its share of the samples.
GroupShadow next_group(inout Shadows shadows) {
    uint strongest = NONE;
    float most = 0.0;
    for (uint group = 0u; group < light_groups.length(); ++group) {
        float strength = strength_of(group_irradiance[group]);
        if (strength <= most) continue;
        strongest = group;
        most = strength;
    }
    GroupShadow shadow = GroupShadow(strongest, 0u, 0u, 0u, 0u, vec3(0.0), vec3(0.0));
    if (strongest == NONE) return shadow;
    // By its share of what arrives as far as is known: what is in shadow leaves its samples to others.
    float share = min(most / (strength_of(shadows.light) + shadows.left), 1.0);
    uint samples = min(uint(ceil(share * float(push.samples))), shadows.samples);
    shadow.samples = max(min(samples, light_groups[strongest].most_samples), 1u);
    shadows.left = max(shadows.left - most, 0.0);
    return shadow;
}

bool is_told(GroupShadow shadow, GroupStates expected) {
    uint lit_samples = lit_after(shadow.samples, (expected.lit >> shadow.group & 1u) != 0u);
    uint dark_samples = dark_after(shadow.samples, (expected.dark >> shadow.group & 1u) != 0u);
    bool is_lit = shadow.taken == lit_samples && shadow.lit == shadow.rays && shadow.lit > 0u;
    bool is_dark = shadow.taken == dark_samples && shadow.lit == 0u && shadow.rays > 0u;
    return is_lit || is_dark || shadow.taken == shadow.samples;
}

void take_sample(inout GroupShadow shadow, Surface surface, uint key) {
    // One number chooses a light and then a point on it: samples are spread evenly over all of the group.
    vec2 u = sample_2d(key, shadow.taken, shadow.group);
    ++shadow.taken;
    LightChoice chosen = choose_in_tree(receiver_of(surface), light_groups[shadow.group].reference, 1.0, u.x);
    Candidate candidate = make_candidate(surface, surface.ns, 1u << LOBE_DIFFUSE, chosen, u);
    if (candidate.value == vec3(0.0)) return;
    ++shadow.rays;
    shadow.sampled += candidate.value;
    if (!is_light_visible(surface, candidate.light, NONE)) return;
    ++shadow.lit;
    shadow.visible += candidate.value;
}

/// Irradiance from all lights, lux.
/// @param expected at this place
/// @param found what turned out
/// @param counters rays, and a sample that the driver left out, are added
vec3 shadowed_irradiance(Surface surface, uint key, GroupStates expected, out GroupStates found, inout Counters counters) {
    found = GroupStates(ALL_LIGHT_GROUPS, ALL_LIGHT_GROUPS);
    sum_lights(surface);
    Shadows shadows = Shadows(0.0, vec3(0.0), push.samples);
    for (uint group = 0u; group < light_groups.length(); ++group) shadows.left += strength_of(group_irradiance[group]);
    GroupShadow shadow = next_group(shadows);
    while (shadow.group != NONE) {
        take_sample(shadow, surface, key);
        if (!is_told(shadow, expected)) continue;
        vec3 share = mix(shadow.visible / shadow.sampled, vec3(0.0), equal(shadow.sampled, vec3(0.0)));
        shadows.light += group_irradiance[shadow.group] * share;
        shadows.samples -= min(shadow.taken, shadows.samples);
        counters.rays += shadow.rays;
        if (shadow.lit < shadow.rays) found.lit &= ~(1u << shadow.group);
        if (shadow.lit > 0u) found.dark &= ~(1u << shadow.group);
        group_irradiance[shadow.group] = vec3(0.0);
        shadow = next_group(shadows);
    }
    // That a group is left cannot be, and is where the driver ended the loop: see film_main.glsl.
    if (shadow.group != NONE) counters.incomplete = 1u;
    return shadows.light;
}

#endif
