// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/reflection/maps/seen_changes.h"

#include "interop/distance_map.h"
#include "interop/reflection.h"

#include <cstdint>
#include <vector>

namespace utsuri {

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

}  // namespace utsuri
