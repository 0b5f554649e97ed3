// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/reflection/proxies/surroundings.h"

#include "geometry/bounds.h"

namespace utsuri {

/// The box, along the axes of the world, that stands in best for what surrounds a reflector: the one with the
/// least mean of |log(distance to the box / distance to the scene)| over directions from the capture point.
/// It holds that point and all places that rays start from. Where nothing surrounds it, the bounds of the
/// scene.
Bounds fit_proxy_box(const Surroundings& around);

}  // namespace utsuri
