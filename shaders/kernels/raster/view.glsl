// SPDX-License-Identifier: Apache-2.0
// What is drawn: a view of the scene, the eye's or that of an eye mirrored in plane mirrors. What is the same for all draws
// of a frame is a uniform block; what changes from view to view is pushed.
#ifndef UTSURI_KERNELS_RASTER_VIEW
#define UTSURI_KERNELS_RASTER_VIEW

#extension GL_EXT_scalar_block_layout : require

#include "interop/bindings.h"
#include "interop/raster.h"

layout(scalar, set = METHOD_SET, binding = BINDING_FRAME) uniform Frame { FrameInfo frame; };

layout(push_constant, scalar) uniform Push { ViewPush view; };

#endif
