// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/gpu_scene.h"
#include "renderers/film/render_settings.h"
#include "renderers/light/surface_light.h"
#include "renderers/reflection/glossy/glossy_map_plan.h"
#include "renderers/reflection/glossy/map_prefilter.h"
#include "renderers/reflection/proxies/proxy.h"
#include "renderers/reflection/reflectors/map_kind.h"

#include "base/progress.h"
#include "image/image.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace utsuri {

struct GlossyMapSettings {
    std::uint32_t size = 256;    ///< texels along an edge of a face of what is captured, at most
    std::uint32_t samples = 16;  ///< per texel, >= 1
    std::optional<glm::dvec3> capture_point = std::nullopt;  ///< world space; each instance's own if not set
    std::uint32_t most_probes = 1;                   ///< capture points of an instance, [1, kMostProbes]
    MapKind kind = MapKind::cube;                    ///< how they are looked up
    std::optional<GivenProxy> proxy = std::nullopt;  ///< fitted to what each instance sees if not set
    bool shares_room = true;                         ///< as MapSettings has it: all smaller, by halves
};

/// What glossy lobes reflect: for every instance that has some, cubes of maps captured without it from one
/// point or several, and convolved with the lobe at as many steps of roughness as the instance has. Where
/// they are to tell places, so is one over the distance of what the lobe sees.
class GlossyMaps {
  public:
    /// @throws UsageError if the maps cannot fit into one buffer of the device
    /// @param proxy_planes where the planes of proxies that are no boxes are put, behind those of others
    GlossyMaps(Device& device, const SceneData& data, const GlossyMapSettings& settings,
               std::vector<interop::ProxyPlane>& proxy_planes);

    /// Captures and convolves the maps.
    /// @param light filled
    /// @param seconds_to_compile is increased by the time of the pipelines
    FrameCounts capture(const GpuScene& scene, const SurfaceLight& light, const RenderSettings& settings,
                        double& seconds_to_compile, Progress& progress);

    [[nodiscard]] Bindings bindings() const;
    [[nodiscard]] const GlossyMapPlan& plan() const { return plan_; }

    /// The texels of one face of a level, border included, as a picture, for tests.
    [[nodiscard]] Image face(std::uint32_t level, std::uint32_t face) const;
    /// One over the distance in metres of the same texels.
    [[nodiscard]] std::vector<float> inverse_distances(std::uint32_t level, std::uint32_t face) const;

  private:
    /// The maps of one probe.
    /// @param frame as MapPrefilter::capture() has it, of the probe's instance
    FrameCounts capture(MapPrefilter& prefilter, std::uint32_t probe, const FrameSettings& frame);
    /// Of a face of a level, border included.
    [[nodiscard]] std::uint32_t stride(std::uint32_t level) const;
    [[nodiscard]] std::uint64_t first_texel(std::uint32_t level, std::uint32_t face) const;

    Device* device_;
    GlossyMapSettings settings_;
    GlossyMapPlan plan_;
    Buffer infos_;
    Buffer probes_;
    Buffer levels_;
    Buffer texels_;
    Buffer inverse_distances_;
};

}  // namespace utsuri
