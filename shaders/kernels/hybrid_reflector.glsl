// SPDX-License-Identifier: Apache-2.0
// A reflector whose pixels are looked up in its maps where that is predicted to be right enough, and traced elsewhere.
// The including kernel defines before what that means:
//   bool look_up(Surface surface, vec3 wo, out vec3 radiance);  false where it is not right enough
#include "kernels/traced_reflection.glsl"
#include "lib/image_state.glsl"

void main() {
    vec3 wo = -normalize_any_scale(drawn_from_eye);
    Surface surface;
    vec3 radiance = drawn_light(wo, surface);
    float found = DRAWN_PLAIN;
    if (is_specular(surface)) {
        vec3 reflected;
        uint rays = 0u;
        if (!look_up(surface, wo, reflected)) reflected = traced_radiance(surface, wo, 0u, rays);
        radiance += specular_reflectance(surface, abs(dot(surface.ns, wo))) * reflected;
        found = found_by(0u, rays);
    }
    drawn = vec4(radiance, found);
}
