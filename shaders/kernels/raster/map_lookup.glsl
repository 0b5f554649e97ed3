// SPDX-License-Identifier: Apache-2.0
// What a drawn reflector shows: the light along its mirrored direction, from its maps.
#ifndef UTSURI_KERNELS_RASTER_MAP_LOOKUP
#define UTSURI_KERNELS_RASTER_MAP_LOOKUP

#include "kernels/maps/map_faces.glsl"
#include "kernels/maps/map_texels.glsl"
#include "kernels/maps/proxies.glsl"
#include "kernels/raster/drawn_surface.glsl"
#include "lib/camera.glsl"
#include "lib/surface.glsl"

vec3 map_radiance(uint probe, vec3 direction) {
    uint face = map_face(direction);
    vec3 p = map_position(map_faces[face], direction);
    return sample_map(probe, face, p.xy / p.z);
}

/// The probe whose maps a pixel looks up. What is found per vertex comes with the probe of its polygon.
uint drawn_probe(Surface surface, vec3 wi) {
    if (MAP_KIND == MAP_KIND_POLYGON || MAP_KIND == MAP_KIND_SPHERE) return drawn_ids.w;
    return nearest_probe(drawn_ids.w, surface.position, wi);
}

/// The direction from the capture point that the method means to look up, were it not for interpolation.
/// @param wi the mirrored direction
vec3 wanted_direction(Surface surface, uint probe, vec3 wi) {
    if (MAP_KIND != MAP_KIND_PROXY) return wi;
    return direction_to(leave_proxy(surface.position, wi, probes[probe].proxy), probes[probe].capture_point, wi);
}

/// The direction that it does look up.
vec3 looked_up_direction(Surface surface, uint probe, vec3 wi) {
    // Opposite vectors may cancel; nothing can be interpolated there.
    if (MAP_KIND == MAP_KIND_POLYGON && drawn_reflection != vec3(0.0)) return drawn_reflection;
    if (MAP_KIND == MAP_KIND_SPHERE) {
        CameraInfo axes = CameraInfo(vec3(0.0), probes[probe].map_right, probes[probe].map_up, probes[probe].map_forward);
        return sphere_map_direction(axes, 2.0 * drawn_reflection.xy - 1.0);
    }
    return wanted_direction(surface, probe, wi);
}

vec3 mapped_radiance(Surface surface, vec3 wi) {
    if (MAP_KIND == MAP_KIND_PIECES) {
        return sample_map(drawn_ids.w / FACE_COUNT, drawn_ids.w % FACE_COUNT, drawn_reflection.xy / drawn_reflection.z);
    }
    uint probe = drawn_probe(surface, wi);
    if (MAP_KIND == MAP_KIND_SPHERE) return sample_map(probe, 0u, 2.0 * drawn_reflection.xy - 1.0);
    return map_radiance(probe, looked_up_direction(surface, probe, wi));
}

/// Half the diagonal of the texel of a probe's maps that a direction points at, as an angle.
float texel_angle(uint probe, vec3 direction) {
    float size = float(probes[probe].map_size);
    if (MAP_KIND == MAP_KIND_SPHERE) {
        // Of the disc, whose texels all cover the same solid angle, ever narrower towards the rim: radially 4 / (N c) and
        // across 4 c / N, where c is the cosine of half the angle to the axis.
        vec2 p = 2.0 * drawn_reflection.xy - 1.0;
        float cosine = sqrt(max(1.0 - dot(p, p), 1e-12));
        return 2.0 / size * sqrt(1.0 / (cosine * cosine) + cosine * cosine);
    }
    MapFace face = map_faces[map_face(direction)];
    return face.half_diagonal / size * dot(face.outward, direction) / length(direction);
}

#endif
