// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/scene.h"

#include <optional>
#include <string>

namespace utsuri {

/// Checks that a scene keeps what its headers promise: indices, lengths of arrays, finite numbers and ranges.
/// One pass over vertices and triangles; texels are only counted. What is odd but can be rendered passes:
/// triangles without area, singular transforms, meshes that nothing places, and lights of infinite intensity,
/// whose samples are counted as non-finite.
/// @throws InputError that names the first value that is wrong, such as "instances[3].material"
void check_scene(const Scene& scene);

/// What is wrong with a value.
struct ValueFault {
    std::string name;     ///< of the value: "vertical_fov"
    std::string problem;  ///< "is 4; must be above 0 and below pi, in radians"
};

/// The first value of a camera that is out of its range; none if all are in theirs.
std::optional<ValueFault> find_fault(const Camera& camera);

}  // namespace utsuri
