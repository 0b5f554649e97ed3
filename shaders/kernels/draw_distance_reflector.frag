// SPDX-License-Identifier: Apache-2.0
// A reflector that shows what its maps hold where the mirrored ray meets the distances kept beside them.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/scene_bindings.glsl"
#include "kernels/view_push.glsl"
#include "kernels/drawn_light.glsl"
#include "kernels/map_lookup.glsl"
#include "kernels/search_bindings.glsl"

void main() {
    vec3 wo = -normalize_any_scale(drawn_from_eye);
    Surface surface;
    vec3 radiance = drawn_light(wo, surface);
    float found = DRAWN_PLAIN;
    if (is_specular(surface)) {
        found = DRAWN_LOOKED_UP;
        ReflectorInfo reflector = reflectors[drawn_ids.w];
        DistanceMapInfo map = distance_maps[drawn_ids.w];
        SearchRay ray = make_search_ray(surface.position - reflector.capture_point, mirror_direction(surface, wo));
        HitInterval found = refine_hit(map.first_sample, ray, search_distances(map.first_bounds, ray));
        vec3 direction = isinf(found.guess) ? ray.direction : ray_place(ray, found.guess);
        radiance += specular_reflectance(surface, abs(dot(surface.ns, wo))) * polygon_map(reflector.first_texel, direction);
    }
    drawn = vec4(radiance, found);
}
