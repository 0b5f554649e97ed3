// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "import/conversion/context.h"
#include "import/conversion/nodes.h"

namespace utsuri {

/// Adds the light of KHR_lights_punctual that a node carries, if it carries one. Position and direction (-Z
/// of the node) are transformed; intensity, range and cone angles are not, as the extension says.
/// @throws InputError if the cone angles are out of order or the intensity is beyond float32.
void import_light(ImportContext& context, const PlacedNode& placed);

/// Gives a scene without any light a uniform environment, and says so.
void add_default_light(ImportContext& context);

}  // namespace utsuri
