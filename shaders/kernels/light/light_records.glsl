// SPDX-License-Identifier: Apache-2.0
// What tells where the light of a triangle is kept: kept_light.glsl reads it, others only hand it on.
#ifndef UTSURI_KERNELS_LIGHT_LIGHT_RECORDS
#define UTSURI_KERNELS_LIGHT_LIGHT_RECORDS

#extension GL_EXT_scalar_block_layout : require

#include "interop/bindings.h"
#include "interop/light_cache.h"

layout(scalar, set = METHOD_SET, binding = BINDING_LIGHT_CACHE_TRIANGLES) readonly restrict buffer CacheTriangles {
    LightCacheTriangle cache_triangles[];
};

uvec4 light_record(uint triangle) {
    LightCacheTriangle lattice = cache_triangles[triangle];
    return uvec4(lattice.first_point, lattice.intervals, lattice.rows_per_interval, lattice.apex);
}

#endif
