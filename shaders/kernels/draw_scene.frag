// SPDX-License-Identifier: Apache-2.0
// What a pixel of the drawn scene shows: light from the cache, reflections from the maps. Rough lobes are lit by a sample
// of the lights.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/scene_bindings.glsl"
#include "kernels/map_bindings.glsl"
#include "interop/light_cache.h"
#include "interop/raster.h"
#include "lib/cube_map.glsl"
#include "lib/direct_light.glsl"
#include "lib/lattice.glsl"

layout(early_fragment_tests) in;

layout(constant_id = SPEC_MAP_KIND) const uint MAP_KIND = MAP_KIND_POLYGON;

layout(push_constant, scalar) uniform Push { RasterPush push; };

layout(scalar, binding = BINDING_LIGHT_CACHE_TRIANGLES) readonly restrict buffer CacheTriangles {
    LightCacheTriangle cache_triangles[];
};
layout(scalar, binding = BINDING_LIGHT_CACHE_POINTS) readonly restrict buffer CachePoints {
    LightCachePoint cache_points[];
};

layout(location = 0) in vec2 barycentric;
layout(location = 1) in vec3 reflection;
layout(location = 2) flat in uint triangle;
layout(location = 0) out vec4 drawn;

vec3 cached_light(bool front) {
    LightCacheTriangle lattice = cache_triangles[triangle];
    if (lattice.edge == 0u) return vec3(0.0);
    LatticeCell cell = lattice_cell(lattice.edge, barycentric.x, barycentric.y);
    uvec3 points = lattice.first_point + cell.points;
    if (front) {
        return cell.weights.x * cache_points[points.x].front + cell.weights.y * cache_points[points.y].front +
               cell.weights.z * cache_points[points.z].front;
    }
    return cell.weights.x * cache_points[points.x].back + cell.weights.y * cache_points[points.y].back +
           cell.weights.z * cache_points[points.z].back;
}

vec3 mapped_radiance(Surface surface, vec3 wi) {
    ReflectorInfo reflector = reflectors[instance_reflectors[surface.instance]];
    if (MAP_KIND == MAP_KIND_SPHERE) return sample_map(reflector.first_texel, 2.0 * reflection.xy - 1.0);
    // Opposite vectors may cancel; nothing can be interpolated there.
    vec3 direction = reflection == vec3(0.0) ? wi : reflection;
    // A polygon that straddles faces is cut along their boundaries, which in unnormalised directions is what the major
    // axis says.
    uint face = cube_face(direction);
    uint stride = MAP_SIZE + 2u * MAP_BORDER;
    return sample_map(reflector.first_texel + face * stride * stride, cube_face_position(direction, face));
}

void main() {
    vec3 direction = triangle_point(bvh_triangles[triangle], barycentric.x, barycentric.y) - push.camera.origin;
    vec3 wo = -normalize_any_scale(direction);
    Surface surface = make_surface(Hit(0.0, triangle, barycentric.x, barycentric.y), -wo);
    vec3 radiance = surface.emission;
    if (HAS_GLOSSY && is_glossy(surface)) {
        uvec2 pixel = uvec2(gl_FragCoord.xy);
        uint key = sampler_key(pixel, push.seed, push.sample_index & 1u);
        uint rays = 0u;
        radiance += direct_light(surface, wo, key, push.sample_index >> 1, 1u, NONE, rays);
    } else {
        float cos_o = abs(dot(surface.ns, wo));
        bool front = dot(surface.ng, triangle_cross(bvh_triangles[triangle])) > 0.0;
        radiance += surface.base_colour * ((1.0 - surface.metallic) * (1.0 - dielectric_fresnel(surface, cos_o))) *
                    cached_light(front);
    }
    if (HAS_SPECULAR && is_specular(surface)) {
        radiance += specular_reflectance(surface, abs(dot(surface.ns, wo))) *
                    mapped_radiance(surface, mirror_direction(surface, wo));
    }
    drawn = vec4(radiance, 1.0);
}
