// SPDX-License-Identifier: Apache-2.0
// What a drawn reflector's look-up is held against: the ray that it stands in for, where that can meet the scene, and what
// a pixel sees of the mirror.
#include "kernels/drawn_curvature.glsl"
#include "lib/prediction.glsl"

struct DrawnReflection {
    ReflectorInfo reflector;
    DistanceMapInfo map;
    SearchRay ray;
    HitInterval interval;
    Footprint footprint;
};

/// The angle that a pixel covers, at least: towards the picture's edges pixels are seen from farther away and slantwise.
float pixel_angle() {
    float cosine = dot(normalize_any_scale(drawn_from_eye), push.camera.forward);
    return 2.0 * length(push.camera.up) * push.pixel.y * cosine * cosine;
}

/// With an interval that follows from the least distance of all that surrounds the reflector alone: no search.
DrawnReflection outlined_reflection(Surface surface, vec3 wo) {
    DrawnReflection result;
    result.reflector = reflectors[drawn_ids.w];
    result.map = distance_maps[drawn_ids.w];
    result.ray = make_search_ray(surface.position - result.reflector.capture_point, mirror_direction(surface, wo));
    bool front = dot(surface.ng, drawn_ng) > 0.0;
    result.interval = outline_hit(result.map, result.ray, front);
    float curvature = front ? drawn_curvature : -drawn_curvature;
    result.footprint = make_footprint(length(drawn_from_eye), pixel_angle(), curvature, abs(dot(surface.ns, wo)));
    return result;
}

DrawnReflection drawn_reflection_of(Surface surface, vec3 wo) {
    DrawnReflection result = outlined_reflection(surface, wo);
    result.interval = find_hit(result.map, result.ray, dot(surface.ng, drawn_ng) > 0.0);
    return result;
}

/// Whether the mirrored ray's direction will do within push.tolerance, as the outline alone predicts.
bool outline_suffices(DrawnReflection outlined) {
    vec3 direction = outlined.ray.direction;
    Prediction prediction = predict(outlined.ray, outlined.interval, outlined.footprint, direction, direction,
                                    texel_angle(direction));
    return prediction.pixels <= push.tolerance;
}

/// What the method looks up and knows: `hybrid` searches only where the outline does not suffice. Methods that always
/// search have a tolerance of 0, and no texel is that small.
DrawnReflection looked_up_reflection_of(Surface surface, vec3 wo) {
    DrawnReflection outlined = outlined_reflection(surface, wo);
    if (MAP_KIND == MAP_KIND_DISTANCE && outline_suffices(outlined)) return outlined;
    return drawn_reflection_of(surface, wo);
}

vec3 wanted_direction_of(Surface surface, DrawnReflection reflection) {
    if (MAP_KIND == MAP_KIND_DISTANCE) return seen_along(reflection.ray, reflection.interval.guess);
    return wanted_direction(surface, reflection.reflector, reflection.ray.direction);
}

vec3 looked_up_direction_of(Surface surface, DrawnReflection reflection, vec3 wanted) {
    if (MAP_KIND == MAP_KIND_DISTANCE) return wanted;
    return looked_up_direction(surface, reflection.reflector, reflection.ray.direction);
}
