// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/comparison/comparison.h"

#include "session/session.h"

namespace utsuri {

/// What a picture took, and how it looks; errors are not measured yet.
MethodResult collect_result(const PictureSettings& settings, const Picture& picture,
                            const MemoryUsage& memory);

/// Fills in how far a result's picture is from the comparison's reference, at the comparison's exposure.
void measure_errors(const Comparison& comparison, MethodResult& result);

}  // namespace utsuri
