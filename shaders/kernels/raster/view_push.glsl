// SPDX-License-Identifier: Apache-2.0
// What kernels that draw one view are told.
#include "interop/raster.h"

layout(push_constant, scalar) uniform Push { RasterPush push; };
