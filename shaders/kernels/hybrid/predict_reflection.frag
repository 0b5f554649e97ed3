// SPDX-License-Identifier: Apache-2.0
// How wrong the look-up of a reflector can be, instead of what it shows: parallax, interpolation and texel in radians, and
// all of them in pixels.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/hybrid/drawn_prediction.glsl"
#include "kernels/raster/shown_surface.glsl"

void main() {
    vec3 wo = -normalize_any_scale(drawn_from_eye);
    Surface surface = drawn_surface();
    if (!is_mirror(surface)) {
        drawn = vec4(-1.0);
        return;
    }
    DrawnReflection reflection = lookup_of(surface, wo);
    vec3 wanted = wanted_direction_of(surface, reflection);
    vec3 looked_up = looked_up_direction_of(surface, reflection, wanted);
    Prediction prediction = predict(reflection.ray, reflection.interval, reflection.footprint, wanted, looked_up,
                                    texel_angle(reflection.probe, looked_up));
    drawn = vec4(prediction.parallax, prediction.interpolation, prediction.texel, prediction.pixels);
}
