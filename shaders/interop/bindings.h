// SPDX-License-Identifier: Apache-2.0
// Binding numbers. One number means one thing in every kernel, whichever of the two descriptor sets it is in.
#ifndef UTSURI_INTEROP_BINDINGS_H
#define UTSURI_INTEROP_BINDINGS_H
#include "interop/prelude.h"
INTEROP_BEGIN

/// Descriptor sets: the scene, which all methods share, and what a method adds.
INTEROP_CONSTANT SCENE_SET = 0u;
INTEROP_CONSTANT METHOD_SET = 1u;

// The scene, in SCENE_SET.
INTEROP_CONSTANT BINDING_BVH_NODES = 0u;
INTEROP_CONSTANT BINDING_BVH_TRIANGLES = 1u;
INTEROP_CONSTANT BINDING_TRIANGLE_INFOS = 2u;
INTEROP_CONSTANT BINDING_NORMALS = 3u;
INTEROP_CONSTANT BINDING_TEXCOORDS = 4u;
INTEROP_CONSTANT BINDING_MATERIALS = 5u;
INTEROP_CONSTANT BINDING_LIGHTS = 6u;
INTEROP_CONSTANT BINDING_TEXELS = 7u;

// Films, first hits, and lists of rays, for tests and benchmarks.
INTEROP_CONSTANT BINDING_FILM = 8u;
INTEROP_CONSTANT BINDING_COUNTERS = 9u;
INTEROP_CONSTANT BINDING_AOV = 10u;
INTEROP_CONSTANT BINDING_RAYS = 11u;
INTEROP_CONSTANT BINDING_HITS = 12u;

// Light kept on surfaces.
INTEROP_CONSTANT BINDING_LIGHT_MESH_NODES = 13u;
INTEROP_CONSTANT BINDING_LIGHT_MESH_LEAVES = 14u;
INTEROP_CONSTANT BINDING_LIGHT_MESH_POINTS = 15u;
INTEROP_CONSTANT BINDING_LIGHT_BOUNDS = 16u;
INTEROP_CONSTANT BINDING_CHANGED_BOXES = 17u;
INTEROP_CONSTANT BINDING_LIGHT_PLACES = 18u;  ///< of points to simulate light at
INTEROP_CONSTANT BINDING_FIRST_LIGHT_PIECES = 19u;
INTEROP_CONSTANT BINDING_LIGHT_PIECES = 20u;  ///< radiance of parts of textured lights: light_pieces.h

// Reflection maps and the points that they are captured from.
INTEROP_CONSTANT BINDING_PROBES = 21u;
INTEROP_CONSTANT BINDING_PROBE_RANGES = 22u;  ///< ProbeRange of each reflector
INTEROP_CONSTANT BINDING_MAP_FACES = 23u;     ///< a uniform block
INTEROP_CONSTANT BINDING_MAP_TEXELS = 24u;
INTEROP_CONSTANT BINDING_MAP_STATES = 25u;    ///< how many maps are wanted, then the MAP_ state of each
INTEROP_CONSTANT BINDING_PROXY_PLANES = 26u;  ///< of reflectors, then of glossy instances

// Distances and radiance about capture points.
INTEROP_CONSTANT BINDING_DISTANCE_MAPS = 27u;  ///< DistanceMapInfo of each probe
INTEROP_CONSTANT BINDING_DISTANCE_SAMPLES = 28u;
INTEROP_CONSTANT BINDING_DISTANCE_BOUNDS = 29u;
INTEROP_CONSTANT BINDING_SELF_HORIZONS = 30u;     ///< sines, of each triangle: self_horizon.h
INTEROP_CONSTANT BINDING_RADIANCE_SAMPLES = 31u;  ///< of one face about a capture point
INTEROP_CONSTANT BINDING_DARKEST = 32u;  ///< of each block of directions, numbered as distance bounds
INTEROP_CONSTANT BINDING_BRIGHTEST = 33u;

// Maps of glossy lobes.
INTEROP_CONSTANT BINDING_GLOSSY_MAPS = 34u;    ///< GlossyMapInfo of each instance of the scene
INTEROP_CONSTANT BINDING_GLOSSY_PROBES = 35u;  ///< GlossyProbe of each instance, one after the other
INTEROP_CONSTANT BINDING_GLOSSY_LEVELS = 36u;
INTEROP_CONSTANT BINDING_GLOSSY_TEXELS = 37u;
INTEROP_CONSTANT BINDING_GLOSSY_INVERSE_DISTANCES = 38u;  ///< of each texel of glossy maps
INTEROP_CONSTANT BINDING_MAP_INVERSE_DISTANCES = 39u;     ///< of each texel of what glossy maps are made of
INTEROP_CONSTANT BINDING_LOBE_ALBEDO = 40u;

// Polygons of reflectors.
INTEROP_CONSTANT BINDING_REFLECTOR_TRIANGLES = 41u;
INTEROP_CONSTANT BINDING_REFLECTOR_VERTICES = 42u;
INTEROP_CONSTANT BINDING_VERTEX_REFLECTIONS = 43u;
INTEROP_CONSTANT BINDING_SUMMED_COUNTS = 44u;   ///< what the prefix sum works on
INTEROP_CONSTANT BINDING_STRADDLING = 45u;      ///< polygons that straddle faces before each, and in all
INTEROP_CONSTANT BINDING_DRAWN_POLYGONS = 46u;  ///< those drawn whole: that straddle faces, or all
INTEROP_CONSTANT BINDING_CUT_COUNTS = 47u;      ///< pieces of the straddlers before each, and in all
INTEROP_CONSTANT BINDING_WHOLE_PIECES = 48u;
INTEROP_CONSTANT BINDING_CUT_PIECES = 49u;
INTEROP_CONSTANT BINDING_CUT_CORNERS = 50u;
INTEROP_CONSTANT BINDING_DRAW_ARGUMENTS = 51u;  ///< of whole pieces, of cut pieces, of polygons drawn whole

// Drawing.
INTEROP_CONSTANT BINDING_FRAME = 52u;              ///< a uniform block
INTEROP_CONSTANT BINDING_DRAW_LIST = 53u;          ///< triangles in the order they are drawn in
INTEROP_CONSTANT BINDING_LISTED_REFLECTORS = 54u;  ///< of the triangles of the draw list that are curved
INTEROP_CONSTANT BINDING_DRAWN = 55u;              ///< a drawn picture, a vec4 a pixel
INTEROP_CONSTANT BINDING_THROUGHPUT = 56u;  ///< of the mirrors that a pixel shows so far, a vec4 a pixel

INTEROP_CONSTANT BINDING_COUNT = 57u;

INTEROP_END
#endif
