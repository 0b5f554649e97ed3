// SPDX-License-Identifier: Apache-2.0
#ifndef UTSURI_INTEROP_LOBE_ALBEDO_H
#define UTSURI_INTEROP_LOBE_ALBEDO_H
#include "interop/prelude.h"
INTEROP_BEGIN

/// Entries along an edge of the table of LobeAlbedo: over the square root of the cosine to the viewer and,
/// slower, over perceptual roughness, both from 0 to 1.
INTEROP_CONSTANT LOBE_ALBEDO_SIZE = 32u;

/// What a surface reflects of a uniform environment of radiance 1.
struct LobeAlbedo {
    float constant;  ///< glossy lobe: the factor of the reflectance at normal incidence
    float schlick;   ///< glossy lobe: the factor of the reflectance at grazing incidence
    float lost;      ///< mean of Schlick's weight over the light that a Lambert lobe reflects
};

INTEROP_END
#endif
