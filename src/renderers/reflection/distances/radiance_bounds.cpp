// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/distances/radiance_bounds.h"

#include "renderers/reflection/distances/face_kernels.h"
#include "renderers/reflection/distances/measured_faces.h"

#include "base/error.h"
#include "base/stopwatch.h"

#include "interop/bindings.h"
#include "interop/specialization.h"
#include "kernels/bound_radiance.h"
#include "kernels/measure_radiance.h"
#include "kernels/reduce_radiance.h"

#include <fmt/format.h>
#include <glm/vec3.hpp>

#include <algorithm>

namespace utsuri {
namespace {

/// Of the darkest, and of the brightest, of all blocks.
std::uint64_t bytes_of_bounds(const Device& device, std::size_t probes, std::uint32_t size) {
    const std::uint64_t bytes =
        std::uint64_t{probes} * interop::DISTANCE_FACES * bounds_per_face(size) * sizeof(glm::vec3);
    const std::uint64_t limit = device.summary().storage_range_bytes;
    if (bytes > limit) {
        throw UsageError(
            "bound radiance", fmt::format("at {} texels from {} capture points", size, probes),
            fmt::format(
                "that needs {} MiB and {} can see {} MiB of a buffer; use fewer --probes, or a --tolerance "
                "in pixels",
                bytes >> 20, device.summary().name, limit >> 20));
    }
    return std::max<std::uint64_t>(bytes, sizeof(glm::vec3));
}

}  // namespace

RadianceBounds::RadianceBounds(Device& device, std::vector<std::uint32_t> instances,
                               const std::vector<interop::ProbeInfo>& infos, std::uint32_t size)
    : device_(&device),
      instances_(std::move(instances)),
      probes_(infos),
      size_(size),
      samples_(device, samples_per_face(size) * sizeof(interop::RadianceSample), "radiance of a face"),
      darkest_(device, bytes_of_bounds(device, infos.size(), size), "darkest of blocks"),
      brightest_(device, bytes_of_bounds(device, infos.size(), size), "brightest of blocks"),
      captured_(infos.size() * interop::DISTANCE_FACES) {}

void RadianceBounds::reuse_from(RadianceBounds& previous) {
    if (previous.size_ != size_ || previous.probes_.size() != probes_.size()) return;
    darkest_ = std::move(previous.darkest_);
    brightest_ = std::move(previous.brightest_);
    for (std::size_t face = 0; face < captured_.size(); ++face) {
        const std::size_t probe = face / interop::DISTANCE_FACES;
        captured_[face] = previous.captured_[face] && previous.instances_[probe] == instances_[probe] &&
                          previous.probes_[probe].capture_point == probes_[probe].capture_point;
    }
}

void RadianceBounds::forget(const SeenChanges& changes) {
    if (changes.empty()) return;
    forget_faces(captured_, probes_, size_, [&](const ViewPyramid& view, std::size_t probe) {
        return changes.appearance_may_change_in(view, instances_[probe]);
    });
}

FrameCounts RadianceBounds::capture(const GpuScene& scene, const SurfaceLight& light,
                                    double& seconds_to_compile, Progress& progress) {
    FrameCounts counts;
    if (std::find(captured_.begin(), captured_.end(), false) == captured_.end()) return counts;
    const Stopwatch stopwatch;
    Specialization specialization = scene.specialization();
    specialization[interop::SPEC_EXCLUDES_INSTANCE] = 1;
    specialization[interop::SPEC_DISTANCE_SIZE] = size_;
    Bindings bindings = scene.bindings();
    bindings.merge(light.bindings());
    bindings.merge(this->bindings());
    bindings[interop::BINDING_RADIANCE_SAMPLES] = &samples_;
    FaceKernels<interop::MeasureRadiancePush> face_kernels(
        *device_, {"measure_radiance", kernels::measure_radiance},
        {"bound_radiance", kernels::bound_radiance}, {"reduce_radiance", kernels::reduce_radiance},
        specialization, bindings);
    seconds_to_compile += stopwatch.seconds();

    const auto faces = static_cast<std::uint32_t>(probes_.size()) * interop::DISTANCE_FACES;
    for (std::uint32_t i = 0; i < faces; ++i) {
        if (progress.cancelled()) throw Interrupted();
        if (captured_[i]) continue;
        const std::uint32_t probe = i / interop::DISTANCE_FACES;
        interop::MeasureRadiancePush push{};
        push.capture_point = probes_[probe].capture_point;
        push.excluded_instance = instances_[probe];
        push.face = i % interop::DISTANCE_FACES;
        counts.gpu_seconds += face_kernels.run("radiance", push, size_, 0, i * bounds_per_face(size_));
        counts.rays += std::uint64_t{2} * samples_per_face(size_);
        captured_[i] = true;
        progress.update(i + 1, faces);
    }
    return counts;
}

Bindings RadianceBounds::bindings() const {
    return {{interop::BINDING_DARKEST, &darkest_}, {interop::BINDING_BRIGHTEST, &brightest_}};
}

}  // namespace utsuri
