// SPDX-License-Identifier: Apache-2.0
// The probe of a whole polygon, for what is found per vertex: its pieces must not look different maps up.
#ifndef UTSURI_KERNELS_REFLECTORS_POLYGON_PROBE
#define UTSURI_KERNELS_REFLECTORS_POLYGON_PROBE

#include "kernels/maps/probes.glsl"
#include "kernels/reflectors/polygons.glsl"

uint polygon_probe(ReflectorTriangle polygon) {
    if (MOST_PROBES == 1u) return polygon.reflector;
    vec3 position = vec3(0.0);
    vec3 direction = vec3(0.0);
    for (uint corner = 0u; corner < 3u; ++corner) {
        position += reflector_vertices[polygon.vertices[corner]].position / 3.0;
        direction += vertex_reflections[polygon.vertices[corner]].direction;
    }
    return nearest_probe(polygon.reflector, position, direction);
}

#endif
