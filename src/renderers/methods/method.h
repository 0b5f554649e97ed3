// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/light/light_cache.h"
#include "renderers/methods/renderer.h"
#include "renderers/reflection/maps/reflection_maps.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace utsuri {

/// What light is simulated at diffuse surfaces.
enum class LightMethod { direct };

/// How the light arriving along a specular direction is found.
enum class ReflectionMethod {
    trace,
    polygon_map,
    sphere_map,
    cube_map,
    proxy_map,
    distance_map,
    planar,
    hybrid
};

/// A point on the two axes, written "direct/polygon-map".
struct Method {
    LightMethod light = LightMethod::direct;
    ReflectionMethod reflection = ReflectionMethod::trace;

    friend bool operator==(const Method&, const Method&) = default;
};

std::string_view to_string(LightMethod light);
std::string_view to_string(ReflectionMethod reflection);
std::string method_name(const Method& method);

/// @throws UsageError that lists the names there are
LightMethod parse_light(std::string_view name);
ReflectionMethod parse_reflection(std::string_view name);

/// Every method on a light axis, in the order of reports.
std::vector<Method> all_methods(LightMethod light);

/// Whether a method looks reflections up in maps; `planar` does those of mirrors that are not plane.
bool uses_maps(const Method& method);

/// Whether a method tells the errors of its reflections: Renderer::predict_errors().
bool tells_errors(const Method& method);

/// Whether a method looks maps up at some pixels and traces others: Renderer::traced_pixels().
bool chooses_per_pixel(const Method& method);

/// What a picture is made from. Everything must outlive the renderer.
struct RenderInput {
    Device& device;
    const SceneData& data;
    const GpuScene& scene;
    const Camera& camera;
    FilledLight& light;  ///< filled by the first renderer that needs it
};

std::unique_ptr<Renderer> make_renderer(const Method& method, const RenderInput& input,
                                        const RenderSettings& settings, const MapSettings& maps);

}  // namespace utsuri
