// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/comparison/comparison.h"

#include "base/progress.h"

#include "session/session.h"

namespace utsuri {

struct ComparisonSettings {
    RenderSettings render;
    const LightMethod* light = &light_methods().front();
    std::vector<Method> methods;            ///< all on the light axis `light`
    std::uint32_t samples = 16;             ///< per pixel and method
    std::uint32_t reference_samples = 128;  ///< even, so that the reference's noise can be told
    MapSettings maps;
    std::optional<double> exposure;  ///< stops; found from the reference if not set
    bool predictions = false;        ///< find MethodResult::reflection_errors
};

/// Renders reference and methods, and measures. Stops early if progress says so, with what was finished. A
/// method that fails is noted in Comparison::failures, and the others go on.
/// @throws Error if the reference fails
Comparison run_comparison(Session& session, const Camera& camera, const ComparisonSettings& settings,
                          Progress& progress);

}  // namespace utsuri
