// SPDX-License-Identifier: Apache-2.0
// Where light is kept on each triangle.
#ifndef UTSURI_KERNELS_LIGHT_LATTICES
#define UTSURI_KERNELS_LIGHT_LATTICES

#extension GL_EXT_scalar_block_layout : require

#include "interop/bindings.h"
#include "interop/light_cache.h"

layout(scalar, set = METHOD_SET, binding = BINDING_LIGHT_CACHE_TRIANGLES) readonly restrict buffer CacheTriangles {
    LightCacheTriangle cache_triangles[];
};

#endif
