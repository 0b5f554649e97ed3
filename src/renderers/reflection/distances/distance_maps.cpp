// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/distances/distance_maps.h"

#include "renderers/reflection/distances/face_kernels.h"
#include "renderers/reflection/distances/measured_faces.h"
#include "renderers/reflection/reflectors/reflector_plane.h"
#include "renderers/reflection/reflectors/self_horizon.h"
#include "renderers/scene/scene_triangles.h"

#include "base/error.h"
#include "base/same_bits.h"
#include "base/stopwatch.h"

#include "interop/bindings.h"
#include "interop/specialization.h"
#include "kernels/bound_distances.h"
#include "kernels/measure_distances.h"
#include "kernels/reduce_bounds.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <span>
#include <utility>

namespace utsuri {
namespace {

std::vector<interop::DistanceMapInfo> place_maps(const Device& device, const SceneData& data,
                                                 const std::vector<std::uint32_t>& instances,
                                                 const std::vector<interop::ProbeInfo>& infos,
                                                 std::uint32_t size) {
    const std::uint64_t samples =
        std::uint64_t{infos.size()} * interop::DISTANCE_FACES * samples_per_face(size);
    const std::uint64_t limit = device.summary().storage_range_bytes;
    if (samples * sizeof(interop::DistanceSample) > limit) {
        throw UsageError(
            "measure distances", fmt::format("at {} texels from {} capture points", size, infos.size()),
            fmt::format("they need {} MiB and {} can see {} MiB of a buffer; use fewer --probes",
                        samples * sizeof(interop::DistanceSample) >> 20, device.summary().name, limit >> 20));
    }
    std::vector<interop::DistanceMapInfo> maps;
    for (std::uint32_t i = 0; i < infos.size(); ++i) {
        interop::DistanceMapInfo map{};
        map.first_sample = i * interop::DISTANCE_FACES * samples_per_face(size);
        map.first_bounds = i * interop::DISTANCE_FACES * bounds_per_face(size);
        if (const std::optional<MirrorPlane> plane = plane_of(data, instances[i])) {
            map.plane_normal = glm::vec3(plane->normal);
            map.plane_distance = static_cast<float>(plane->distance);
        }
        maps.push_back(map);
    }
    return maps;
}

std::vector<float> horizons_of(const SceneData& data, const std::vector<std::uint32_t>& triangles) {
    std::vector<Corners> surface;
    surface.reserve(triangles.size());
    for (const std::uint32_t triangle : triangles)
        surface.push_back(corners_of(data, triangle));
    return self_horizons(surface);
}

template <typename Record>
std::uint64_t kept_bytes(std::size_t probes, std::uint32_t records_per_face) {
    return std::max<std::uint64_t>(1, std::uint64_t{probes} * interop::DISTANCE_FACES * records_per_face) *
           sizeof(Record);
}

}  // namespace

std::uint32_t DistanceMaps::size_for(std::uint32_t map_size) {
    return std::min(std::bit_ceil(map_size), kLargestDistanceMap);
}

std::uint32_t DistanceMaps::size_for(std::uint32_t map_size, std::size_t probes, std::uint64_t buffer_bytes) {
    std::uint32_t size = size_for(map_size);
    const auto fits = [&] {
        // Of bounds those of radiance are larger than those of distances.
        return std::max(kept_bytes<interop::DistanceSample>(probes, samples_per_face(size)),
                        kept_bytes<glm::vec3>(probes, bounds_per_face(size))) <= buffer_bytes;
    };
    while (size > 1 && !fits())
        size /= 2;
    return size;
}

std::uint64_t DistanceMaps::bytes(std::uint32_t size) {
    return interop::DISTANCE_FACES * (samples_per_face(size) * sizeof(interop::DistanceSample) +
                                      bounds_per_face(size) * sizeof(interop::DistanceBounds));
}

DistanceMaps::DistanceMaps(Device& device, const SceneData& data, std::vector<std::uint32_t> instances,
                           const std::vector<interop::ProbeInfo>& infos, std::uint32_t size,
                           Tolerance::Of tolerance)
    : device_(&device),
      data_(&data),
      instances_(std::move(instances)),
      probes_(infos),
      size_(size),
      tolerance_(tolerance),
      infos_(place_maps(device, data, instances_, infos, size)),
      info_buffer_(make_buffer<interop::DistanceMapInfo>(device, infos_, "distance maps")),
      horizons_(data.triangle_infos.size()),
      horizon_buffer_(make_buffer<float>(device, horizons_, "horizons of reflectors")),
      samples_(device, kept_bytes<interop::DistanceSample>(infos.size(), samples_per_face(size)),
               "distances"),
      bounds_(device, kept_bytes<interop::DistanceBounds>(infos.size(), bounds_per_face(size)),
              "bounds of distances"),
      captured_(infos_.size() * interop::DISTANCE_FACES) {}

void DistanceMaps::reuse_from(DistanceMaps& previous) {
    horizons_ = std::move(previous.horizons_);
    with_horizons_ = std::move(previous.with_horizons_);
    if (!horizons_.empty()) horizon_buffer_.upload(std::as_bytes(std::span(horizons_)));
    if (previous.size_ != size_ || previous.infos_.size() != infos_.size() ||
        previous.tolerance_ != tolerance_)
        return;
    samples_ = std::move(previous.samples_);
    bounds_ = std::move(previous.bounds_);
    for (std::size_t face = 0; face < captured_.size(); ++face) {
        const std::size_t probe = face / interop::DISTANCE_FACES;
        captured_[face] = previous.captured_[face] && previous.instances_[probe] == instances_[probe] &&
                          previous.probes_[probe].capture_point == probes_[probe].capture_point &&
                          same_bits(previous.infos_[probe], infos_[probe]);
    }
}

void DistanceMaps::forget(const SeenChanges& changes) {
    if (changes.empty()) return;
    std::erase_if(with_horizons_, [&](std::uint32_t instance) { return changes.has_moved(instance); });
    forget_faces(captured_, probes_, size_, [&](const ViewPyramid& view, std::size_t probe) {
        return changes.surfaces_may_change_in(view, instances_[probe]);
    });
}

void DistanceMaps::find_horizons() {
    bool found = false;
    for (std::size_t i = 0; i < instances_.size(); ++i) {
        if (!with_horizons_.insert(instances_[i]).second || infos_[i].plane_normal != glm::vec3(0.0f))
            continue;
        const std::vector<std::uint32_t> triangles = triangles_of(*data_, instances_[i]);
        const std::vector<float> horizons = horizons_of(*data_, triangles);
        for (std::size_t t = 0; t < triangles.size(); ++t)
            horizons_[triangles[t]] = horizons[t];
        found = true;
    }
    if (found) horizon_buffer_.upload(std::as_bytes(std::span(horizons_)));
}

FrameCounts DistanceMaps::capture(const GpuScene& scene, double& seconds_to_compile, Progress& progress) {
    find_horizons();
    FrameCounts counts;
    if (std::find(captured_.begin(), captured_.end(), false) == captured_.end()) return counts;
    const Stopwatch stopwatch;
    Specialization specialization = scene.specialization();
    specialization[interop::SPEC_EXCLUDES_INSTANCE] = 1;
    specialization[interop::SPEC_DISTANCE_SIZE] = size_;
    specialization[interop::SPEC_MARKS_GLOSSY] = tolerance_ == Tolerance::Of::radiance ? 1 : 0;
    Bindings bindings = scene.bindings();
    bindings.merge(this->bindings());
    FaceKernels<interop::MeasureDistancesPush> face_kernels(
        *device_, {"measure_distances", kernels::measure_distances},
        {"bound_distances", kernels::bound_distances}, {"reduce_bounds", kernels::reduce_bounds},
        specialization, bindings);
    seconds_to_compile += stopwatch.seconds();

    const std::uint32_t per_face = samples_per_face(size_);
    const auto faces = static_cast<std::uint32_t>(infos_.size()) * interop::DISTANCE_FACES;
    for (std::uint32_t i = 0; i < faces; ++i) {
        if (progress.cancelled()) throw Interrupted();
        if (captured_[i]) continue;
        const std::uint32_t probe = i / interop::DISTANCE_FACES;
        const std::uint32_t face = i % interop::DISTANCE_FACES;
        const interop::DistanceMapInfo& map = infos_[probe];
        interop::MeasureDistancesPush push{};
        push.capture_point = probes_[probe].capture_point;
        push.plane_normal = map.plane_normal;
        push.plane_distance = map.plane_distance;
        push.excluded_instance = instances_[probe];
        push.first_sample = map.first_sample + face * per_face;
        push.face = face;
        const std::uint32_t first_bounds = map.first_bounds + face * bounds_per_face(size_);
        counts.gpu_seconds += face_kernels.run("distances", push, size_, push.first_sample, first_bounds);
        counts.rays += std::uint64_t{2} * per_face;
        captured_[i] = true;
        progress.update(i + 1, faces);
    }
    return counts;
}

Bindings DistanceMaps::bindings() const {
    return {{interop::BINDING_DISTANCE_MAPS, &info_buffer_},
            {interop::BINDING_SELF_HORIZONS, &horizon_buffer_},
            {interop::BINDING_DISTANCE_SAMPLES, &samples_},
            {interop::BINDING_DISTANCE_BOUNDS, &bounds_}};
}

std::vector<interop::DistanceSample> DistanceMaps::samples(std::uint32_t probe, std::uint32_t face) const {
    std::vector<interop::DistanceSample> result(samples_per_face(size_));
    const std::uint64_t first = infos_[probe].first_sample + std::uint64_t{face} * result.size();
    samples_.download(std::as_writable_bytes(std::span(result)), first * sizeof(interop::DistanceSample));
    return result;
}

std::vector<interop::DistanceBounds> DistanceMaps::bounds(std::uint32_t probe, std::uint32_t face,
                                                          std::uint32_t level) const {
    const std::uint32_t edge = size_ >> level;
    std::vector<interop::DistanceBounds> result(std::size_t{edge} * edge);
    const std::uint64_t first = infos_[probe].first_bounds + std::uint64_t{face} * bounds_per_face(size_) +
                                first_of_level(size_, level);
    bounds_.download(std::as_writable_bytes(std::span(result)), first * sizeof(interop::DistanceBounds));
    return result;
}

}  // namespace utsuri
