// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/distances/measured_faces.h"

#include "renderers/reflection/reflectors/reflector_plane.h"

#include "base/same_bits.h"

#include <algorithm>

namespace utsuri {
namespace {

/// Texels along the edge of a face from which on what its samples may show is told; those of coarser faces
/// are turned so far that they may see all around.
constexpr std::uint32_t kSmallestTestedSize = 32;

/// What the samples of a face and its border may show.
/// @param size texels along its edge, >= kSmallestTestedSize
ViewPyramid measured_face(const glm::vec3& capture_point, std::uint32_t face, std::uint32_t size) {
    // measured_hit.glsl turns rays by at most 3 / size, and a turn moves a ray's place on the face,
    // whose half edge is 1, the more the farther it is from the middle: at a corner, sqrt(3) from the point,
    // three times as far, to first order. The rest, at most 1.35 in all at size 32, is within the texel that
    // samples at the corners of texels leave.
    const double wider = (2.0 * (interop::DISTANCE_BORDER + 1) + 9.0) / size;
    return ViewPyramid(glm::dvec3(capture_point), face, wider);
}

}  // namespace

MeasuredFaces::MeasuredFaces(const SceneData& data, const std::vector<std::uint32_t>& instances,
                             const std::vector<interop::ProbeInfo>& probes, std::uint32_t size)
    : size_(size), measured_(probes.size() * interop::DISTANCE_FACES) {
    views_.reserve(probes.size());
    for (std::size_t i = 0; i < probes.size(); ++i) {
        interop::MeasuredView view{};
        view.capture_point = probes[i].capture_point;
        view.excluded_instance = instances[i];
        if (i > 0 && instances[i] == instances[i - 1]) {
            view.plane_normal = views_.back().plane_normal;
            view.plane_distance = views_.back().plane_distance;
        } else if (const auto plane = plane_of(data, instances[i])) {
            view.plane_normal = glm::vec3(plane->normal);
            view.plane_distance = static_cast<float>(plane->distance);
        }
        views_.push_back(view);
    }
}

MeasuredFaces MeasuredFaces::unmeasured() const {
    MeasuredFaces faces = *this;
    faces.measured_.assign(measured_.size(), false);
    return faces;
}

bool MeasuredFaces::are_stored_as(const MeasuredFaces& others) const {
    return size_ == others.size_ && views_.size() == others.views_.size();
}

void MeasuredFaces::reuse_from(const MeasuredFaces& previous) {
    for (std::size_t i = 0; i < measured_.size(); ++i) {
        const std::size_t probe = i / interop::DISTANCE_FACES;
        measured_[i] = previous.measured_[i] && same_bits(previous.views_[probe], views_[probe]);
    }
}

void MeasuredFaces::forget(const std::function<bool(const ViewPyramid&, std::uint32_t)>& seen) {
    for (std::size_t i = 0; i < measured_.size(); ++i) {
        if (!measured_[i]) continue;
        const interop::MeasuredView& view = views_[i / interop::DISTANCE_FACES];
        const auto face = static_cast<std::uint32_t>(i % interop::DISTANCE_FACES);
        if (size_ < kSmallestTestedSize ||
            seen(measured_face(view.capture_point, face, size_), view.excluded_instance))
            measured_[i] = false;
    }
}

bool MeasuredFaces::are_complete() const {
    return std::find(measured_.begin(), measured_.end(), false) == measured_.end();
}

}  // namespace utsuri
