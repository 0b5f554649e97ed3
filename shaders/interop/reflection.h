// SPDX-License-Identifier: Apache-2.0
// Reflection maps: a polyhedron of maps captured from one point in world space for each reflective instance.
#ifndef UTSURI_INTEROP_REFLECTION_H
#define UTSURI_INTEROP_REFLECTION_H
#include "interop/proxy.h"
INTEROP_BEGIN

/// Faces of a polyhedron of maps, at most: each costs its share of a piece's corners. An icosahedron has 20.
INTEROP_CONSTANT MAP_MOST_FACES = 32u;
/// Faces of the cube in the order +x, -x, +y, -y, +z, -z.
INTEROP_CONSTANT CUBE_FACES = 6u;
/// Texels around a map that repeat what its neighbours see, so that filtering needs no neighbour.
INTEROP_CONSTANT MAP_BORDER = 1u;

/// How a drawn reflector addresses its maps.
/// By interpolated reflection vectors, the face found per pixel.
INTEROP_CONSTANT MAP_KIND_POLYGON = 0u;
/// By texture coordinates of one OpenGL sphere map in eye space, interpolated.
INTEROP_CONSTANT MAP_KIND_SPHERE = 1u;
/// By homogeneous coordinates on the face that a whole piece of a polygon points at, interpolated.
INTEROP_CONSTANT MAP_KIND_PIECES = 2u;

/// By the mirrored direction at each pixel, as if what is mirrored were infinitely far.
INTEROP_CONSTANT MAP_KIND_CUBE = 3u;
/// By the direction from the capture point to where the mirrored ray leaves what stands in for the
/// surroundings.
INTEROP_CONSTANT MAP_KIND_PROXY = 4u;

/// By the direction from the capture point to where the mirrored ray meets the distances kept about that
/// point.
INTEROP_CONSTANT MAP_KIND_DISTANCE = 5u;

/// A face of a convex polyhedron about the capture point. A direction d points at the face where dot(outward,
/// d) is largest, and there at the picture position (dot(right, d), dot(up, d)) / dot(outward, d) in [-1,
/// 1]^2.
struct MapFace {
    vec3 outward;  ///< unit normal over the face's distance
    vec3 right;
    vec3 up;
    float half_diagonal;  ///< of the picture, where the face is
};

/// What is known of a map.
INTEROP_CONSTANT MAP_EMPTY = 0u;
INTEROP_CONSTANT MAP_WANTED = 1u;  ///< a pixel looked it up, and it is not there yet
INTEROP_CONSTANT MAP_CAPTURED = 2u;

struct ProbeInfo {
    vec3 capture_point;
    uint first_texel;  ///< of this probe's maps, in texels
    uint map_size;     ///< texels along an edge of its maps, border not counted
    ProxyInfo proxy;
    vec3 map_right;  ///< unit axes that a sphere map was captured along
    vec3 map_up;
    vec3 map_forward;
};

/// The capture points of one reflector among all: [first, first + count).
struct ProbeRange {
    uint first;
    uint count;
};

/// A vertex of a reflector's polygons, in scene space.
struct ReflectorVertex {
    vec3 position;
    vec3 normal;
};

/// A polygon of a reflector: a triangle of the scene or a part of one.
struct ReflectorTriangle {
    uvec3 vertices;
    uint triangle;   ///< of the scene
    vec2 places[3];  ///< barycentric coordinates b1, b2 of the corners on that
    uint reflector;
};

/// What the per-vertex pass finds for one frame.
struct VertexReflection {
    vec3 direction;   ///< reflected (vertex - eye), not normalised
    vec2 sphere_map;  ///< texture coordinate of the OpenGL sphere map
};

struct ReflectVerticesPush {
    vec3 eye;
    vec3 right;  ///< unit axes of the eye
    vec3 up;
    vec3 forward;
    uint begin;  ///< vertices of this dispatch: [begin, end)
    uint end;
};

/// A polygon that lies within one face, or a triangle of one that was cut along the faces.
struct Piece {
    uint polygon;  ///< which ReflectorTriangle
    uint face;
};

/// A corner of a cut piece, three to a piece.
struct PieceCorner {
    vec3 position;    ///< scene space
    vec3 reflection;  ///< not normalised
    vec2 place;       ///< barycentric coordinates b1, b2 on the triangle of the scene
};

struct PrefixSumPush {
    uint count;
};

struct ClipPush {
    uint polygons;
    uint faces;     ///< of the polyhedron
    uint most_cut;  ///< cut pieces that there is room for
    uint begin;     ///< polygons of this dispatch: [begin, end)
    uint end;
};

/// What an indirect draw reads: VkDrawIndirectCommand.
struct DrawArguments {
    uint vertex_count;
    uint instance_count;
    uint first_vertex;
    uint first_instance;
};

struct ResolveMapPush {
    uint texels;       ///< of one map, border included
    uint first_texel;  ///< where they go
    uint samples;      ///< that the film holds
};

INTEROP_END
#endif
