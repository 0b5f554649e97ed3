// SPDX-License-Identifier: Apache-2.0
#include "support/product_kernels.h"

#include "kernels/add_drawn.h"
#include "kernels/aov.h"
#include "kernels/bound_distances.h"
#include "kernels/bound_radiance.h"
#include "kernels/cut_polygons.h"
#include "kernels/draw_curved_vert.h"
#include "kernels/draw_cut_pieces_vert.h"
#include "kernels/draw_depth_vert.h"
#include "kernels/draw_distance_reflector_frag.h"
#include "kernels/draw_environment_vert.h"
#include "kernels/draw_hybrid_reflector_frag.h"
#include "kernels/draw_mirrored_curved_frag.h"
#include "kernels/draw_mirrored_depth_frag.h"
#include "kernels/draw_mirrored_depth_vert.h"
#include "kernels/draw_mirrored_environment_frag.h"
#include "kernels/draw_mirrored_hybrid_frag.h"
#include "kernels/draw_mirrored_mirror_frag.h"
#include "kernels/draw_mirrored_scene_frag.h"
#include "kernels/draw_mirrored_traced_mirror_frag.h"
#include "kernels/draw_predicted_curved_vert.h"
#include "kernels/draw_predicted_reflectors_vert.h"
#include "kernels/draw_radiance_hybrid_reflector_frag.h"
#include "kernels/draw_reflector_depth_vert.h"
#include "kernels/draw_reflector_frag.h"
#include "kernels/draw_reflectors_vert.h"
#include "kernels/draw_scene_frag.h"
#include "kernels/draw_scene_vert.h"
#include "kernels/draw_whole_pieces_vert.h"
#include "kernels/fill_light_cache.h"
#include "kernels/halve_map.h"
#include "kernels/measure_distances.h"
#include "kernels/measure_inverse_distances.h"
#include "kernels/measure_radiance.h"
#include "kernels/measure_reflection_frag.h"
#include "kernels/predict_reflection_frag.h"
#include "kernels/prefilter_map.h"
#include "kernels/prefix_sum.h"
#include "kernels/reduce_bounds.h"
#include "kernels/reduce_radiance.h"
#include "kernels/reflect_vertices.h"
#include "kernels/resolve_map.h"
#include "kernels/sort_polygons.h"
#include "kernels/trace_direct.h"
#include "kernels/trace_kept.h"
#include "kernels/trace_rays.h"

namespace utsuri::test {

std::vector<ProductKernel> product_kernels() {
    return {{"add_drawn", kernels::add_drawn},
            {"aov", kernels::aov},
            {"bound_distances", kernels::bound_distances},
            {"bound_radiance", kernels::bound_radiance},
            {"cut_polygons", kernels::cut_polygons},
            {"draw_predicted_reflectors_vert", kernels::draw_predicted_reflectors_vert},
            {"draw_curved_vert", kernels::draw_curved_vert},
            {"draw_cut_pieces_vert", kernels::draw_cut_pieces_vert},
            {"draw_depth_vert", kernels::draw_depth_vert},
            {"draw_distance_reflector_frag", kernels::draw_distance_reflector_frag},
            {"draw_hybrid_reflector_frag", kernels::draw_hybrid_reflector_frag},
            {"draw_mirrored_curved_frag", kernels::draw_mirrored_curved_frag},
            {"draw_mirrored_depth_frag", kernels::draw_mirrored_depth_frag},
            {"draw_mirrored_depth_vert", kernels::draw_mirrored_depth_vert},
            {"draw_mirrored_hybrid_frag", kernels::draw_mirrored_hybrid_frag},
            {"draw_mirrored_mirror_frag", kernels::draw_mirrored_mirror_frag},
            {"draw_mirrored_scene_frag", kernels::draw_mirrored_scene_frag},
            {"draw_mirrored_environment_frag", kernels::draw_mirrored_environment_frag},
            {"draw_mirrored_traced_mirror_frag", kernels::draw_mirrored_traced_mirror_frag},
            {"draw_predicted_curved_vert", kernels::draw_predicted_curved_vert},
            {"draw_radiance_hybrid_reflector_frag", kernels::draw_radiance_hybrid_reflector_frag},
            {"draw_reflector_depth_vert", kernels::draw_reflector_depth_vert},
            {"draw_reflector_frag", kernels::draw_reflector_frag},
            {"draw_reflectors_vert", kernels::draw_reflectors_vert},
            {"draw_scene_frag", kernels::draw_scene_frag},
            {"draw_scene_vert", kernels::draw_scene_vert},
            {"draw_environment_vert", kernels::draw_environment_vert},
            {"draw_whole_pieces_vert", kernels::draw_whole_pieces_vert},
            {"fill_light_cache", kernels::fill_light_cache},
            {"halve_map", kernels::halve_map},
            {"measure_distances", kernels::measure_distances},
            {"measure_inverse_distances", kernels::measure_inverse_distances},
            {"measure_radiance", kernels::measure_radiance},
            {"measure_reflection_frag", kernels::measure_reflection_frag},
            {"predict_reflection_frag", kernels::predict_reflection_frag},
            {"prefilter_map", kernels::prefilter_map},
            {"prefix_sum", kernels::prefix_sum},
            {"reduce_bounds", kernels::reduce_bounds},
            {"reduce_radiance", kernels::reduce_radiance},
            {"reflect_vertices", kernels::reflect_vertices},
            {"resolve_map", kernels::resolve_map},
            {"sort_polygons", kernels::sort_polygons},
            {"trace_kept", kernels::trace_kept},
            {"trace_direct", kernels::trace_direct},
            {"trace_rays", kernels::trace_rays}};
}

}  // namespace utsuri::test
