// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/convex_region.h"

#include <filesystem>
#include <string>
#include <vector>

namespace utsuri {

/// A convex polyhedron that its user says stands in for what surrounds all reflectors.
struct GivenProxy {
    std::string name;
    std::vector<HalfSpace> planes;  ///< world space, metres
};

/// Planes from a text file: four numbers a line, normal x, y, z (any length) out of the proxy and distance
/// along it from the world's origin, which may be negative; # begins a comment.
/// @throws InputError that names the line if it is malformed, or the file if the planes do not enclose a
/// polyhedron that every plane touches, or are more than interop::MAP_MOST_FACES
GivenProxy read_proxy(const std::filesystem::path& path);

}  // namespace utsuri
