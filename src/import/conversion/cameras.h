// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "import/conversion/context.h"
#include "import/conversion/nodes.h"

namespace utsuri {

/// Adds the perspective camera that a node carries, if it carries one. Scale and shear of the node are
/// dropped.
/// @throws InputError if the field of view is out of its range.
void import_camera(ImportContext& context, const PlacedNode& placed);

/// Gives a scene without a camera one that frames all instances from a three-quarter view, and says so.
void add_default_camera(ImportContext& context);

}  // namespace utsuri
