// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "interop/lobe_albedo.h"

#include <vector>

namespace utsuri {

/// What a lobe of GGX width `alpha` and a Lambert lobe reflect of a uniform environment towards a viewer at
/// the cosine `mu`, by quadrature in float64, to 5e-4.
interop::LobeAlbedo lobe_albedo(double alpha, double mu);

/// The table that kernels interpolate, LOBE_ALBEDO_SIZE^2 entries.
const std::vector<interop::LobeAlbedo>& lobe_albedo_table();

}  // namespace utsuri
