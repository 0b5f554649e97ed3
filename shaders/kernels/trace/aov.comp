// SPDX-License-Identifier: Apache-2.0
// The first hit through the centre of each pixel.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/film/film_bindings.glsl"
#include "kernels/scene/surface.glsl"
#include "lib/reflectance.glsl"

layout(scalar, set = METHOD_SET, binding = BINDING_AOV) writeonly restrict buffer Aov { AovPixel aov[]; };

void main() {
    uvec2 in_band = pixel_in_band();
    if (in_band.x >= push.width || in_band.y >= push.rows) return;
    vec3 direction = camera_direction(vec2(in_band.x, in_band.y + push.first_row) + 0.5);
    Hit hit = closest_hit(make_ray(push.camera.origin, direction, NONE, push.excluded_instance));
    AovPixel result = AovPixel(INFINITY, vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec2(0.0), NONE, NONE, NONE, 0u);
    if (hit.triangle != NONE) {
        Surface surface = make_surface(hit, direction);
        // Exact projection onto the viewing axis, whose length is not assumed to be 1.
        float axis_length = length(push.camera.forward);
        result.depth = dot(surface.position - push.camera.origin, push.camera.forward) / axis_length;
        result.position = surface.position;
        result.geometric_normal = surface.ng;
        result.shading_normal = surface.ns;
        result.albedo = surface.base_colour;
        result.texcoord = surface.texcoord;
        result.triangle = surface.triangle;
        result.instance = surface.instance;
        result.material = surface.material;
        result.mirror = is_mirror(surface) ? 1u : 0u;
    }
    aov[in_band.y * push.width + in_band.x] = result;
}
