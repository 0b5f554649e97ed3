// SPDX-License-Identifier: Apache-2.0
// Reflections that a fragment leaves to trace_deferred.comp: rays are followed by kernels, where those of all pixels that
// need some fill the subgroups, whatever triangles they show.
#ifndef UTSURI_KERNELS_HYBRID_DEFERRED_REFLECTION
#define UTSURI_KERNELS_HYBRID_DEFERRED_REFLECTION

#include "kernels/raster/drawn_surface.glsl"
#include "kernels/raster/view.glsl"

/// A DeferredReflection: none, or the one that the fragment leaves. Its main() writes it out.
uvec4 deferred = uvec4(0u);

/// @param kind DEFERRED_LOBE, DEFERRED_MIRROR or DEFERRED_PLANE_MIRROR
/// @param chances how likely it is that the reflection is followed, of DEFERRED_CHANCES, > 0
void defer_reflection(uint kind, uint chances) {
    uint request = kind | (chances - 1u) << DEFERRED_CHANCE_SHIFT | (view.number - VIEW_OF_EYE) << DEFERRED_VIEW_SHIFT;
    deferred = uvec4(drawn_ids.x, floatBitsToUint(drawn_place.xy), request);
}

/// What a mirror shows is followed in every sample.
void defer_mirror(uint kind) {
    defer_reflection(kind, DEFERRED_CHANCES);
}

#endif
