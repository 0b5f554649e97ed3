// SPDX-License-Identifier: Apache-2.0
// What kernels that draw one image of the scene are told.
#include "interop/raster.h"

layout(push_constant, scalar) uniform Push {
    RasterPush push;
    ImageInfo image;
};
