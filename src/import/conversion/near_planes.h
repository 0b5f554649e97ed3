// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "import/conversion/context.h"

namespace utsuri {

/// Notes cameras whose near plane other programs let cut something out of the picture. Here it cuts nothing.
/// To be called when all instances and cameras are there.
void note_near_planes(ImportContext& context);

}  // namespace utsuri
