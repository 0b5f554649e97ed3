// SPDX-License-Identifier: Apache-2.0
// Where drawn points land in the picture of one view.
#include "kernels/view_push.glsl"
#include "kernels/drawn_projection.glsl"
