// SPDX-License-Identifier: Apache-2.0
#include "renderers/methods/method.h"

#include "renderers/methods/map_renderer.h"
#include "renderers/methods/planar_renderer.h"
#include "renderers/methods/ray_tracer.h"

#include "base/check.h"
#include "base/error.h"

#include <fmt/format.h>

#include <array>

namespace utsuri {
namespace {

constexpr std::array kReflections = {ReflectionMethod::trace,      ReflectionMethod::polygon_map,
                                     ReflectionMethod::sphere_map, ReflectionMethod::cube_map,
                                     ReflectionMethod::proxy_map,  ReflectionMethod::distance_map,
                                     ReflectionMethod::planar,     ReflectionMethod::hybrid};

MapKind map_kind(ReflectionMethod reflection) {
    switch (reflection) {
        case ReflectionMethod::polygon_map:
            return MapKind::polygon;
        case ReflectionMethod::sphere_map:
            return MapKind::sphere;
        case ReflectionMethod::cube_map:
            return MapKind::cube;
        case ReflectionMethod::proxy_map:
            return MapKind::proxy;
        case ReflectionMethod::distance_map:
            return MapKind::distance;
        case ReflectionMethod::hybrid:
            return MapKind::hybrid;
        case ReflectionMethod::trace:
        case ReflectionMethod::planar:
            break;
    }
    fail_check(__FILE__, __LINE__, "a reflection method without maps of its own");
}

/// Whether hybrid draws images in plane mirrors: they show all in its place. A tolerance of radiance they
/// need not keep, as rough surfaces in them are looked up.
bool hybrid_draws_images(const Method& method, const SceneData& data, const MapSettings& maps) {
    return method.reflection == ReflectionMethod::hybrid && maps.tolerance.of == Tolerance::Of::place &&
           !find_plane_mirrors(data).mirrors.empty();
}

}  // namespace

std::string_view to_string(LightMethod) {
    return "direct";
}

std::string_view to_string(ReflectionMethod reflection) {
    switch (reflection) {
        case ReflectionMethod::trace:
            return "trace";
        case ReflectionMethod::polygon_map:
            return "polygon-map";
        case ReflectionMethod::sphere_map:
            return "sphere-map";
        case ReflectionMethod::cube_map:
            return "cube-map";
        case ReflectionMethod::proxy_map:
            return "proxy-map";
        case ReflectionMethod::distance_map:
            return "distance-map";
        case ReflectionMethod::planar:
            return "planar";
        case ReflectionMethod::hybrid:
            return "hybrid";
    }
    fail_check(__FILE__, __LINE__, "a reflection method without a name");
}

std::string method_name(const Method& method) {
    return fmt::format("{}/{}", to_string(method.light), to_string(method.reflection));
}

LightMethod parse_light(std::string_view name) {
    if (name == to_string(LightMethod::direct)) return LightMethod::direct;
    throw UsageError("choose light", fmt::format("'{}'", name), "there is: direct");
}

ReflectionMethod parse_reflection(std::string_view name) {
    for (const ReflectionMethod reflection : kReflections) {
        if (name == to_string(reflection)) return reflection;
    }
    throw UsageError(
        "choose reflection", fmt::format("'{}'", name),
        "there are: trace, polygon-map, sphere-map, cube-map, proxy-map, distance-map, planar, hybrid");
}

std::vector<Method> all_methods(LightMethod light) {
    std::vector<Method> methods;
    methods.reserve(kReflections.size());
    for (const ReflectionMethod reflection : kReflections)
        methods.push_back({light, reflection});
    return methods;
}

bool uses_maps(const Method& method) {
    return method.reflection != ReflectionMethod::trace;
}

bool tells_errors(const Method& method) {
    return uses_maps(method) && method.reflection != ReflectionMethod::planar;
}

bool chooses_per_pixel(const Method& method) {
    return method.reflection == ReflectionMethod::hybrid;
}

std::unique_ptr<Renderer> make_renderer(const Method& method, const RenderInput& input,
                                        const RenderSettings& settings, const MapSettings& maps) {
    if (!uses_maps(method)) {
        return std::make_unique<RayTracer>(input.device, input.data, input.scene, input.camera, settings);
    }
    const bool is_planar = method.reflection == ReflectionMethod::planar;
    if (is_planar || hybrid_draws_images(method, input.data, maps)) {
        const MapKind kind = is_planar ? MapKind::proxy : MapKind::hybrid;
        return std::make_unique<PlanarRenderer>(input.device, input.data, input.scene, input.light,
                                                input.camera, kind, settings, maps);
    }
    return std::make_unique<MapRenderer>(input.device, input.data, input.scene, input.light, input.camera,
                                         map_kind(method.reflection), settings, maps);
}

}  // namespace utsuri
