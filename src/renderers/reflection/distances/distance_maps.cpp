// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/distances/distance_maps.h"

#include "renderers/device_scene/scene_triangles.h"
#include "renderers/reflection/distances/face_kernels.h"
#include "renderers/reflection/reflectors/self_horizon.h"

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

std::vector<interop::DistanceMapInfo> place_maps(const Device& device, const MeasuredFaces& faces) {
    const std::size_t probes = faces.views().size();
    const std::uint32_t size = faces.size();
    const std::uint64_t samples = std::uint64_t{probes} * interop::DISTANCE_FACES * samples_per_face(size);
    const std::uint64_t limit = device.summary().storage_range_bytes;
    if (samples * sizeof(interop::DistanceSample) > limit) {
        throw UsageError(
            "measure distances", fmt::format("at {} texels from {} capture points", size, probes),
            fmt::format("they need {} MiB and {} can see {} MiB of a buffer; use fewer --probes",
                        samples * sizeof(interop::DistanceSample) >> 20, device.summary().name, limit >> 20));
    }
    std::vector<interop::DistanceMapInfo> maps;
    maps.reserve(probes);
    for (std::uint32_t i = 0; i < probes; ++i) {
        const interop::MeasuredView& view = faces.views()[i];
        maps.push_back({i * interop::DISTANCE_FACES * samples_per_face(size),
                        i * interop::DISTANCE_FACES * bounds_per_face(size), view.plane_normal,
                        view.plane_distance});
    }
    return maps;
}

std::vector<float> horizons_of(const SceneData& data, std::span<const std::uint32_t> triangles) {
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

DistanceMaps::DistanceMaps(Device& device, const SceneData& data, const std::vector<std::uint32_t>& instances,
                           const std::vector<interop::ProbeInfo>& infos, std::uint32_t size,
                           Tolerance::Of tolerance)
    : device_(&device),
      data_(&data),
      faces_(data, instances, infos, size),
      tolerance_(tolerance),
      infos_(place_maps(device, faces_)),
      info_buffer_(make_buffer<interop::DistanceMapInfo>(device, infos_, "distance maps")),
      horizons_(data.triangle_infos.size()),
      horizon_buffer_(make_buffer<float>(device, horizons_, "horizons of reflectors")),
      samples_(device, kept_bytes<interop::DistanceSample>(infos.size(), samples_per_face(size)),
               "distances"),
      bounds_(device, kept_bytes<interop::DistanceBounds>(infos.size(), bounds_per_face(size)),
              "bounds of distances") {}

void DistanceMaps::reuse_from(DistanceMaps& previous) {
    horizons_ = std::move(previous.horizons_);
    with_horizons_ = std::move(previous.with_horizons_);
    if (!horizons_.empty()) horizon_buffer_.upload(std::as_bytes(std::span(horizons_)));
    if (!faces_.are_stored_as(previous.faces_) || previous.tolerance_ != tolerance_) return;
    samples_ = std::move(previous.samples_);
    bounds_ = std::move(previous.bounds_);
    faces_.reuse_from(previous.faces_);
}

void DistanceMaps::forget(const SeenChanges& changes) {
    if (changes.empty()) return;
    std::erase_if(with_horizons_, [&](std::uint32_t instance) { return changes.has_moved(instance); });
    faces_.forget([&](const ViewPyramid& view, std::uint32_t without) {
        return changes.surfaces_may_change_in(view, without);
    });
}

void DistanceMaps::find_horizons() {
    bool found = false;
    for (const interop::MeasuredView& view : faces_.views()) {
        // Nothing of a plane rises above it; an instance that a change bends is no plane, and has none yet.
        if (view.plane_normal != glm::vec3(0.0f) || !with_horizons_.insert(view.excluded_instance).second)
            continue;
        const std::span<const std::uint32_t> triangles = triangles_of(*data_, view.excluded_instance);
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
    if (faces_.are_complete()) return counts;
    const Stopwatch stopwatch;
    Specialization specialization = scene.specialization();
    specialization[interop::SPEC_EXCLUDES_INSTANCE] = 1;
    specialization[interop::SPEC_DISTANCE_SIZE] = size();
    specialization[interop::SPEC_MARKS_GLOSSY] = tolerance_ == Tolerance::Of::radiance ? 1 : 0;
    Bindings bindings = scene.bindings();
    bindings.merge(this->bindings());
    FaceKernels face_kernels(*device_, {"measure_distances", kernels::measure_distances},
                             {"bound_distances", kernels::bound_distances},
                             {"reduce_bounds", kernels::reduce_bounds}, specialization, bindings);
    seconds_to_compile += stopwatch.seconds();
    faces_.measure_missing(progress, [&](interop::MeasureFacePush push, std::uint32_t probe) {
        push.first_sample = infos_[probe].first_sample + push.face * samples_per_face(size());
        const std::uint32_t first_bounds = infos_[probe].first_bounds + push.face * bounds_per_face(size());
        counts.gpu_seconds += face_kernels.run("distances", push, size(), first_bounds);
        counts.rays += std::uint64_t{2} * samples_per_face(size());
    });
    return counts;
}

Bindings DistanceMaps::bindings() const {
    return {{interop::BINDING_DISTANCE_MAPS, &info_buffer_},
            {interop::BINDING_SELF_HORIZONS, &horizon_buffer_},
            {interop::BINDING_DISTANCE_SAMPLES, &samples_},
            {interop::BINDING_DISTANCE_BOUNDS, &bounds_}};
}

std::vector<interop::DistanceSample> DistanceMaps::samples(std::uint32_t probe, std::uint32_t face) const {
    std::vector<interop::DistanceSample> result(samples_per_face(size()));
    const std::uint64_t first = infos_[probe].first_sample + std::uint64_t{face} * result.size();
    samples_.download(std::as_writable_bytes(std::span(result)), first * sizeof(interop::DistanceSample));
    return result;
}

std::vector<interop::DistanceBounds> DistanceMaps::bounds(std::uint32_t probe, std::uint32_t face,
                                                          std::uint32_t level) const {
    const std::uint32_t edge = size() >> level;
    std::vector<interop::DistanceBounds> result(std::size_t{edge} * edge);
    const std::uint64_t first = infos_[probe].first_bounds + std::uint64_t{face} * bounds_per_face(size()) +
                                first_of_level(size(), level);
    bounds_.download(std::as_writable_bytes(std::span(result)), first * sizeof(interop::DistanceBounds));
    return result;
}

}  // namespace utsuri
