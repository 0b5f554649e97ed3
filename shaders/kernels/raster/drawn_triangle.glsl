// SPDX-License-Identifier: Apache-2.0
// Sets what a vertex tells about the triangle of the scene that it lies on.
#ifndef UTSURI_KERNELS_RASTER_DRAWN_TRIANGLE
#define UTSURI_KERNELS_RASTER_DRAWN_TRIANGLE

#include "kernels/raster/drawn_surface.glsl"
#include "kernels/scene/surface.glsl"

/// @param b barycentric coordinates b1, b2 on it
void set_drawn_triangle(uint triangle, vec2 b) {
    TriangleInfo info = triangle_infos[triangle];
    drawn_place = vec4(b, HAS_TEXTURES ? interpolated_texcoord(info.vertices, b.x, b.y) : vec2(0.0));
    drawn_normal = interpolated_normal(info.vertices, b.x, b.y);
    drawn_ng = triangle_normal(bvh_triangle(triangle));
    MaterialInfo material = materials[info.material];
    drawn_colour = vec4(material.base_colour, material.metallic);
    drawn_emissive = vec4(material.emissive, material.roughness);
    drawn_lobe = vec4(material.dielectric_f0, material.specular);
    drawn_ior = material.ior;
    drawn_ids = uvec4(triangle, info.material, material.double_sided, NONE);
    drawn_reflection = vec3(0.0);
}

#endif
