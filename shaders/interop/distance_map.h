// SPDX-License-Identifier: Apache-2.0
// Distances from the capture point of each reflector to what surrounds it: a cube of texels, and bounds on
// the distances over ever larger blocks of them.
#ifndef UTSURI_INTEROP_DISTANCE_MAP_H
#define UTSURI_INTEROP_DISTANCE_MAP_H
#include "interop/prelude.h"
INTEROP_BEGIN

/// Faces in the order of CUBE_FACES.
INTEROP_CONSTANT DISTANCE_FACES = 6u;
/// Texels around a face that hold what its neighbours see.
INTEROP_CONSTANT DISTANCE_BORDER = 1u;

/// What rays from the capture point meet, in metres: infinity where they meet nothing; 0 where what they meet
/// lies behind the plane of a plane mirror, which can never show it; negative where they meet a mirror or,
/// where distances are to tell of radiance, a glossy lobe: what depends on from where it is seen.
struct DistanceSample {
    float centre;  ///< through the centre of the texel
    float corner;  ///< through its corner of least coordinates
    /// Bound on how far one over the depth out of the face, interpolated between the centres about this one,
    /// is off what is there: the second differences and what the corners are off. A step takes that, a crease
    /// a quarter, a plane nothing.
    float bend;
};

/// Over a block of 2^level by 2^level texels and what lies around them to a texel.
struct DistanceBounds {
    float nearest;  ///< infinity where nothing is met
    /// Infinity where nothing is met, or nothing that can be mirrored. Negative where a mirror is among what
    /// is met: what that shows there is not what it shows elsewhere.
    float farthest;
};

/// Of one reflector.
struct DistanceMapInfo {
    uint first_sample;
    uint first_bounds;
    vec3 plane_normal;     ///< unit, towards what a plane mirror shows; zero for other reflectors
    float plane_distance;  ///< points of the plane: dot(plane_normal, point) = plane_distance
};

/// What is measured about a capture point.
struct MeasuredView {
    vec3 capture_point;
    uint excluded_instance;  ///< the reflector
    vec3 plane_normal;       ///< as in DistanceMapInfo
    float plane_distance;
};

/// Push constants of what measures distances or radiance.
struct MeasureFacePush {
    MeasuredView view;
    uint face;
    uint first_sample;  ///< of the face, where they are stored
    uint begin;         ///< samples of this dispatch: [begin, end) of the face
    uint end;
};

struct BoundDistancesPush {
    uint first_source;  ///< samples, or bounds of the level below
    uint first_bounds;  ///< of this level
    uint size;          ///< texels along an edge of this level
};

INTEROP_END
#endif
