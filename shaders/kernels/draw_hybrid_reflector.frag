// SPDX-License-Identifier: Apache-2.0
// A reflector whose pixels are looked up in its maps where what they show is predicted to be less pixels off its place than
// the tolerance, and traced elsewhere.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/scene_bindings.glsl"
#include "interop/frame.h"
#include "kernels/view_push.glsl"
#include "kernels/drawn_light.glsl"
#include "kernels/map_lookup.glsl"
#include "kernels/search_bindings.glsl"
#include "kernels/drawn_prediction.glsl"
#include "kernels/look_up_by_place.glsl"
#include "kernels/hybrid_reflector.glsl"
