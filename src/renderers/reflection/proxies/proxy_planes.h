// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/reflection/proxies/surroundings.h"

#include "geometry/convex_region.h"

#include <vector>

namespace utsuri {

/// Mean of |log(distance to the planes / distance to the scene)| over the directions in which something is
/// met; 0 where nothing is.
/// @param planes about the capture point; they enclose it
double mean_misfit(const std::vector<SurroundingsSample>& samples, const std::vector<HalfSpace>& planes);

/// Planes of what the capture point sees that together have the least misfit found: from the bounds of the
/// scene on, the plane that lowers it most is added, then the next, until another one hardly tells. All
/// places that rays start from are inside.
/// @returns planes about the capture point that enclose it
std::vector<HalfSpace> fit_proxy_planes(const SceneData& scene, const Surroundings& around);

}  // namespace utsuri
