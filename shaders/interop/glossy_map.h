// SPDX-License-Identifier: Apache-2.0
// What glossy lobes reflect: cubes of maps, each convolved with the lobe of one roughness.
#ifndef UTSURI_INTEROP_GLOSSY_MAP_H
#define UTSURI_INTEROP_GLOSSY_MAP_H
#include "interop/proxy.h"
INTEROP_BEGIN

/// Faces in the order of CUBE_FACES.
INTEROP_CONSTANT GLOSSY_MAP_FACES = 6u;
/// Texels around a face that hold what its neighbours hold, so that filtering needs no neighbour.
INTEROP_CONSTANT GLOSSY_MAP_BORDER = 1u;

/// The maps of one instance of the scene: levels at even steps of perceptual roughness.
struct GlossyMapInfo {
    uint first_probe;
    uint probes;
    uint levels;            ///< of each probe; 0 where no lobe is rough
    float least_roughness;  ///< of the first level
    float steps_per_unit;   ///< levels per unit of roughness
    float blend_width;  ///< metres by which lobes pass a probe farther than the nearest that no longer counts
};

/// A point that maps of an instance are captured from.
struct GlossyProbe {
    vec3 capture_point;
    ProxyInfo proxy;
    uint first_level;
};

struct GlossyLevel {
    uint first_texel;
    uint size;  ///< texels along an edge of a face, border not counted
};

/// One ray through the centre of each texel of what glossy maps are made of.
struct MeasureInverseDistancesPush {
    vec3 capture_point;
    uint excluded_instance;
    uint size;   ///< texels along an edge of a face
    uint begin;  ///< texels of this dispatch: [begin, end) of all faces
    uint end;
};

struct HalveMapPush {
    uint first_source;  ///< texels of the finer level, all faces
    uint first_texel;   ///< of the coarser level
    uint size;          ///< of the coarser level
    uint begin;         ///< texels of this dispatch: [begin, end) of all faces of the coarser level
    uint end;
};

struct PrefilterMapPush {
    uint source_size;  ///< of the finest source level, a power of two
    uint size;         ///< of the level made
    uint first_texel;
    float alpha;  ///< GGX width
    uint begin;   ///< texels of this dispatch: [begin, end) of all faces of the level made, borders included
    uint end;
};

INTEROP_END
#endif
