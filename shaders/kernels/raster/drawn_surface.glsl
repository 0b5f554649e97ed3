// SPDX-License-Identifier: Apache-2.0
// What the vertex stage tells the fragment stage about the surface it draws. What is the same all over a triangle is
// flat, which costs a pixel nothing, where reading it from buffers would. A vertex stage defines VERTEX_STAGE before it
// includes anything.
#ifndef UTSURI_KERNELS_RASTER_DRAWN_SURFACE
#define UTSURI_KERNELS_RASTER_DRAWN_SURFACE

#ifdef VERTEX_STAGE
#define DRAWN out
#define DRAWN_FLAT flat out
#else
#define DRAWN in
#define DRAWN_FLAT flat in
#endif

layout(location = 0) DRAWN vec4 drawn_place;        // barycentric b1, b2; texture coordinate
layout(location = 1) DRAWN vec3 drawn_from_eye;     // position - eye
layout(location = 2) DRAWN vec3 drawn_normal;       // interpolated, not normalised
layout(location = 3) DRAWN vec3 drawn_reflection;   // how the map is addressed: see MAP_KIND_ in interop/reflection.h
layout(location = 4) DRAWN_FLAT uvec4 drawn_ids;    // triangle, material, double-sided; reflector, probe or map
layout(location = 5) DRAWN_FLAT vec3 drawn_ng;      // unit, on the front
layout(location = 5, component = 3) DRAWN_FLAT float drawn_ior;
layout(location = 6) DRAWN_FLAT vec4 drawn_colour;  // base colour, metallic
layout(location = 7) DRAWN_FLAT vec4 drawn_emissive; // and roughness
layout(location = 8) DRAWN_FLAT vec4 drawn_lobe;    // MaterialInfo::dielectric_f0 and specular

#endif
