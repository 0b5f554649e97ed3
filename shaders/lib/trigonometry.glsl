// SPDX-License-Identifier: Apache-2.0
// Sine, cosine and arc tangent of our own: Vulkan allows the built-in ones errors of 2^-11 and 4096 roundings.
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

/// Of an angle in [0, 2 pi], with an absolute error under 2e-7; in [0, pi/4] it is relative.
float sin_of(float angle) {
    return cos_sin_of_turn(angle * (0.5 / 3.14159265358979324)).y;
}

/// The angle of (x, y) from the x axis, in [0, pi], for y >= 0, with a relative error under 4e-7; 0 for (0, 0). Turned by pi/4
/// where that makes it smaller, what is left is at most pi/8; there an odd polynomial is off by 1e-7 of it (least squares fit
/// over Chebyshev points).
float angle_of(float y, float x) {
    float least = min(y, abs(x));
    float most = max(y, abs(x));
    if (most == 0.0) return 0.0;
    const float TAN_EIGHTH = 0.414213562;
    bool is_turned = least > TAN_EIGHTH * most;
    float r = is_turned ? (least - most) / (least + most) : least / most;
    float r2 = r * r;
    float angle = r + r * r2 * (-0.333332866 + r2 * (0.199912377 + r2 * (-0.140241428 + r2 * 0.0852049204)));
    if (is_turned) angle += 0.785398163;
    if (y > abs(x)) angle = 1.57079632679 - angle;
    return x < 0.0 ? 3.14159265359 - angle : angle;
}

#endif
