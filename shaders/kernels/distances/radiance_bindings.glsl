// SPDX-License-Identifier: Apache-2.0
// Bounds on what the capture points of reflectors see. Comes after search_bindings.glsl.

layout(scalar, binding = BINDING_DARKEST) readonly restrict buffer Darkest { vec3 darkest[]; };
layout(scalar, binding = BINDING_BRIGHTEST) readonly restrict buffer Brightest { vec3 brightest[]; };

#include "lib/radiance_bounds.glsl"
