// SPDX-License-Identifier: Apache-2.0
// From a hit to the surface there.
#ifndef UTSURI_KERNELS_SCENE_SURFACE
#define UTSURI_KERNELS_SCENE_SURFACE

#include "interop/shading.h"
#include "kernels/scene/texture.glsl"
#include "kernels/scene/traversal.glsl"
#include "lib/surface.glsl"

vec3 interpolated_normal(uvec3 vertices, float b1, float b2) {
    return (1.0 - b1 - b2) * normals[vertices.x] + b1 * normals[vertices.y] + b2 * normals[vertices.z];
}

vec2 interpolated_texcoord(uvec3 vertices, float b1, float b2) {
    return (1.0 - b1 - b2) * texcoords[vertices.x] + b1 * texcoords[vertices.y] + b2 * texcoords[vertices.z];
}

/// Light that a point of a triangle sends to the side it is seen from.
vec3 emitted_radiance(MaterialInfo material, vec2 texcoord, bool front) {
    if (!front && material.double_sided == 0u) return vec3(0.0);
    vec3 emission = material.emissive;
    if (HAS_TEXTURES && material.emissive_texture.texture != NONE) {
        emission *= sample_texture(material.emissive_texture, texcoord, true).rgb;
    }
    return emission;
}

/// KHR_materials_specular: the reflectance of the dielectric part.
void evaluate_specular(inout Surface surface, MaterialInfo material) {
    surface.f0 = material.dielectric_f0;
    surface.f90 = material.specular;
    if (HAS_TEXTURES && material.specular_colour_texture.texture != NONE) {
        surface.f0 *= sample_texture(material.specular_colour_texture, surface.texcoord, true).rgb;
    }
    if (HAS_TEXTURES && material.specular_texture.texture != NONE) {
        surface.f90 *= sample_texture(material.specular_texture, surface.texcoord, false).a;
    }
    surface.f0 = min(surface.f0, vec3(1.0)) * surface.f90;
}

void evaluate_material(inout Surface surface, MaterialInfo material) {
    surface.base_colour = material.base_colour;
    surface.metallic = material.metallic;
    float roughness = material.roughness;
    if (HAS_TEXTURES && material.base_colour_texture.texture != NONE) {
        surface.base_colour *= sample_texture(material.base_colour_texture, surface.texcoord, true).rgb;
    }
    if (HAS_TEXTURES && material.metallic_roughness_texture.texture != NONE) {
        vec4 value = sample_texture(material.metallic_roughness_texture, surface.texcoord, false);
        roughness *= value.g;
        surface.metallic *= value.b;
    }
    surface.alpha = roughness < SPECULAR_ROUGHNESS ? 0.0 : roughness * roughness;
    surface.eta = surface.front ? material.ior : 1.0 / material.ior;
    evaluate_specular(surface, material);
    surface.emission = emitted_radiance(material, surface.texcoord, surface.front);
}

/// Normals and material of a surface whose place is known.
/// @param ng unit geometric normal of the front
/// @param ns interpolated shading normal of the front, any length
/// @param direction from the viewer, any length
void shade_surface(inout Surface surface, vec3 ng, vec3 ns, MaterialInfo material, vec3 direction) {
    bool front = dot(ng, direction) < 0.0;
    ns = normalize_any_scale(ns);
    // Vertex normals that cancel or point through the surface are no use: the geometric normal stands in.
    if (!(dot(ns, ng) > 0.0)) ns = ng;
    surface.front = front;
    surface.ng = front ? ng : -ng;
    surface.ns = front ? ns : -ns;
    evaluate_material(surface, material);
    // A glossy lobe is defined for viewers above the shading normal's horizon; a mirror copes (mirror_direction()).
    if (surface.alpha > 0.0 && dot(surface.ns, direction) >= 0.0) surface.ns = surface.ng;
}

/// @param direction of the ray that hit
Surface make_surface(Hit hit, vec3 direction) {
    BvhTriangle vertices = bvh_triangle(hit.triangle);
    TriangleInfo info = triangle_infos[hit.triangle];
    Surface surface;
    surface.error_bound = triangle_point_error(vertices, hit.b1, hit.b2);
    vec3 b = keep_off_edges(vertices, vec3(1.0 - hit.b1 - hit.b2, hit.b1, hit.b2), surface.error_bound);
    surface.position = triangle_point(vertices, b.y, b.z);
    surface.triangle = hit.triangle;
    surface.material = info.material;
    surface.instance = info.instance;
    surface.texcoord = HAS_TEXTURES ? interpolated_texcoord(info.vertices, hit.b1, hit.b2) : vec2(0.0);
    shade_surface(surface, triangle_normal(vertices),
                  interpolated_normal(info.vertices, hit.b1, hit.b2), materials[info.material], direction);
    return surface;
}

#endif
