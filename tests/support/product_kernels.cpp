// SPDX-License-Identifier: Apache-2.0
#include "support/product_kernels.h"

#include "kernels/add_drawn.h"
#include "kernels/aov.h"
#include "kernels/draw_scene_frag.h"
#include "kernels/draw_scene_vert.h"
#include "kernels/fill_light_cache.h"
#include "kernels/polygon_map.h"
#include "kernels/reflect_vertices.h"
#include "kernels/resolve_map.h"
#include "kernels/sphere_map.h"
#include "kernels/trace_direct.h"
#include "kernels/trace_rays.h"

namespace utsuri::test {

std::vector<ProductKernel> product_kernels() {
    return {{"add_drawn", kernels::add_drawn},
            {"aov", kernels::aov},
            {"draw_scene_frag", kernels::draw_scene_frag},
            {"draw_scene_vert", kernels::draw_scene_vert},
            {"fill_light_cache", kernels::fill_light_cache},
            {"polygon_map", kernels::polygon_map},
            {"reflect_vertices", kernels::reflect_vertices},
            {"resolve_map", kernels::resolve_map},
            {"sphere_map", kernels::sphere_map},
            {"trace_direct", kernels::trace_direct},
            {"trace_rays", kernels::trace_rays}};
}

}  // namespace utsuri::test
