// SPDX-License-Identifier: Apache-2.0
// Sine and cosine of our own: Vulkan allows the built-in ones an error of 2^-11.
#ifndef UTSURI_LIB_TRIGONOMETRY
#define UTSURI_LIB_TRIGONOMETRY

/// (cos, sin) of 2 pi u for u in [0, 1], with an absolute error under 2e-7. The circle is cut into quarters centred on
/// the axes; within one, Taylor polynomials about the axis serve |angle| <= pi/4.
vec2 cos_sin_of_turn(float u) {
    float quarters = u * 4.0;
    float quarter = floor(quarters + 0.5);
    float angle = (quarters - quarter) * 1.57079632679489662;
    float a2 = angle * angle;
    float s = angle * (1.0 + a2 * (-1.0 / 6.0 + a2 * (1.0 / 120.0 + a2 * (-1.0 / 5040.0 + a2 * (1.0 / 362880.0)))));
    float c = 1.0 + a2 * (-0.5 + a2 * (1.0 / 24.0 + a2 * (-1.0 / 720.0 + a2 * (1.0 / 40320.0))));
    uint turn = uint(quarter) & 3u;
    vec2 rotated = (turn & 1u) == 0u ? vec2(c, s) : vec2(-s, c);
    return turn < 2u ? rotated : -rotated;
}

#endif
