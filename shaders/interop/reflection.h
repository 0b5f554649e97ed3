// SPDX-License-Identifier: Apache-2.0
// Reflection maps: a set of maps captured from one point in world space for each reflective instance.
#ifndef UTSURI_INTEROP_REFLECTION_H
#define UTSURI_INTEROP_REFLECTION_H
#include "interop/prelude.h"
INTEROP_BEGIN

/// Faces of the cube in the order +x, -x, +y, -y, +z, -z.
INTEROP_CONSTANT CUBE_FACES = 6u;
/// Texels around a map that repeat what its neighbours see, so that filtering needs no neighbour.
INTEROP_CONSTANT MAP_BORDER = 1u;

/// A polyhedron of maps in world space, addressed by interpolated reflection vectors.
INTEROP_CONSTANT MAP_KIND_POLYGON = 0u;
/// One OpenGL sphere map in eye space, addressed by interpolated texture coordinates.
INTEROP_CONSTANT MAP_KIND_SPHERE = 1u;

struct ReflectorInfo {
    vec3 capture_point;
    uint first_texel;  ///< of this reflector's maps, in texels
};

/// A vertex of a reflective instance, in scene space.
struct ReflectorVertex {
    vec3 position;
    vec3 normal;
};

/// What the per-vertex pass finds for one frame.
struct VertexReflection {
    vec3 direction;   ///< reflected (vertex - eye), not normalised
    uint face;        ///< the cube face that direction points at
    vec2 sphere_map;  ///< texture coordinate of the OpenGL sphere map
};

struct ReflectVerticesPush {
    vec3 eye;
    vec3 right;  ///< unit axes of the eye
    vec3 up;
    vec3 forward;
    uint count;
};

struct ResolveMapPush {
    uint texels;       ///< of one map, border included
    uint first_texel;  ///< where they go
    uint samples;      ///< that the film holds
};

INTEROP_END
#endif
