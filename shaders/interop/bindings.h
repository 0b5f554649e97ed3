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
INTEROP_CONSTANT BINDING_LIGHT_TREE = 8u;

// Films, first hits, and lists of rays, for tests and benchmarks.
INTEROP_CONSTANT BINDING_FILM = 9u;
INTEROP_CONSTANT BINDING_COUNTERS = 10u;
INTEROP_CONSTANT BINDING_AOV = 11u;
INTEROP_CONSTANT BINDING_RAYS = 12u;
INTEROP_CONSTANT BINDING_HITS = 13u;

// Light kept on surfaces.
INTEROP_CONSTANT BINDING_LIGHT_MESH_NODES = 14u;
INTEROP_CONSTANT BINDING_LIGHT_MESH_LEAVES = 15u;
INTEROP_CONSTANT BINDING_LIGHT_MESH_POINTS = 16u;
INTEROP_CONSTANT BINDING_LIGHT_BOUNDS = 17u;
INTEROP_CONSTANT BINDING_CHANGED_BOXES = 18u;
INTEROP_CONSTANT BINDING_LIGHT_PLACES = 19u;  ///< of points to simulate light at
INTEROP_CONSTANT BINDING_LIGHT_PIECES = 20u;  ///< radiance of parts of textured lights: light_pieces.h
INTEROP_CONSTANT BINDING_SUMMED_LIGHTS = 21u;
INTEROP_CONSTANT BINDING_LIGHT_GROUPS = 22u;

// Reflection maps and the points that they are captured from.
INTEROP_CONSTANT BINDING_PROBES = 23u;
INTEROP_CONSTANT BINDING_PROBE_RANGES = 24u;  ///< ProbeRange of each reflector
INTEROP_CONSTANT BINDING_MAP_FACES = 25u;     ///< a uniform block
INTEROP_CONSTANT BINDING_MAP_TEXELS = 26u;
INTEROP_CONSTANT BINDING_MAP_STATES = 27u;    ///< how many maps are wanted, then the MAP_ state of each
INTEROP_CONSTANT BINDING_PROXY_PLANES = 28u;  ///< of reflectors, then of glossy instances

// Distances and radiance about capture points.
INTEROP_CONSTANT BINDING_DISTANCE_MAPS = 29u;  ///< DistanceMapInfo of each probe
INTEROP_CONSTANT BINDING_DISTANCE_SAMPLES = 30u;
INTEROP_CONSTANT BINDING_DISTANCE_BOUNDS = 31u;
INTEROP_CONSTANT BINDING_SELF_HORIZONS = 32u;     ///< sines, of each triangle: self_horizon.h
INTEROP_CONSTANT BINDING_RADIANCE_SAMPLES = 33u;  ///< of one face about a capture point
INTEROP_CONSTANT BINDING_DARKEST = 34u;  ///< of each block of directions, numbered as distance bounds
INTEROP_CONSTANT BINDING_BRIGHTEST = 35u;

// Maps of glossy lobes.
INTEROP_CONSTANT BINDING_GLOSSY_MAPS = 36u;    ///< GlossyMapInfo of each instance of the scene
INTEROP_CONSTANT BINDING_GLOSSY_PROBES = 37u;  ///< GlossyProbe of each instance, one after the other
INTEROP_CONSTANT BINDING_GLOSSY_LEVELS = 38u;
INTEROP_CONSTANT BINDING_GLOSSY_TEXELS = 39u;
INTEROP_CONSTANT BINDING_GLOSSY_INVERSE_DISTANCES = 40u;  ///< of each texel of glossy maps
INTEROP_CONSTANT BINDING_MAP_INVERSE_DISTANCES = 41u;     ///< of each texel of what glossy maps are made of
INTEROP_CONSTANT BINDING_LOBE_ALBEDO = 42u;

// Polygons of reflectors.
INTEROP_CONSTANT BINDING_REFLECTOR_TRIANGLES = 43u;
INTEROP_CONSTANT BINDING_REFLECTOR_VERTICES = 44u;
INTEROP_CONSTANT BINDING_VERTEX_REFLECTIONS = 45u;
INTEROP_CONSTANT BINDING_SUMMED_COUNTS = 46u;   ///< what the prefix sum works on
INTEROP_CONSTANT BINDING_STRADDLING = 47u;      ///< polygons that straddle faces before each, and in all
INTEROP_CONSTANT BINDING_DRAWN_POLYGONS = 48u;  ///< those drawn whole: that straddle faces, or all
INTEROP_CONSTANT BINDING_CUT_COUNTS = 49u;      ///< pieces of the straddlers before each, and in all
INTEROP_CONSTANT BINDING_WHOLE_PIECES = 50u;
INTEROP_CONSTANT BINDING_CUT_PIECES = 51u;
INTEROP_CONSTANT BINDING_CUT_CORNERS = 52u;
INTEROP_CONSTANT BINDING_DRAW_ARGUMENTS = 53u;  ///< of whole pieces, of cut pieces, of polygons drawn whole

// Drawing.
INTEROP_CONSTANT BINDING_FRAME = 54u;              ///< a uniform block
INTEROP_CONSTANT BINDING_DRAW_LIST = 55u;          ///< triangles in the order they are drawn in
INTEROP_CONSTANT BINDING_LISTED_REFLECTORS = 56u;  ///< of the triangles of the draw list that are curved
INTEROP_CONSTANT BINDING_DRAWN = 57u;              ///< a drawn picture, a vec4 a pixel
INTEROP_CONSTANT BINDING_THROUGHPUT = 58u;  ///< of the mirrors that a pixel shows so far, a vec4 a pixel

INTEROP_CONSTANT BINDING_DEFERRED = 59u;  ///< a DeferredReflection a pixel
INTEROP_CONSTANT BINDING_DEFERRED_VIEWS = 60u;
INTEROP_CONSTANT BINDING_DEFERRED_COUNT = 61u;
INTEROP_CONSTANT BINDING_DEFERRED_PIXELS = 62u;  ///< numbers of those with a deferred reflection

INTEROP_CONSTANT BINDING_COUNT = 63u;

INTEROP_END
#endif
