// SPDX-License-Identifier: Apache-2.0
#include "geometry/plane_file.h"

#include "base/error.h"

#include "interop/reflection.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <cmath>
#include <fstream>
#include <sstream>

namespace utsuri {
namespace {

HalfSpace parse_plane(const std::string& line, const std::filesystem::path& path,
                      const PlaneFilePurpose& purpose, int number) {
    std::istringstream stream(line);
    glm::dvec3 normal(0.0);
    double distance = 0.0;
    std::string rest;
    if (!(stream >> normal.x >> normal.y >> normal.z >> distance) || (stream >> rest)) {
        fail_at_line(path, purpose, number,
                     fmt::format("a plane is four numbers: its normal x y z and its {}", purpose.distance));
    }
    const double length = glm::length(normal);
    if (!(length > 0.0) || !std::isfinite(length))
        fail_at_line(path, purpose, number, "the normal must be finite and not zero");
    return {normal / length, distance};
}

}  // namespace

void fail_at_line(const std::filesystem::path& path, const PlaneFilePurpose& purpose, int line,
                  const std::string& problem) {
    throw InputError(purpose.operation, fmt::format("{}, line {}", path.string(), line), problem);
}

std::vector<PlaneLine> read_planes(const std::filesystem::path& path, const PlaneFilePurpose& purpose) {
    std::ifstream stream(path);
    if (!stream) throw InputError(purpose.operation, path.string(), "it cannot be opened");
    std::vector<PlaneLine> planes;
    int number = 0;
    for (std::string line; std::getline(stream, line);) {
        ++number;
        line = line.substr(0, line.find('#'));
        if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
        planes.push_back({parse_plane(line, path, purpose, number), number});
    }
    if (planes.size() < 4 || planes.size() > interop::MAP_MOST_FACES) {
        throw InputError(purpose.operation, path.string(),
                         fmt::format("it has {} planes; a {} has 4 to {}", planes.size(), purpose.solid,
                                     interop::MAP_MOST_FACES));
    }
    return planes;
}

}  // namespace utsuri
