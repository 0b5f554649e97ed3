// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/bvh.h"

#include "interop/rays.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace utsuri {

/// Embree over the triangles of a BVH, in device order: the oracle for hits in tests and the peer in
/// benchmarks.
class EmbreeOracle {
  public:
    enum class Mode {
        robust,  ///< RTC_SCENE_FLAG_ROBUST: watertight, for comparing hits
        fast     ///< Embree's default, for comparing rates
    };

    explicit EmbreeOracle(std::span<const interop::BvhTriangle> triangles, Mode mode);
    EmbreeOracle(const EmbreeOracle&) = delete;
    EmbreeOracle& operator=(const EmbreeOracle&) = delete;
    ~EmbreeOracle();

    /// Closest hits by rtcIntersect1, one ray at a time, over `threads` threads. RayInfo::excluded is not
    /// honoured.
    std::vector<interop::HitInfo> closest_hits(std::span<const interop::RayInfo> rays,
                                               unsigned threads) const;

    /// Whether each ray hits anything, by rtcOccluded1.
    std::vector<std::uint8_t> occlusions(std::span<const interop::RayInfo> rays, unsigned threads) const;

    /// Embree's version, for example "3.13.5".
    static std::string version();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace utsuri
