// SPDX-License-Identifier: Apache-2.0
// What a pixel of a view shows of a plane mirror: the mirror's own light; for what it reflects the pixel waits.
#ifndef UTSURI_KERNELS_PLANAR_MIRRORED_MIRROR
#define UTSURI_KERNELS_PLANAR_MIRRORED_MIRROR

#include "kernels/planar/mirrored_throughput.glsl"
#include "kernels/raster/drawn_light.glsl"

/// @returns whether the mirror's view is not drawn
bool draw_mirrored_mirror() {
    if (!waits_for_this_view()) discard;
    vec3 wo = -normalize_any_scale(drawn_from_eye);
    Surface surface;
    float state = complete_after(view.reflections);
    vec3 radiance = drawn_light(wo, view.reflections, surface, state);
    bool mirrors = is_mirror(surface);
    if (mirrors) state = view.next == VIEW_TRUNCATED ? truncated_at(view.reflections + 1u) : waiting_for(view.next);
    drawn = with_light(radiance, state);
    vec3 reflectance = mirrors ? specular_reflectance(surface, abs(dot(surface.ns, wo))) : vec3(0.0);
    drawn_throughput = vec4(with_reflectance(reflectance), 0.0);
    return mirrors && view.next == VIEW_TRUNCATED;
}

#endif
