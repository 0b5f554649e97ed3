// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/comparison/comparison.h"

#include "base/progress.h"

#include "session/session.h"

namespace utsuri {

struct ComparisonSettings {
    RenderSettings render;
    const LightMethod* light = &light_methods().front();
    std::vector<Method> methods;  ///< all on the light axis `light`
    std::uint32_t samples = 16;   ///< per pixel and method
    /// Of the reference, even, so that its noise can be told; not set: ten times `samples`, and more until
    /// its mean squared error is a tenth of the least that a method has, within reference_seconds.
    std::optional<std::uint32_t> reference_samples;
    double reference_seconds = 120.0;  ///< wall time of the reference's samples, about
    MapSettings maps;
    std::optional<double> exposure;  ///< stops; found from the reference if not set
    bool predictions = false;        ///< find MethodResult::reflection_errors
};

/// What is known before anything is rendered: device, scene, and which pixels reflect.
Comparison begin_comparison(Session& session, const Camera& camera, const ComparisonSettings& settings);

/// Renders reference and methods, and measures. Stops early if progress says so, with what was finished. A
/// method that fails is noted in Comparison::failures, and the others go on.
/// @throws Error if the reference fails
Comparison run_comparison(Session& session, const Camera& camera, const ComparisonSettings& settings,
                          Progress& progress);

}  // namespace utsuri
