// SPDX-License-Identifier: Apache-2.0
// The surface at a point, and the triangle that it lies on.
#ifndef UTSURI_LIB_SURFACE
#define UTSURI_LIB_SURFACE

#include "lib/triangle_geometry.glsl"

struct Surface {
    vec3 position;
    vec3 error_bound;    ///< of the position, per component
    vec3 ng;             ///< unit geometric normal, on the viewer's side
    vec3 ns;             ///< unit shading normal, on the same side as ng
    vec2 texcoord;
    uint triangle;
    uint material;
    uint instance;
    bool front;          ///< the viewer is on the side that the triangle's vertices go round counterclockwise
    float eta;           ///< index of refraction on the far side over that on the viewer's side
    vec3 base_colour;
    float metallic;
    float alpha;         ///< GGX width; 0 where the surface is a perfect mirror or smooth dielectric
    vec3 f0;             ///< of the dielectric part, each at most f90
    float f90;
    vec3 emission;       ///< cd/m2 towards the viewer
};

/// Distance that a hit keeps from the edges of its triangle, in bounds of its rounding error: enough for the offset
/// of a leaving ray too, where the neighbour meets the triangle at an angle of 20 degrees or more.
const float EDGE_MARGIN = 6.0;

/// Barycentric coordinates of a hit, moved inwards where it is within rounding error of an edge. Beyond the edge a
/// leaving ray would start behind the neighbouring surface, and miss it, or in its plane, and hit it.
vec3 keep_off_edges(BvhTriangle vertices, vec3 b, vec3 error_bound) {
    float longest = max(max_component(abs(vertices.v1 - vertices.v0)),
                        max(max_component(abs(vertices.v2 - vertices.v1)), max_component(abs(vertices.v0 - vertices.v2))));
    float height = max_component(abs(triangle_cross(vertices))) / longest;
    // A triangle thinner than its rounding error has no inside to keep to.
    float margin = min(EDGE_MARGIN * max_component(error_bound) / height, 0.25);
    if (all(greaterThanEqual(b, vec3(margin)))) return b;
    b = max(b, vec3(margin));
    return b / (b.x + b.y + b.z);
}

/// Whether a direction leaves the surface on the viewer's side.
bool is_above(Surface surface, vec3 wi) {
    return dot(surface.ns, wi) > 0.0 && dot(surface.ng, wi) > 0.0;
}

/// What choosing a light for a point is told of the surface there.
struct Receiver {
    vec3 position;
    vec3 normal;  ///< unit shading normal, on the side that light is gathered for
};

Receiver receiver_of(Surface surface) {
    return Receiver(surface.position, surface.ns);
}

vec3 leave_surface(Surface surface, vec3 w) {
    return offset_origin(surface.position, surface.error_bound, surface.ng, w);
}

#endif
