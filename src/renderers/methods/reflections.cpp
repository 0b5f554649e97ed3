// SPDX-License-Identifier: Apache-2.0
// The reflection axis: a new reflection is what renders it and a line here.
#include "renderers/methods/hybrid_tracer.h"
#include "renderers/methods/method.h"
#include "renderers/methods/raster_renderer.h"
#include "renderers/methods/ray_tracer.h"
#include "renderers/reflection/planar/plane_mirrors.h"

#include <array>

namespace utsuri {
namespace {

std::unique_ptr<Renderer> make_tracer(const RendererInput& input, const RenderSettings& settings,
                                      const MapSettings&) {
    return std::make_unique<RayTracer>(input, settings);
}

template <MapKind kind>
std::unique_ptr<Renderer> make_mapped(const RendererInput& input, const RenderSettings& settings,
                                      const MapSettings& maps) {
    return std::make_unique<RasterRenderer>(input, RasterMethod{kind, false}, settings, maps);
}

template <MapKind kind>
std::unique_ptr<Renderer> make_planar(const RendererInput& input, const RenderSettings& settings,
                                      const MapSettings& maps) {
    return std::make_unique<RasterRenderer>(input, RasterMethod{kind, true}, settings, maps);
}

/// Views mirrored in plane mirrors show everything where it is, so they keep any tolerance of place. They
/// look curved mirrors up by place alone: with a tolerance of radiance there are none.
std::unique_ptr<Renderer> make_hybrid(const RendererInput& input, const RenderSettings& settings,
                                      const MapSettings& maps) {
    if (costs_less_traced(input.data, settings)) return std::make_unique<HybridTracer>(input, settings);
    const bool draws_mirrored_views =
        maps.tolerance.of == Tolerance::Of::place && !find_plane_mirrors(input.data).mirrors.empty();
    return draws_mirrored_views ? make_planar<MapKind::hybrid>(input, settings, maps)
                                : make_mapped<MapKind::hybrid>(input, settings, maps);
}

constexpr ReflectionTraits kTraced{.looks_up_maps = false, .takes_probes = false, .predicts_errors = false};
constexpr ReflectionTraits kPerPixel{};
constexpr ReflectionTraits kPerPolygon{.is_per_polygon = true};
constexpr ReflectionTraits kInEyeSpace{.takes_probes = false, .has_polyhedron = false};
constexpr ReflectionTraits kPlanar{.takes_probes = false, .predicts_errors = false};
constexpr ReflectionTraits kHybrid{.has_tolerance = true};

}  // namespace

std::span<const ReflectionMethod> reflection_methods() {
    static constexpr std::array kReflections = {
        ReflectionMethod{"trace", "rays followed", kTraced, make_tracer},
        ReflectionMethod{"polygon-map", "maps on a polyhedron, found per polygon", kPerPolygon,
                         make_mapped<MapKind::polygon>},
        ReflectionMethod{"sphere-map", "OpenGL's fisheye map", kInEyeSpace, make_mapped<MapKind::sphere>},
        ReflectionMethod{"cube-map", "maps found per pixel", kPerPixel, make_mapped<MapKind::cube>},
        ReflectionMethod{"proxy-map", "the same, corrected by a box or planes", kPerPixel,
                         make_mapped<MapKind::proxy>},
        ReflectionMethod{"distance-map", "the same, corrected by distances", kPerPixel,
                         make_mapped<MapKind::distance>},
        ReflectionMethod{"planar", "plane mirrors drawn, the rest as by proxy-map", kPlanar,
                         make_planar<MapKind::proxy>},
        ReflectionMethod{"hybrid", "the cheapest that is right enough, else rays", kHybrid, make_hybrid}};
    return kReflections;
}

}  // namespace utsuri
