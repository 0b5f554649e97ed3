// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/gpu_scene.h"
#include "renderers/film/frame_counts.h"
#include "renderers/reflection/distances/measured_faces.h"
#include "renderers/reflection/reflectors/tolerance.h"

#include "base/progress.h"

#include "interop/distance_map.h"
#include "interop/reflection.h"

#include <cstdint>
#include <set>
#include <vector>

namespace utsuri {

/// How far what surrounds each reflector is from its capture points, by direction, with bounds over ever
/// larger blocks of directions: what a search for the place that a reflected ray meets needs to know.
class DistanceMaps {
  public:
    /// @param size texels along an edge of a face, a power of two
    /// @param tolerance whose errors the distances are to tell: of radiance, only what looks the same from
    /// everywhere tells any
    /// @param data must outlive this
    /// @param instances that each of the probes belongs to
    /// @throws UsageError if they cannot fit into one buffer of the device
    DistanceMaps(Device& device, const SceneData& data, const std::vector<std::uint32_t>& instances,
                 const std::vector<interop::ProbeInfo>& infos, std::uint32_t size,
                 Tolerance::Of tolerance = Tolerance::Of::place);

    /// Takes distances over from those of the scene before it changed, where they are as many and as fine:
    /// of the capture points that stay where they are.
    void reuse_from(DistanceMaps& previous);
    /// Drops what a change may have changed.
    void forget(const SeenChanges& changes);

    /// Traces the distances that are not there, and bounds them; finds horizons.
    /// @param seconds_to_compile is increased by the time of the pipelines
    FrameCounts capture(const GpuScene& scene, double& seconds_to_compile, Progress& progress);

    [[nodiscard]] Bindings bindings() const;
    [[nodiscard]] std::uint32_t size() const { return faces_.size(); }
    [[nodiscard]] const MeasuredFaces& faces() const { return faces_; }
    [[nodiscard]] const std::vector<interop::DistanceMapInfo>& infos() const { return infos_; }

    /// Samples of a face, border included, and bounds of a level, for tests.
    [[nodiscard]] std::vector<interop::DistanceSample> samples(std::uint32_t probe, std::uint32_t face) const;
    [[nodiscard]] std::vector<interop::DistanceBounds> bounds(std::uint32_t probe, std::uint32_t face,
                                                              std::uint32_t level) const;

    /// Texels along an edge for reflection maps of a size: the power of two that is next to it upwards,
    /// within kLargestDistanceMap.
    static std::uint32_t size_for(std::uint32_t map_size);
    /// The same, halved until what is kept about a number of probes fits into buffers of a size: a search in
    /// coarser distances asks for more rays, and is as right.
    static std::uint32_t size_for(std::uint32_t map_size, std::size_t probes, std::uint64_t buffer_bytes);
    /// Device memory for one probe, in bytes; beside it, all of a scene take a float for each triangle.
    static std::uint64_t bytes(std::uint32_t size);

  private:
    void find_horizons();

    Device* device_;
    const SceneData* data_;
    MeasuredFaces faces_;
    Tolerance::Of tolerance_;
    std::vector<interop::DistanceMapInfo> infos_;
    Buffer info_buffer_;
    std::vector<float> horizons_;            ///< self_horizons() of each triangle of the scene
    std::set<std::uint32_t> with_horizons_;  ///< instances whose own are there
    Buffer horizon_buffer_;
    Buffer samples_;
    Buffer bounds_;
};

/// Beyond this they would only tell apart what no map shows.
inline constexpr std::uint32_t kLargestDistanceMap = 1024;

}  // namespace utsuri
