// SPDX-License-Identifier: Apache-2.0
// Shading constants that host and device must agree on.
#ifndef UTSURI_INTEROP_SHADING_H
#define UTSURI_INTEROP_SHADING_H
#include "interop/prelude.h"
INTEROP_BEGIN

/// Perceptual roughness below which a surface reflects like a perfect mirror: GGX alpha = 0.001, a lobe
/// narrower than a tenth of a degree, below which float32 directions no longer resolve it.
INTEROP_FLOAT_CONSTANT SPECULAR_ROUGHNESS = 0.0316227766f;

INTEROP_END
#endif
