// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/common/film_kernel.h"
#include "renderers/common/gpu_scene.h"
#include "renderers/common/light_cache.h"
#include "renderers/common/renderer.h"
#include "renderers/reflection_map/polyhedron.h"
#include "renderers/reflection_map/probes.h"
#include "renderers/reflection_map/proxy.h"
#include "renderers/reflection_map/reflector_drawer.h"
#include "renderers/reflection_map/reflectors.h"
#include "renderers/reflection_map/tolerance.h"

#include "base/progress.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace utsuri {

struct MapSettings {
    std::uint32_t size = 256;                                ///< texels along an edge of a map, [1, 4096]
    std::uint32_t samples = 16;                              ///< per texel, >= 1
    std::optional<glm::dvec3> capture_point = std::nullopt;  ///< world space; each reflector's own if not set
    std::uint32_t most_probes = 1;                   ///< capture points of a reflector, [1, kMostProbes]
    Polyhedron polyhedron = cube();                  ///< of polygon maps
    std::optional<GivenProxy> proxy = std::nullopt;  ///< fitted to what each reflector sees if not set
    PolygonRefinement refinement = {};
    /// Pieces of polygons cut along its faces that there is room for; polygons whose pieces find none are
    /// drawn whole, their faces found per pixel. Follows from the number of polygons if not set.
    std::optional<std::uint32_t> most_cut_pieces = std::nullopt;
    Tolerance tolerance = {};      ///< of MapKind::hybrid
    bool predicts_errors = false;  ///< keep what MapRenderer::predict_errors() needs, whatever the method
};

/// Maps captured for every reflective instance by the tracing kernel, without the instance itself, from one
/// probe or several.
class ReflectionMaps {
  public:
    /// @throws UsageError if the maps cannot fit into one buffer of the device, with the largest size that
    /// would
    ReflectionMaps(Device& device, const SceneData& data, MapKind kind, const MapSettings& settings);
    /// @param instances that get maps, ascending
    ReflectionMaps(Device& device, const SceneData& data, MapKind kind, const MapSettings& settings,
                   const std::vector<std::uint32_t>& instances);

    /// Renders the maps.
    /// @param light filled
    /// @param eye whose axes orient sphere maps
    /// @param seconds_to_compile is set to the time of the capturing pipeline
    FrameCounts capture(const GpuScene& scene, const LightCache& light, const Camera& eye,
                        const RenderSettings& settings, double& seconds_to_compile, Progress& progress);

    [[nodiscard]] const Reflectors& reflectors() const { return reflectors_; }
    /// Of each probe: those of a reflector follow one another.
    [[nodiscard]] const std::vector<interop::ReflectorInfo>& infos() const { return infos_; }
    [[nodiscard]] const std::vector<Probe>& probes() const { return probes_; }
    /// The instance that each probe belongs to.
    [[nodiscard]] std::vector<std::uint32_t> instances() const;
    [[nodiscard]] Bindings bindings() const;
    /// What stages that look the maps up are told about them, added to others.
    [[nodiscard]] Specialization specialise(Specialization others) const;

    /// The texels of one map, border included, as a picture.
    [[nodiscard]] Image map(std::uint32_t probe, std::uint32_t face) const;
    [[nodiscard]] std::uint32_t maps_per_probe() const;
    /// Of the proxies that are not boxes.
    [[nodiscard]] const std::vector<interop::ProxyPlane>& proxy_planes() const { return proxy_planes_; }
    /// Of the polyhedron of maps; none for sphere maps.
    [[nodiscard]] const std::vector<interop::MapFace>& faces() const { return faces_; }

  private:
    [[nodiscard]] std::uint32_t stride() const { return settings_.size + 2 * interop::MAP_BORDER; }
    [[nodiscard]] interop::CameraInfo map_camera(std::uint32_t probe, std::uint32_t face,
                                                 const Camera& eye) const;

    Device* device_;
    MapKind kind_;
    MapSettings settings_;
    Reflectors reflectors_;
    std::vector<interop::MapFace> faces_;
    std::vector<interop::ProxyPlane> proxy_planes_;
    std::vector<Probe> probes_;
    std::vector<interop::ReflectorInfo> infos_;
    Buffer info_buffer_;
    std::uint32_t most_probes_;  ///< of one reflector, that there are
    Buffer ranges_;
    Buffer proxy_plane_buffer_;
    Buffer texels_;
};

}  // namespace utsuri
