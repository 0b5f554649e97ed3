// SPDX-License-Identifier: Apache-2.0
// A reflector whose pixels are looked up in its maps where what they show is predicted to be less pixels off its place than
// the tolerance, and traced elsewhere.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/scene/scene_bindings.glsl"
#include "interop/frame.h"
#include "kernels/raster/view_push.glsl"
#include "kernels/raster/drawn_light.glsl"
#include "kernels/maps/map_lookup.glsl"
#include "kernels/distances/search_bindings.glsl"
#include "kernels/hybrid/drawn_prediction.glsl"
#include "kernels/hybrid/look_up_by_place.glsl"
#include "kernels/hybrid/hybrid_reflector.glsl"
