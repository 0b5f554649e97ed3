// SPDX-License-Identifier: Apache-2.0
// direct/polygon-map: polygon-based omnidirectional reflection mapping (Aono and Ohbuchi 1996). Reflection vectors per
// vertex, interpolated over the polygon before the projection onto a face of the polyhedron of maps.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/scene_bindings.glsl"
#include "kernels/film_bindings.glsl"
#include "kernels/map_bindings.glsl"
#include "lib/cube_map.glsl"
#include "lib/direct_light.glsl"

vec3 reflected_radiance(Surface surface, Hit hit, vec3 wi) {
    uvec3 vertices = triangle_infos[hit.triangle].vertices;
    VertexReflection r0 = vertex_reflections[vertex_slots[vertices.x]];
    VertexReflection r1 = vertex_reflections[vertex_slots[vertices.y]];
    VertexReflection r2 = vertex_reflections[vertex_slots[vertices.z]];
    vec3 direction = (1.0 - hit.b1 - hit.b2) * r0.direction + hit.b1 * r1.direction + hit.b2 * r2.direction;
    // Opposite vectors may cancel; nothing can be interpolated there.
    if (direction == vec3(0.0)) direction = wi;
    // The directions of a face form a convex cone: if all vertices are in it, so is the polygon. A polygon that
    // straddles faces is cut along their boundaries, which in unnormalised directions is what the major axis says.
    bool one_face = r0.face == r1.face && r0.face == r2.face;
    uint face = one_face ? r0.face : cube_face(direction);
    ReflectorInfo reflector = reflectors[instance_reflectors[surface.instance]];
    uint stride = MAP_SIZE + 2u * MAP_BORDER;
    return sample_map(reflector.first_texel + face * stride * stride, cube_face_position(direction, face));
}

#include "kernels/film_main.glsl"

#include "kernels/map_main.glsl"

void main() {
    render_pixel();
}
