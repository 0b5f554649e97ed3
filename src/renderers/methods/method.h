// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/light/light.h"
#include "renderers/methods/reflection.h"

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace utsuri {

/// All there are, in the order of reports. The objects last as long as the program.
std::span<const LightMethod> light_methods();
std::span<const ReflectionMethod> reflection_methods();

/// @throws UsageError that lists the names there are
const LightMethod& find_light(std::string_view name);
const ReflectionMethod& find_reflection(std::string_view name);

/// A point on the two axes, written "direct/polygon-map".
struct Method {
    const LightMethod* light = &light_methods().front();
    const ReflectionMethod* reflection = &reflection_methods().front();

    friend bool operator==(const Method&, const Method&) = default;
};

std::string method_name(const Method& method);

/// By the names of its two sides.
/// @throws UsageError as above
Method find_method(std::string_view light, std::string_view reflection);

/// Every method with a light, in the order of reports.
std::vector<Method> all_methods(const LightMethod& light);

/// @param input of the method's light
std::unique_ptr<Renderer> make_renderer(const Method& method, const RendererInput& input,
                                        const RenderSettings& settings, const MapSettings& maps);

/// The names of an axis for help texts: "trace (rays followed), cube-map (...)".
std::string list_lights();
std::string list_reflections();

}  // namespace utsuri
