// SPDX-License-Identifier: Apache-2.0
// The lobes of a surface, by number, for what chooses a lobe as it runs: a new lobe is one file and a line in each of these
// functions. What knows its lobe asks that lobe's own functions: these inline all lobes, which drivers take long to read.
#ifndef UTSURI_LIB_LOBES_LOBES
#define UTSURI_LIB_LOBES_LOBES

#include "lib/lobes/diffuse.glsl"
#include "lib/lobes/glossy.glsl"
#include "lib/lobes/mirror.glsl"

const uint LOBE_DIFFUSE = 0u;
const uint LOBE_GLOSSY = 1u;
const uint LOBE_MIRROR = 2u;

/// 1/sr, for a direction above the surface.
vec3 lobe_value(Surface surface, uint lobe, vec3 wo, vec3 wi) {
    if (lobe == LOBE_DIFFUSE) return diffuse_value(surface, wo, wi);
    return lobe == LOBE_GLOSSY ? glossy_value(surface, wo, wi) : vec3(0.0);
}

/// Density over solid angle with which sample_lobe() gives a direction above the surface.
float lobe_pdf(Surface surface, uint lobe, vec3 wo, vec3 wi) {
    if (lobe == LOBE_DIFFUSE) return diffuse_pdf(surface, wi);
    return lobe == LOBE_GLOSSY ? glossy_pdf(surface, wo, wi) : 0.0;
}

LobeSample sample_lobe(Surface surface, uint lobe, vec3 wo, vec2 u) {
    if (lobe == LOBE_DIFFUSE) return sample_diffuse(surface, wo, u);
    return lobe == LOBE_GLOSSY ? sample_glossy(surface, wo, u) : sample_mirror(surface, wo);
}

#endif
