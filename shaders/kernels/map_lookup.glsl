// SPDX-License-Identifier: Apache-2.0
// What a drawn reflector shows: the light along its mirrored direction, from its maps.
#include "kernels/map_bindings.glsl"

layout(constant_id = SPEC_MAP_KIND) const uint MAP_KIND = MAP_KIND_POLYGON;
layout(constant_id = SPEC_FACE_COUNT) const uint FACE_COUNT = CUBE_FACES;

layout(scalar, binding = BINDING_MAP_FACES) readonly restrict buffer MapFaces { MapFace map_faces[]; };

#include "lib/map_face.glsl"
#include "lib/proxy.glsl"

vec3 polygon_map(uint first_texel, vec3 direction) {
    uint face = map_face(direction);
    vec3 p = map_position(map_faces[face], direction);
    uint stride = MAP_SIZE + 2u * MAP_BORDER;
    return sample_map(first_texel + face * stride * stride, p.xy / p.z);
}

/// @param wi the mirrored direction
vec3 mapped_radiance(Surface surface, vec3 wi) {
    if (MAP_KIND == MAP_KIND_PIECES) return sample_map(drawn_ids.w, drawn_reflection.xy / drawn_reflection.z);
    ReflectorInfo reflector = reflectors[drawn_ids.w];
    if (MAP_KIND == MAP_KIND_SPHERE) return sample_map(reflector.first_texel, 2.0 * drawn_reflection.xy - 1.0);
    // Opposite vectors may cancel; nothing can be interpolated there.
    vec3 direction = MAP_KIND == MAP_KIND_POLYGON && drawn_reflection != vec3(0.0) ? drawn_reflection : wi;
    if (MAP_KIND == MAP_KIND_PROXY) {
        direction = leave_box(surface.position, wi, reflector.proxy_lower, reflector.proxy_upper) -
                    reflector.capture_point;
    }
    return polygon_map(reflector.first_texel, direction);
}
