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
INTEROP_CONSTANT BINDING_LIGHT_TABLE = 7u;
INTEROP_CONSTANT BINDING_TEXTURE_HEADERS = 8u;
INTEROP_CONSTANT BINDING_TEXELS = 9u;

// Films, first hits, and lists of rays, for tests and benchmarks.
INTEROP_CONSTANT BINDING_FILM = 10u;
INTEROP_CONSTANT BINDING_COUNTERS = 11u;
INTEROP_CONSTANT BINDING_AOV = 12u;
INTEROP_CONSTANT BINDING_RAYS = 13u;
INTEROP_CONSTANT BINDING_HITS = 14u;

// Light kept on surfaces.
INTEROP_CONSTANT BINDING_LIGHT_CACHE_TRIANGLES = 15u;
INTEROP_CONSTANT BINDING_LIGHT_CACHE_POINTS = 16u;
INTEROP_CONSTANT BINDING_LIGHT_BOUNDS = 17u;
INTEROP_CONSTANT BINDING_CHANGED_BOXES = 18u;

// Reflection maps and the points that they are captured from.
INTEROP_CONSTANT BINDING_PROBES = 19u;
INTEROP_CONSTANT BINDING_PROBE_RANGES = 20u;  ///< ProbeRange of each reflector
INTEROP_CONSTANT BINDING_MAP_FACES = 21u;     ///< a uniform block
INTEROP_CONSTANT BINDING_MAP_TEXELS = 22u;
INTEROP_CONSTANT BINDING_MAP_STATES = 23u;    ///< how many maps are wanted, then the MAP_ state of each
INTEROP_CONSTANT BINDING_PROXY_PLANES = 24u;  ///< of reflectors, then of glossy instances

// Distances and radiance about capture points.
INTEROP_CONSTANT BINDING_DISTANCE_MAPS = 25u;  ///< DistanceMapInfo of each probe
INTEROP_CONSTANT BINDING_DISTANCE_SAMPLES = 26u;
INTEROP_CONSTANT BINDING_DISTANCE_BOUNDS = 27u;
INTEROP_CONSTANT BINDING_SELF_HORIZONS = 28u;     ///< sines, of each triangle: self_horizon.h
INTEROP_CONSTANT BINDING_RADIANCE_SAMPLES = 29u;  ///< of one face about a capture point
INTEROP_CONSTANT BINDING_DARKEST = 30u;  ///< of each block of directions, numbered as distance bounds
INTEROP_CONSTANT BINDING_BRIGHTEST = 31u;

// Maps of glossy lobes.
INTEROP_CONSTANT BINDING_GLOSSY_MAPS = 32u;    ///< GlossyMapInfo of each instance of the scene
INTEROP_CONSTANT BINDING_GLOSSY_PROBES = 33u;  ///< GlossyProbe of each instance, one after the other
INTEROP_CONSTANT BINDING_GLOSSY_LEVELS = 34u;
INTEROP_CONSTANT BINDING_GLOSSY_TEXELS = 35u;
INTEROP_CONSTANT BINDING_GLOSSY_INVERSE_DISTANCES = 36u;  ///< of each texel of glossy maps
INTEROP_CONSTANT BINDING_MAP_INVERSE_DISTANCES = 37u;     ///< of each texel of what glossy maps are made of
INTEROP_CONSTANT BINDING_LOBE_ALBEDO = 38u;

// Polygons of reflectors.
INTEROP_CONSTANT BINDING_REFLECTOR_TRIANGLES = 39u;
INTEROP_CONSTANT BINDING_REFLECTOR_VERTICES = 40u;
INTEROP_CONSTANT BINDING_VERTEX_REFLECTIONS = 41u;
INTEROP_CONSTANT BINDING_SUMMED_COUNTS = 42u;   ///< what the prefix sum works on
INTEROP_CONSTANT BINDING_STRADDLING = 43u;      ///< polygons that straddle faces before each, and in all
INTEROP_CONSTANT BINDING_DRAWN_POLYGONS = 44u;  ///< those drawn whole: that straddle faces, or all
INTEROP_CONSTANT BINDING_CUT_COUNTS = 45u;      ///< pieces of the straddlers before each, and in all
INTEROP_CONSTANT BINDING_WHOLE_PIECES = 46u;
INTEROP_CONSTANT BINDING_CUT_PIECES = 47u;
INTEROP_CONSTANT BINDING_CUT_CORNERS = 48u;
INTEROP_CONSTANT BINDING_DRAW_ARGUMENTS = 49u;  ///< of whole pieces, of cut pieces, of polygons drawn whole

// Drawing.
INTEROP_CONSTANT BINDING_FRAME = 50u;              ///< a uniform block
INTEROP_CONSTANT BINDING_DRAW_LIST = 51u;          ///< triangles in the order they are drawn in
INTEROP_CONSTANT BINDING_LISTED_REFLECTORS = 52u;  ///< of the triangles of the draw list that are curved
INTEROP_CONSTANT BINDING_DRAWN = 53u;              ///< a drawn picture, a vec4 a pixel
INTEROP_CONSTANT BINDING_THROUGHPUT = 54u;  ///< of the mirrors that a pixel shows so far, a vec4 a pixel

INTEROP_CONSTANT BINDING_COUNT = 55u;

INTEROP_END
#endif
