// SPDX-License-Identifier: Apache-2.0
// What stands in for the surroundings, and where rays leave it.
#ifndef UTSURI_KERNELS_MAPS_PROXIES
#define UTSURI_KERNELS_MAPS_PROXIES

#extension GL_EXT_scalar_block_layout : require

#include "interop/bindings.h"
#include "lib/map_constants.glsl"
#include "lib/proxy.glsl"

layout(scalar, set = METHOD_SET, binding = BINDING_PROXY_PLANES) readonly restrict buffer ProxyPlanes {
    ProxyPlane proxy_planes[];
};

vec3 leave_proxy(vec3 origin, vec3 direction, ProxyInfo proxy) {
    if (HAS_PROXY_PLANES == 0u || proxy.planes == 0u) return leave_box(origin, direction, proxy.lower, proxy.upper);
    float t = INFINITY;
    for (uint i = 0u; i < proxy.planes; ++i)
        t = leave_half_space(t, origin, direction, proxy_planes[proxy.first_plane + i]);
    return origin + max(t, 0.0) * direction;
}

#endif
