// SPDX-License-Identifier: Apache-2.0
// direct/sphere-map: the fisheye map of OpenGL 1.x in eye space, with texture coordinates generated per vertex and
// interpolated over the polygon. The baseline, faults included.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/scene_bindings.glsl"
#include "kernels/film_bindings.glsl"
#include "kernels/map_bindings.glsl"
#include "lib/direct_light.glsl"

vec3 reflected_radiance(Surface surface, Hit hit, vec3 wi) {
    uvec3 vertices = triangle_infos[hit.triangle].vertices;
    vec2 s0 = vertex_reflections[vertex_slots[vertices.x]].sphere_map;
    vec2 s1 = vertex_reflections[vertex_slots[vertices.y]].sphere_map;
    vec2 s2 = vertex_reflections[vertex_slots[vertices.z]].sphere_map;
    vec2 s = (1.0 - hit.b1 - hit.b2) * s0 + hit.b1 * s1 + hit.b2 * s2;
    ReflectorInfo reflector = reflectors[instance_reflectors[surface.instance]];
    return sample_map(reflector.first_texel, 2.0 * s - 1.0);
}

#include "kernels/film_main.glsl"

#include "kernels/map_main.glsl"

void main() {
    render_pixel();
}
