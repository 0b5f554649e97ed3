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
INTEROP_CONSTANT BINDING_LIGHT_MESH_POINTS = 14u;
INTEROP_CONSTANT BINDING_LIGHT_BOUNDS = 15u;
INTEROP_CONSTANT BINDING_CHANGED_BOXES = 16u;
INTEROP_CONSTANT BINDING_LIGHT_PLACES = 17u;  ///< of points to simulate light at
INTEROP_CONSTANT BINDING_FIRST_LIGHT_PIECES = 18u;
INTEROP_CONSTANT BINDING_LIGHT_PIECES = 19u;  ///< radiance of parts of textured lights: light_pieces.h

// Reflection maps and the points that they are captured from.
INTEROP_CONSTANT BINDING_PROBES = 20u;
INTEROP_CONSTANT BINDING_PROBE_RANGES = 21u;  ///< ProbeRange of each reflector
INTEROP_CONSTANT BINDING_MAP_FACES = 22u;     ///< a uniform block
INTEROP_CONSTANT BINDING_MAP_TEXELS = 23u;
INTEROP_CONSTANT BINDING_MAP_STATES = 24u;    ///< how many maps are wanted, then the MAP_ state of each
INTEROP_CONSTANT BINDING_PROXY_PLANES = 25u;  ///< of reflectors, then of glossy instances

// Distances and radiance about capture points.
INTEROP_CONSTANT BINDING_DISTANCE_MAPS = 26u;  ///< DistanceMapInfo of each probe
INTEROP_CONSTANT BINDING_DISTANCE_SAMPLES = 27u;
INTEROP_CONSTANT BINDING_DISTANCE_BOUNDS = 28u;
INTEROP_CONSTANT BINDING_SELF_HORIZONS = 29u;     ///< sines, of each triangle: self_horizon.h
INTEROP_CONSTANT BINDING_RADIANCE_SAMPLES = 30u;  ///< of one face about a capture point
INTEROP_CONSTANT BINDING_DARKEST = 31u;  ///< of each block of directions, numbered as distance bounds
INTEROP_CONSTANT BINDING_BRIGHTEST = 32u;

// Maps of glossy lobes.
INTEROP_CONSTANT BINDING_GLOSSY_MAPS = 33u;    ///< GlossyMapInfo of each instance of the scene
INTEROP_CONSTANT BINDING_GLOSSY_PROBES = 34u;  ///< GlossyProbe of each instance, one after the other
INTEROP_CONSTANT BINDING_GLOSSY_LEVELS = 35u;
INTEROP_CONSTANT BINDING_GLOSSY_TEXELS = 36u;
INTEROP_CONSTANT BINDING_GLOSSY_INVERSE_DISTANCES = 37u;  ///< of each texel of glossy maps
INTEROP_CONSTANT BINDING_MAP_INVERSE_DISTANCES = 38u;     ///< of each texel of what glossy maps are made of
INTEROP_CONSTANT BINDING_LOBE_ALBEDO = 39u;

// Polygons of reflectors.
INTEROP_CONSTANT BINDING_REFLECTOR_TRIANGLES = 40u;
INTEROP_CONSTANT BINDING_REFLECTOR_VERTICES = 41u;
INTEROP_CONSTANT BINDING_VERTEX_REFLECTIONS = 42u;
INTEROP_CONSTANT BINDING_SUMMED_COUNTS = 43u;   ///< what the prefix sum works on
INTEROP_CONSTANT BINDING_STRADDLING = 44u;      ///< polygons that straddle faces before each, and in all
INTEROP_CONSTANT BINDING_DRAWN_POLYGONS = 45u;  ///< those drawn whole: that straddle faces, or all
INTEROP_CONSTANT BINDING_CUT_COUNTS = 46u;      ///< pieces of the straddlers before each, and in all
INTEROP_CONSTANT BINDING_WHOLE_PIECES = 47u;
INTEROP_CONSTANT BINDING_CUT_PIECES = 48u;
INTEROP_CONSTANT BINDING_CUT_CORNERS = 49u;
INTEROP_CONSTANT BINDING_DRAW_ARGUMENTS = 50u;  ///< of whole pieces, of cut pieces, of polygons drawn whole

// Drawing.
INTEROP_CONSTANT BINDING_FRAME = 51u;              ///< a uniform block
INTEROP_CONSTANT BINDING_DRAW_LIST = 52u;          ///< triangles in the order they are drawn in
INTEROP_CONSTANT BINDING_LISTED_REFLECTORS = 53u;  ///< of the triangles of the draw list that are curved
INTEROP_CONSTANT BINDING_DRAWN = 54u;              ///< a drawn picture, a vec4 a pixel
INTEROP_CONSTANT BINDING_THROUGHPUT = 55u;  ///< of the mirrors that a pixel shows so far, a vec4 a pixel

INTEROP_CONSTANT BINDING_COUNT = 56u;

INTEROP_END
#endif
