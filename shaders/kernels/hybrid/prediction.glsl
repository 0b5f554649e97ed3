// SPDX-License-Identifier: Apache-2.0
// How wrong a look-up in a reflection map can be, told before what it stands in for is known.
#ifndef UTSURI_KERNELS_HYBRID_PREDICTION
#define UTSURI_KERNELS_HYBRID_PREDICTION

#include "kernels/distances/distance_search.glsl"

/// Angle between vectors of any length; 0 where one of them is zero.
float angle_between(vec3 a, vec3 b) {
    vec3 u = normalize_any_scale(a);
    vec3 v = normalize_any_scale(b);
    vec3 across = cross(u, v);
    return atan(length(across), dot(u, v));
}

/// What a pixel sees of a mirror, for turning angles at the capture point into pixels.
struct Footprint {
    float eye_distance;  ///< from the eye to the mirror
    float pixel_angle;   ///< of a pixel at the eye
    float spread;        ///< how much faster than on a plane mirror reflected rays of neighbouring pixels part
};

/// What reflects with normals that turn by `curvature` a metre parts the rays of neighbouring pixels faster than a plane
/// mirror does (Igehy 1999, for a sphere in the plane of incidence).
Footprint make_footprint(float eye_distance, float pixel_angle, float curvature, float cosine) {
    return Footprint(eye_distance, pixel_angle, 1.0 + 2.0 * eye_distance * curvature / max(cosine, 1e-3));
}

/// By how many pixels what is seen `angle` off its place at the capture point is off its place in the picture.
/// @param t where the ray meets the scene
float displacement(SearchRay ray, Footprint footprint, float t, float angle) {
    float width = footprint.pixel_angle *
                  (isinf(t) ? abs(footprint.spread) : abs(footprint.eye_distance + t * footprint.spread));
    float distance = isinf(t) ? 1.0 : length(ray_place(ray, t));
    return width > 0.0 ? angle * distance / width : (angle > 0.0 ? INFINITY : 0.0);
}

struct Prediction {
    float parallax;       ///< radians, at most: the map was captured elsewhere than where it is looked up
    float interpolation;  ///< radians: what is found per vertex is not what is found per pixel
    float texel;          ///< radians: half the diagonal of a texel
    float pixels;         ///< all of them, in pixels of the picture
};

/// @param wanted the direction that the method means to look up at this pixel, were it not for interpolation
/// @param looked_up the direction that it looks up
Prediction predict(SearchRay ray, HitInterval interval, Footprint footprint, vec3 wanted, vec3 looked_up, float texel) {
    // Places of the ray lie on an arc of less than half a turn; the angle to the direction looked up, which lies on the
    // arc's great circle, is largest at one of its ends.
    float near = angle_between(wanted, seen_along(ray, interval.t0));
    float far = angle_between(wanted, seen_along(ray, interval.t1));
    Prediction result;
    result.parallax = max(near, far);
    result.interpolation = angle_between(wanted, looked_up);
    result.texel = texel;
    float others = result.interpolation + texel;
    result.pixels = max(displacement(ray, footprint, interval.t0, near + others),
                        displacement(ray, footprint, interval.t1, far + others));
    return result;
}

#endif
