// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/reflection/distances/distance_levels.h"
#include "renderers/reflection/maps/seen_changes.h"

#include "gpu/dispatch_budget.h"
#include "gpu/kernel.h"

#include "interop/reflection.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace utsuri {

/// Invocations of a workgroup of the kernels that measure and bound faces about capture points.
inline constexpr std::uint32_t kBoundsGroupSize = 64;

inline std::uint32_t bounds_groups(std::uint32_t invocations) {
    return (invocations + kBoundsGroupSize - 1) / kBoundsGroupSize;
}

/// Runs a kernel over the samples of a face, in dispatches that fit the budget.
/// @param push whose begin and end are the samples of a dispatch
/// @returns seconds on the device
template <typename Push>
double measure_samples(Device& device, const std::string& title, const Kernel& kernel, const BindingSet& set,
                       Push push, std::uint32_t samples, DispatchBudget& budget) {
    double sum = 0.0;
    for (push.begin = 0; push.begin < samples; push.begin = push.end) {
        const std::uint64_t fitting = std::clamp<std::uint64_t>(budget.next_units(), kBoundsGroupSize,
                                                                std::uint64_t{kMaxGroups} * kBoundsGroupSize);
        push.end = static_cast<std::uint32_t>(std::min<std::uint64_t>(samples, push.begin + fitting));
        const double seconds = device.run(title, [&](const vk::raii::CommandBuffer& commands) {
            kernel.dispatch(commands, set, push, bounds_groups(push.end - push.begin));
        });
        budget.record(push.end - push.begin, seconds);
        sum += seconds;
    }
    return sum;
}

/// Texels along the edge of a face from which on what its samples may show is told; those of coarser faces
/// are turned so far that they may see all around.
inline constexpr std::uint32_t kSmallestTestedSize = 32;

/// What the samples of a face and its border may show.
/// @param size texels along its edge, >= kSmallestTestedSize
inline ViewPyramid measured_face(const glm::vec3& capture_point, std::uint32_t face, std::uint32_t size) {
    // measure_distances.comp turns rays by at most 3 / size, and a turn moves a ray's place on the face,
    // whose half edge is 1, the more the farther it is from the middle: at a corner, sqrt(3) from the point,
    // three times as far, to first order. The rest, at most 1.35 in all at size 32, is within the texel that
    // samples at the corners of texels leave.
    const double wider = (2.0 * (interop::DISTANCE_BORDER + 1) + 9.0) / size;
    return ViewPyramid(glm::dvec3(capture_point), face, wider);
}

/// Marks those of the captured faces of probes as not captured that a change may have changed.
/// @param seen (view, probe): whether something of the change may be in a view
template <typename Seen>
void forget_faces(std::vector<bool>& captured, const std::vector<interop::ProbeInfo>& probes,
                  std::uint32_t size, const Seen& seen) {
    for (std::size_t i = 0; i < captured.size(); ++i) {
        const std::size_t probe = i / interop::DISTANCE_FACES;
        const auto face = static_cast<std::uint32_t>(i % interop::DISTANCE_FACES);
        if (size < kSmallestTestedSize || seen(measured_face(probes[probe].capture_point, face, size), probe))
            captured[i] = false;
    }
}

/// What bounds the samples of a face: the finest level, then each coarser one from that below.
struct BlockBounds {
    const Kernel& bound;
    const BindingSet& bound_set;
    const Kernel& reduce;
    const BindingSet& reduce_set;

    /// @param first_sample, first_bounds of the face
    /// @param size texels along its edge, a power of two
    /// @returns seconds on the device
    double run(Device& device, const std::string& title, std::uint32_t first_sample,
               std::uint32_t first_bounds, std::uint32_t size) const {
        return device.run(title, [&](const vk::raii::CommandBuffer& commands) {
            bound.dispatch(commands, bound_set, interop::BoundDistancesPush{first_sample, first_bounds, size},
                           bounds_groups(size * size));
            for (std::uint32_t level = 1; level < bound_levels(size); ++level) {
                const std::uint32_t edge = size >> level;
                const interop::BoundDistancesPush next{first_bounds + first_of_level(size, level - 1),
                                                       first_bounds + first_of_level(size, level), edge};
                reduce.dispatch(commands, reduce_set, next, bounds_groups(edge * edge));
            }
        });
    }
};

}  // namespace utsuri
