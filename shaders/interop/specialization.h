// SPDX-License-Identifier: Apache-2.0
// Specialization constant ids: what a kernel can be told about the scene before it is compiled.
#ifndef UTSURI_INTEROP_SPECIALIZATION_H
#define UTSURI_INTEROP_SPECIALIZATION_H
#include "interop/prelude.h"
INTEROP_BEGIN

INTEROP_CONSTANT SPEC_STACK_SIZE = 0u;  ///< entries of the traversal stack, no fewer than the BVH is deep
INTEROP_CONSTANT SPEC_HAS_TEXTURES = 1u;
INTEROP_CONSTANT SPEC_HAS_TRIANGLE_LIGHTS = 2u;
INTEROP_CONSTANT SPEC_HAS_PUNCTUAL_LIGHTS = 3u;
INTEROP_CONSTANT SPEC_ENVIRONMENT_LIGHT = 4u;  ///< index of the environment among the lights, or NONE
INTEROP_CONSTANT SPEC_HAS_GLOSSY = 5u;         ///< some surface has a glossy specular lobe
INTEROP_CONSTANT SPEC_HAS_MIRROR = 6u;         ///< some surface is a perfect mirror or a smooth dielectric
INTEROP_CONSTANT SPEC_PROJECTION = 7u;
INTEROP_CONSTANT SPEC_EXCLUDES_INSTANCE = 8u;  ///< FramePush::excluded_instance is honoured
INTEROP_CONSTANT SPEC_MARKS_GLOSSY = 9u;       ///< distances are negative at glossy lobes too
INTEROP_CONSTANT SPEC_ANY_HIT = 10u;           ///< the ray list kernel asks whether, not where
INTEROP_CONSTANT SPEC_LIGHT_COUNT = 11u;       ///< MOST_TOLD_LIGHTS where there are more
INTEROP_CONSTANT SPEC_MAP_KIND = 12u;          ///< MAP_KIND_ of interop/reflection.h
INTEROP_CONSTANT SPEC_SUMS_LIGHTS = 13u;       ///< unshadowed light is summed over all lights in closed form
INTEROP_CONSTANT SPEC_FACE_COUNT = 14u;        ///< of the polyhedron of maps, at most MAP_MOST_FACES
INTEROP_CONSTANT SPEC_WRITES = 15u;  ///< the second run of a kernel that first counts what it will write
INTEROP_CONSTANT SPEC_DISTANCE_SIZE = 16u;  ///< texels along an edge of a face of distances, a power of two
INTEROP_CONSTANT SPEC_HAS_PROXY_PLANES = 17u;    ///< not all proxies are boxes
INTEROP_CONSTANT SPEC_MOST_PROBES = 18u;         ///< capture points that a reflector has, at most
INTEROP_CONSTANT SPEC_KEEPS_DISTANCES = 19u;     ///< glossy maps are made with inverse distances
INTEROP_CONSTANT SPEC_MOST_GLOSSY_PROBES = 20u;  ///< capture points that a glossy instance has, at most
INTEROP_CONSTANT SPEC_HAS_LAYERS = 21u;          ///< some surfaces overlap in one plane
INTEROP_CONSTANT SPEC_INFINITE_LIGHTS = 22u;     ///< lights that are nowhere, the first of all
INTEROP_CONSTANT SPEC_COUNT = 23u;

INTEROP_CONSTANT MOST_TOLD_LIGHTS = 8u;

INTEROP_END
#endif
