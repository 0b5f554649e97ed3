// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/film/render_settings.h"
#include "renderers/methods/renderer.h"
#include "renderers/methods/renderer_input.h"
#include "renderers/reflection/maps/map_settings.h"

#include <memory>
#include <string_view>

namespace utsuri {

/// What a reflection method can tell and be told, beside what all can.
struct ReflectionTraits {
    bool looks_up_maps = true;    ///< of some mirrors at least
    bool takes_probes = true;     ///< several capture points may lower its errors
    bool is_per_polygon = false;  ///< finer polygons lower its errors
    bool has_tolerance = false;   ///< MapSettings::tolerance: looks up at some pixels, traces at others
    bool predicts_errors = true;  ///< Renderer::predict_errors()
    bool has_polyhedron = true;   ///< of maps: captured without the eye's axes
};

/// A point on the reflection axis: how the light arriving along a specular direction is found. One object
/// each, listed in methods/reflections.cpp.
struct ReflectionMethod {
    std::string_view name;     ///< as on the command line: "cube-map"
    std::string_view summary;  ///< for help texts, in a few words
    ReflectionTraits traits;
    std::unique_ptr<Renderer> (*make)(const RendererInput& input, const RenderSettings& settings,
                                      const MapSettings& maps);
};

}  // namespace utsuri
