// SPDX-License-Identifier: Apache-2.0
#include "renderers/methods/method.h"

#include "base/error.h"

#include <fmt/format.h>

namespace utsuri {
namespace {

template <typename Entry>
const Entry& find_by_name(std::span<const Entry> entries, std::string_view name, std::string_view axis) {
    std::string names;
    for (const Entry& entry : entries) {
        if (entry.name == name) return entry;
        names += fmt::format("{}{}", names.empty() ? "" : ", ", entry.name);
    }
    throw UsageError(fmt::format("choose {}", axis), fmt::format("'{}'", name),
                     fmt::format("there {}: {}", entries.size() == 1 ? "is" : "are", names));
}

template <typename Entry>
std::string list_entries(std::span<const Entry> entries) {
    std::string text;
    for (const Entry& entry : entries)
        text += fmt::format("{}{} ({})", text.empty() ? "" : ", ", entry.name, entry.summary);
    return text;
}

}  // namespace

const LightMethod& find_light(std::string_view name) {
    return find_by_name(light_methods(), name, "light");
}

const ReflectionMethod& find_reflection(std::string_view name) {
    return find_by_name(reflection_methods(), name, "reflection");
}

std::string method_name(const Method& method) {
    return fmt::format("{}/{}", method.light->name, method.reflection->name);
}

Method find_method(std::string_view light, std::string_view reflection) {
    return {&find_light(light), &find_reflection(reflection)};
}

std::vector<Method> all_methods(const LightMethod& light) {
    std::vector<Method> methods;
    for (const ReflectionMethod& reflection : reflection_methods())
        methods.push_back({&light, &reflection});
    return methods;
}

std::unique_ptr<Renderer> make_renderer(const Method& method, const RendererInput& input,
                                        const RenderSettings& settings, const MapSettings& maps) {
    return method.reflection->make(input, settings, maps);
}

std::string list_lights() {
    return list_entries(light_methods());
}

std::string list_reflections() {
    return list_entries(reflection_methods());
}

}  // namespace utsuri
