// SPDX-License-Identifier: Apache-2.0
// What a pixel of a view shows of a surface that is no mirror. A kernel includes how lobes are found before.
#ifndef UTSURI_KERNELS_PLANAR_MIRRORED_SCENE
#define UTSURI_KERNELS_PLANAR_MIRRORED_SCENE

#include "kernels/planar/mirrored_throughput.glsl"
#include "kernels/raster/drawn_light.glsl"

void draw_mirrored_scene() {
    if (!waits_for_this_view()) discard;
    Surface surface;
    float state = complete_after(view.reflections);
    vec3 radiance = drawn_light(-normalize_any_scale(drawn_from_eye), view.reflections, surface, state);
    drawn = with_light(radiance, state);
    drawn_throughput = vec4(0.0);
}

#endif
