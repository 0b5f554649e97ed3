// SPDX-License-Identifier: Apache-2.0
// What a mirror shows, looked up in its maps where that is predicted to be right enough, and left to a ray elsewhere.
#ifndef UTSURI_KERNELS_HYBRID_HYBRID_LIGHT
#define UTSURI_KERNELS_HYBRID_HYBRID_LIGHT

#include "kernels/hybrid/deferred_reflection.glsl"
#include "kernels/raster/shown_surface.glsl"
#include "lib/pixel_state.glsl"
#include "lib/reflectance.glsl"

/// What the maps show, and whether that is right enough. The kernel defines it.
bool look_up(Surface surface, vec3 wo, out vec3 radiance);

/// @param reflections that lie between the surface and the eye
/// @param state is set to how it was found; a chain that has as many reflections as there may be is cut, as traced ones are
vec3 hybrid_light(Surface surface, vec3 wo, uint reflections, out float state) {
    vec3 reflected;
    if (look_up(surface, wo, reflected)) {
        state = found_in_map(reflections);
        return specular_reflectance(surface, abs(dot(surface.ns, wo))) * reflected;
    }
    // A ray that is followed sets it again.
    state = truncated_at(reflections + 1u);
    if (reflections < frame.max_depth) defer_mirror(DEFERRED_MIRROR);
    return vec3(0.0);
}

#endif
