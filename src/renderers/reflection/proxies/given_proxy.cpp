// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/proxies/given_proxy.h"

#include "base/error.h"
#include "geometry/plane_file.h"

#include <fmt/format.h>

namespace utsuri {

GivenProxy read_proxy(const std::filesystem::path& path) {
    const PlaneFilePurpose purpose{"read proxy", "proxy", "distance along it from the world's origin"};
    const std::vector<PlaneLine> lines = read_planes(path, purpose);
    GivenProxy proxy{path.string(), {}};
    for (const PlaneLine& line : lines)
        proxy.planes.push_back(line.plane);
    const std::optional<ConvexRegion> region = enclosed_region(proxy.planes);
    if (!region) {
        throw InputError(purpose.operation, path.string(),
                         "its planes enclose nothing: they must leave no side open, with normals that point "
                         "out of the proxy");
    }
    if (const auto plane = plane_without_face(region->about_inside)) {
        fail_at_line(path, purpose, lines[*plane].number,
                     "the plane bounds no face: each must touch the polyhedron that all enclose, once");
    }
    return proxy;
}

}  // namespace utsuri
