// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/common/film_kernel.h"
#include "renderers/common/gpu_scene.h"
#include "renderers/common/renderer.h"
#include "renderers/reflection_map/reflectors.h"

#include "base/progress.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace utsuri {

enum class MapKind {
    polygon,  ///< a cube of maps in world space
    sphere    ///< one OpenGL 1.x sphere map in eye space
};

struct MapSettings {
    std::uint32_t size = 256;                 ///< texels along an edge of a map, [1, 4096]
    std::uint32_t samples = 16;               ///< per texel, >= 1
    std::optional<glm::dvec3> capture_point;  ///< world space; each reflector's own if not set
};

/// Maps captured for every reflective instance by the tracing kernel, without the instance itself.
class ReflectionMaps {
  public:
    /// @throws UsageError if the maps cannot fit into one buffer of the device, with the largest size that
    /// would
    ReflectionMaps(Device& device, const SceneData& data, MapKind kind, const MapSettings& settings);

    /// Renders the maps.
    /// @param eye whose axes orient sphere maps
    /// @param seconds_to_compile is set to the time of the capturing pipeline
    FrameCounts capture(const GpuScene& scene, const Camera& eye, const RenderSettings& settings,
                        double& seconds_to_compile, Progress& progress);

    [[nodiscard]] const Reflectors& reflectors() const { return reflectors_; }
    [[nodiscard]] const std::vector<interop::ReflectorInfo>& infos() const { return infos_; }
    [[nodiscard]] Bindings bindings() const;

    /// The texels of one map, border included, as a picture.
    [[nodiscard]] Image map(std::uint32_t reflector, std::uint32_t face) const;
    [[nodiscard]] std::uint32_t maps_per_reflector() const { return kind_ == MapKind::polygon ? 6 : 1; }

  private:
    [[nodiscard]] std::uint32_t stride() const { return settings_.size + 2 * interop::MAP_BORDER; }
    [[nodiscard]] interop::CameraInfo map_camera(std::uint32_t reflector, std::uint32_t face,
                                                 const Camera& eye) const;

    Device* device_;
    MapKind kind_;
    MapSettings settings_;
    Reflectors reflectors_;
    std::vector<interop::ReflectorInfo> infos_;
    Buffer instance_reflectors_;
    Buffer reflector_infos_;
    Buffer vertex_slots_;
    Buffer texels_;
};

}  // namespace utsuri
