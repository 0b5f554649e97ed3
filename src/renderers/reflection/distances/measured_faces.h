// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/reflection/maps/seen_changes.h"

#include "base/error.h"
#include "base/progress.h"

#include "interop/distance_map.h"
#include "interop/reflection.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace utsuri {

/// The faces of cubes about capture points that rays measure, and which of them are measured.
class MeasuredFaces {
  public:
    /// None is measured.
    /// @param instances that each of the probes belongs to
    /// @param size texels along the edge of a face, a power of two
    MeasuredFaces(const SceneData& data, const std::vector<std::uint32_t>& instances,
                  const std::vector<interop::ProbeInfo>& probes, std::uint32_t size);

    [[nodiscard]] const std::vector<interop::MeasuredView>& views() const { return views_; }
    [[nodiscard]] std::uint32_t size() const { return size_; }
    /// The same faces, none of them measured.
    [[nodiscard]] MeasuredFaces unmeasured() const;

    /// Whether what was measured of them is stored as of these: they are as many and as fine.
    [[nodiscard]] bool are_stored_as(const MeasuredFaces& others) const;
    /// Counts those as measured that were so before the scene changed, with a view that is still the same.
    /// @param previous stored as these
    void reuse_from(const MeasuredFaces& previous);
    /// Counts those as not measured in which something of a change may be seen.
    /// @param seen (view, instance that the view leaves out): whether something of it may be in the view
    void forget(const std::function<bool(const ViewPyramid&, std::uint32_t)>& seen);

    [[nodiscard]] bool are_complete() const;
    /// Calls measure(push, probe) for each face that is not measured, and counts it as measured then; begin,
    /// end and first_sample of the push are not set.
    /// @throws Interrupted if progress says so
    template <typename Measure>
    void measure_missing(Progress& progress, const Measure& measure) {
        for (std::uint32_t i = 0; i < measured_.size(); ++i) {
            if (progress.cancelled()) throw Interrupted();
            if (measured_[i]) continue;
            interop::MeasureFacePush push{};
            push.view = views_[i / interop::DISTANCE_FACES];
            push.face = i % interop::DISTANCE_FACES;
            measure(push, i / interop::DISTANCE_FACES);
            measured_[i] = true;
            progress.update(i + 1.0, static_cast<double>(measured_.size()));
        }
    }

  private:
    std::vector<interop::MeasuredView> views_;  ///< of each probe
    std::uint32_t size_;
    std::vector<bool> measured_;  ///< of each face of each probe
};

}  // namespace utsuri
