// SPDX-License-Identifier: Apache-2.0
// The samples of a film: chains that begin at the camera.
#ifndef UTSURI_KERNELS_TRACE_CAMERA_CHAIN
#define UTSURI_KERNELS_TRACE_CAMERA_CHAIN

#include "kernels/film/film_main.glsl"
#include "kernels/trace/specular_chain.glsl"

vec3 sample_radiance(vec3 origin, vec3 direction, uint key, uint index, inout Counters totals) {
    Ray ray = make_ray(origin, direction, NONE, push.excluded_instance);
    return follow_chain(start_chain(ray, 0u), push.max_depth, key, index, totals);
}

#endif
