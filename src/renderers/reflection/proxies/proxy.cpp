// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/proxies/proxy.h"

#include "renderers/reflection/proxies/proxy_box.h"
#include "renderers/reflection/proxies/proxy_planes.h"

namespace utsuri {
namespace {

/// Mean log ratio of distances below which a box is taken as right: what is seen is then off by less than a
/// texel of most maps.
constexpr double kGoodFit = 1e-3;
/// Planes cost more than a box at every look-up; they are taken where they leave at most this share of its
/// misfit.
constexpr double kBetterBy = 0.5;

std::vector<HalfSpace> sides_of(const Bounds& box) {
    std::vector<HalfSpace> planes;
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 normal(0.0);
        normal[axis] = 1.0;
        planes.push_back({-normal, -static_cast<double>(box.lower[axis])});
        planes.push_back({normal, static_cast<double>(box.upper[axis])});
    }
    return planes;
}

Proxy proxy_of(std::vector<HalfSpace> planes) {
    if (const std::optional<Bounds> box = box_of(planes)) return {*box, {}};
    return {{}, std::move(planes)};
}

}  // namespace

Proxy find_proxy(const SceneData& scene, std::uint32_t instance, const glm::dvec3& point,
                 const std::optional<GivenProxy>& given) {
    if (given) return proxy_of(moved_to(scene.origin, given->planes));
    const Surroundings around = sample_surroundings(scene, instance, point);
    const Bounds box = fit_proxy_box(around);
    const double misfit = mean_misfit(around.samples, moved_to(point, sides_of(box)));
    if (misfit <= kGoodFit) return {box, {}};
    const std::vector<HalfSpace> planes = fit_proxy_planes(scene, around);
    if (mean_misfit(around.samples, planes) > kBetterBy * misfit) return {box, {}};
    return proxy_of(moved_to(-point, planes));
}

interop::ProxyInfo add_proxy(std::vector<interop::ProxyPlane>& planes, const Proxy& proxy) {
    const interop::ProxyInfo info{proxy.box.lower, proxy.box.upper, static_cast<std::uint32_t>(planes.size()),
                                  static_cast<std::uint32_t>(proxy.planes.size())};
    for (const HalfSpace& plane : proxy.planes)
        planes.push_back({glm::vec3(plane.normal), static_cast<float>(plane.offset)});
    return info;
}

}  // namespace utsuri
