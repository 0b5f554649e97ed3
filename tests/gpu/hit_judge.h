// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/bvh.h"

#include "interop/rays.h"

#include <string>

namespace utsuri::test {

/// How a float32 watertight test (Woop, Benthin and Wald 2013) may decide on a triangle: the exact crossing
/// in float64, with bounds on what float32 rounding can do to it.
struct TriangleDecision {
    double t = 0.0;         ///< of ray and plane; anything where `t_error` is infinite
    double t_error = 0.0;   ///< bound on the float32 result's distance from t
    bool possible = false;  ///< some rounding calls it a hit of the line
    bool certain = false;   ///< every rounding calls it a hit of the line
};

/// @param ray with a finite direction that is not zero
TriangleDecision decide(const interop::BvhTriangle& triangle, const interop::RayInfo& ray);

enum class Verdict {
    exact,            ///< the triangle that exact arithmetic finds
    within_rounding,  ///< another one, or none, as the rounding of float32 explains: a shared edge, a tie
    wrong             ///< beyond any rounding
};

/// Holds a hit found in float32 against exact arithmetic: what was hit can be hit at that distance, and
/// nothing nearer is hit for certain.
/// @param explanation of a wrong verdict
Verdict judge(const Bvh& bvh, const interop::RayInfo& ray, const interop::HitInfo& hit,
              std::string& explanation);

}  // namespace utsuri::test
