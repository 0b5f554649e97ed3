// SPDX-License-Identifier: Apache-2.0
#ifndef UTSURI_LIB_DISTANCE_BOUNDS
#define UTSURI_LIB_DISTANCE_BOUNDS

/// The greater of two distances as DistanceBounds::farthest has them: negative if either is.
float farther(float a, float b) {
    float magnitude = max(abs(a), abs(b));
    return a < 0.0 || b < 0.0 ? -magnitude : magnitude;
}

#endif
