// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/comparison.h"

namespace utsuri {

/// What a renderer took for the samples of a film, and their picture; errors are not measured yet.
/// @param maps noted if the method uses maps
MethodResult collect_result(const Method& method, const MapSettings& maps, const Renderer& renderer,
                            const Film& film, const Device& device);

/// Fills in how far a result's picture is from the comparison's reference, at the comparison's exposure.
void measure_errors(const Comparison& comparison, MethodResult& result);

}  // namespace utsuri
