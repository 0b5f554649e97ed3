// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/scene_data.h"
#include "renderers/reflection/proxies/given_proxy.h"

#include "interop/proxy.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace utsuri {

/// What stands in for the surroundings of a reflector: a box along the axes, or planes. Scene space.
struct Proxy {
    Bounds box;                     ///< if there are no planes
    std::vector<HalfSpace> planes;  ///< 4 or more, or none
};

/// The given proxy, or else the one that fits what is seen from the capture point: the best box, unless
/// planes found there at least halve its misfit.
/// @param point capture point, scene space
Proxy find_proxy(const SceneData& scene, std::uint32_t instance, const glm::dvec3& point,
                 const std::optional<GivenProxy>& given);

/// A proxy as the device reads it, its planes put behind those of others.
interop::ProxyInfo add_proxy(std::vector<interop::ProxyPlane>& planes, const Proxy& proxy);

}  // namespace utsuri
