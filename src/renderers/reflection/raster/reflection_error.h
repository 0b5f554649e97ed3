// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace utsuri {

/// How wrong a look-up can be, at the centre of a pixel: kNoReflection where no mirror is seen.
struct PredictedError {
    float parallax;  ///< radians at the capture point, at most: what is mirrored is not infinitely far, or
                     ///< not where the method takes it to be
    float interpolation;  ///< radians: per vertex instead of per pixel
    float texel;          ///< radians: half the diagonal of a texel
    float pixels;  ///< by how many pixels what is shown can be off its place; infinity where nothing is known
};

/// How wrong it is, told by the ray that it stands in for: kNoReflection where no mirror is seen.
struct MeasuredError {
    float angle;     ///< radians at the capture point
    float pixels;    ///< by how many pixels what is shown is off its place
    float distance;  ///< metres that the mirrored ray goes; infinity where it meets nothing
    float seen;      ///< 1 where the capture point sees what the ray meets, else 0
};

/// What either tells where no mirror is seen.
template <typename Errors>
inline constexpr Errors kNoReflection{-1.0f, -1.0f, -1.0f, -1.0f};

}  // namespace utsuri
