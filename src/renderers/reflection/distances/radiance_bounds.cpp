// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/distances/radiance_bounds.h"

#include "renderers/reflection/distances/face_kernels.h"

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
#include <span>

namespace utsuri {
namespace {

/// Of the darkest, and of the brightest, of all blocks.
std::uint64_t bytes_of_bounds(const Device& device, const MeasuredFaces& faces) {
    const std::size_t probes = faces.views().size();
    const std::uint64_t bytes =
        std::uint64_t{probes} * interop::DISTANCE_FACES * bounds_per_face(faces.size()) * sizeof(glm::vec3);
    const std::uint64_t limit = device.summary().storage_range_bytes;
    if (bytes > limit) {
        throw UsageError(
            "bound radiance", fmt::format("at {} texels from {} capture points", faces.size(), probes),
            fmt::format(
                "that needs {} MiB and {} can see {} MiB of a buffer; use fewer --probes, or a --tolerance "
                "in pixels",
                bytes >> 20, device.summary().name, limit >> 20));
    }
    return std::max<std::uint64_t>(bytes, sizeof(glm::vec3));
}

}  // namespace

RadianceBounds::RadianceBounds(Device& device, const MeasuredFaces& faces)
    : device_(&device),
      faces_(faces.unmeasured()),
      samples_(device, samples_per_face(faces.size()) * sizeof(interop::RadianceSample),
               "radiance of a face"),
      darkest_(device, bytes_of_bounds(device, faces), "darkest of blocks"),
      brightest_(device, bytes_of_bounds(device, faces), "brightest of blocks") {}

void RadianceBounds::reuse_from(RadianceBounds& previous) {
    if (!faces_.are_stored_as(previous.faces_)) return;
    darkest_ = std::move(previous.darkest_);
    brightest_ = std::move(previous.brightest_);
    faces_.reuse_from(previous.faces_);
}

void RadianceBounds::forget(const SeenChanges& changes) {
    if (changes.empty()) return;
    faces_.forget([&](const ViewPyramid& view, std::uint32_t without) {
        return changes.appearance_may_change_in(view, without);
    });
}

FrameCounts RadianceBounds::capture(const GpuScene& scene, const SurfaceLight& light,
                                    double& seconds_to_compile, Progress& progress) {
    FrameCounts counts;
    if (faces_.are_complete()) return counts;
    const Stopwatch stopwatch;
    const std::uint32_t size = faces_.size();
    Specialization specialization = scene.specialization();
    specialization[interop::SPEC_EXCLUDES_INSTANCE] = 1;
    specialization[interop::SPEC_DISTANCE_SIZE] = size;
    Bindings bindings = scene.bindings();
    bindings.merge(light.bindings());
    bindings.merge(this->bindings());
    bindings[interop::BINDING_RADIANCE_SAMPLES] = &samples_;
    FaceKernels face_kernels(*device_, {"measure_radiance", kernels::measure_radiance},
                             {"bound_radiance", kernels::bound_radiance},
                             {"reduce_radiance", kernels::reduce_radiance}, specialization, bindings);
    seconds_to_compile += stopwatch.seconds();
    faces_.measure_missing(progress, [&](const interop::MeasureFacePush& push, std::uint32_t probe) {
        const std::uint32_t face = probe * interop::DISTANCE_FACES + push.face;
        counts.gpu_seconds += face_kernels.run("radiance", push, size, face * bounds_per_face(size));
        counts.rays += std::uint64_t{2} * samples_per_face(size);
    });
    return counts;
}

std::vector<RadianceBounds::Block> RadianceBounds::blocks(std::uint32_t probe, std::uint32_t face,
                                                          std::uint32_t level) const {
    const std::uint32_t size = faces_.size();
    const std::size_t count = std::size_t{size >> level} * (size >> level);
    const std::uint64_t first =
        (std::uint64_t{probe} * interop::DISTANCE_FACES + face) * bounds_per_face(size) +
        first_of_level(size, level);
    std::vector<glm::vec3> darkest(count);
    std::vector<glm::vec3> brightest(count);
    darkest_.download(std::as_writable_bytes(std::span(darkest)), first * sizeof(glm::vec3));
    brightest_.download(std::as_writable_bytes(std::span(brightest)), first * sizeof(glm::vec3));
    std::vector<Block> blocks;
    blocks.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
        blocks.push_back({darkest[i], brightest[i]});
    return blocks;
}

Bindings RadianceBounds::bindings() const {
    return {{interop::BINDING_DARKEST, &darkest_}, {interop::BINDING_BRIGHTEST, &brightest_}};
}

}  // namespace utsuri
