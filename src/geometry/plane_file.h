// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/half_space.h"

#include <filesystem>
#include <string>
#include <vector>

namespace utsuri {

/// What a file of planes is read for, in the words of its errors.
struct PlaneFilePurpose {
    std::string operation;  ///< "read polyhedron"
    std::string solid;      ///< that the planes bound: "polyhedron of maps"
    std::string distance;   ///< what the fourth number is: "distance from the capture point"
};

struct PlaneLine {
    HalfSpace plane;
    int number;  ///< of the line in its file, from 1
};

/// Planes from a text file: four numbers a line, normal x, y, z (any length) and distance; # begins a
/// comment.
/// @throws InputError that names the line if it is malformed, or the file if it has less than 4 planes or
/// more than interop::MAP_MOST_FACES
std::vector<PlaneLine> read_planes(const std::filesystem::path& path, const PlaneFilePurpose& purpose);

/// Throws InputError about a line of a file of planes.
[[noreturn]] void fail_at_line(const std::filesystem::path& path, const PlaneFilePurpose& purpose, int line,
                               const std::string& problem);

}  // namespace utsuri
