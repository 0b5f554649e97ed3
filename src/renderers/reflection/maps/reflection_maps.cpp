// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/maps/reflection_maps.h"

#include "base/error.h"

#include "interop/bindings.h"
#include "interop/specialization.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace utsuri {
namespace {

std::uint64_t texels_per_map(std::uint32_t size) {
    const std::uint64_t stride = std::uint64_t{size} + std::uint64_t{2} * interop::MAP_BORDER;
    return stride * stride;
}

/// Texels of all maps; throws where one buffer cannot hold them.
std::uint64_t total_texels(const Device& device, const std::vector<interop::ProbeInfo>& infos,
                           std::uint32_t maps, const MapSettings& settings) {
    std::uint64_t texels = 0;
    for (const interop::ProbeInfo& info : infos)
        texels += maps * texels_per_map(info.map_size);
    const std::uint64_t limit = device.summary().storage_range_bytes / sizeof(glm::vec3);
    if (texels > limit) {
        const double per_map =
            std::sqrt(static_cast<double>(limit) / (static_cast<double>(infos.size()) * maps));
        throw UsageError(
            "capture reflection maps",
            settings.fitted ? fmt::format("as fine as pixels, from {} capture points", infos.size())
                            : fmt::format("of {} texels from {} capture points", settings.size, infos.size()),
            fmt::format("they need {} MiB and {} can see {} MiB of a buffer; --map-size may be at most {}{}",
                        texels * sizeof(glm::vec3) >> 20, device.summary().name,
                        device.summary().storage_range_bytes >> 20,
                        std::max(1, static_cast<int>(per_map) - 2),
                        settings.most_probes > 1 ? ", or use fewer --probes" : ""));
    }
    return texels;
}

/// The angle that a texel covers where it covers most, of a map of one texel: of a sphere map, whose texels
/// grow without bound towards its rim, in its middle.
double texel_angle(MapKind kind, const std::vector<interop::MapFace>& faces) {
    if (kind == MapKind::sphere) return 4.0;
    double most = 0.0;
    for (const interop::MapFace& face : faces)
        most = std::max(most, static_cast<double>(face.half_diagonal * glm::length(face.outward)));
    return std::numbers::sqrt2 * most;
}

std::uint64_t texels_of(const std::vector<std::uint32_t>& sizes, std::size_t maps_per_probe) {
    std::uint64_t texels = 0;
    for (const std::uint32_t size : sizes)
        texels += maps_per_probe * texels_per_map(size);
    return texels;
}

std::vector<std::uint32_t> map_sizes(const Device& device, const SceneData& data,
                                     const Reflectors& reflectors, const std::vector<Probe>& probes,
                                     MapKind kind, const std::vector<interop::MapFace>& faces,
                                     const MapSettings& settings, const MapView& view) {
    const auto fitted = [&] {
        return fit_map_sizes(data, reflectors, probes, kind, view, texel_angle(kind, faces), settings.size);
    };
    std::vector<std::uint32_t> sizes =
        settings.fitted ? fitted() : std::vector<std::uint32_t>(probes.size(), settings.size);
    // `hybrid` traces what is too coarse.
    if (!settings.shares_room && kind != MapKind::hybrid) return sizes;
    const std::uint64_t room = device.summary().storage_range_bytes / sizeof(glm::vec3);
    const std::size_t maps = kind == MapKind::sphere ? 1 : faces.size();
    if (texels_of(sizes, maps) > room) sizes = fitted();
    while (texels_of(sizes, maps) > room && *std::max_element(sizes.begin(), sizes.end()) > 1) {
        for (std::uint32_t& size : sizes)
            size = std::max(1u, size / 2);
    }
    return sizes;
}

std::vector<interop::ProbeInfo> describe_probes(const SceneData& data, const Reflectors& reflectors,
                                                const std::vector<Probe>& probes, MapKind kind,
                                                std::uint32_t maps, const MapSettings& settings,
                                                const std::vector<std::uint32_t>& sizes,
                                                std::vector<interop::ProxyPlane>& proxy_planes) {
    std::vector<interop::ProbeInfo> infos;
    std::uint64_t first_texel = 0;
    for (std::size_t i = 0; i < probes.size(); ++i) {
        const Probe& probe = probes[i];
        Proxy proxy;
        if (kind == MapKind::proxy) {
            proxy =
                find_proxy(data, reflectors.instances[probe.reflector], probe.capture_point, settings.proxy);
        }
        infos.push_back({glm::vec3(probe.capture_point),
                         static_cast<std::uint32_t>(first_texel),
                         sizes[i],
                         add_proxy(proxy_planes, proxy),
                         {},
                         {},
                         {}});
        first_texel += maps * texels_per_map(sizes[i]);
    }
    return infos;
}

std::uint32_t most_of_a_reflector(const std::vector<Probe>& probes, const Reflectors& reflectors) {
    std::uint32_t most = 1;
    for (const interop::ProbeRange& range : probe_ranges(probes, reflectors.instances.size()))
        most = std::max(most, range.count);
    return most;
}

Reflectors fine_reflectors(const SceneData& data, const std::vector<std::uint32_t>& instances,
                           const PolygonRefinement& refinement) {
    Reflectors reflectors = find_reflectors(data, instances);
    if (reflectors.triangles.size() > kMostReflectorPolygons) {
        throw UsageError(
            "draw reflective objects", fmt::format("of {} polygons", reflectors.triangles.size()),
            fmt::format("at most {} can be drawn; use --reflection trace", kMostReflectorPolygons));
    }
    refine(reflectors, refinement);
    return reflectors;
}

std::vector<interop::MapFace> faces_of(MapKind kind, const Polyhedron& polyhedron) {
    std::vector<interop::MapFace> faces;
    if (kind == MapKind::sphere) return faces;
    for (std::size_t i = 0; i < polyhedron.planes.size(); ++i)
        faces.push_back(map_face(polyhedron, i));
    return faces;
}

/// A uniform block has a size of its own, whatever it holds.
Buffer make_face_block(Device& device, std::vector<interop::MapFace> faces) {
    faces.resize(interop::MAP_MOST_FACES);
    return make_buffer<interop::MapFace>(device, faces, "faces of the maps");
}

}  // namespace

ReflectionMaps::ReflectionMaps(Device& device, const SceneData& data, MapKind kind,
                               const MapSettings& settings, const MapView& view,
                               std::vector<interop::ProxyPlane>& proxy_planes)
    : ReflectionMaps(device, data, kind, settings, view, proxy_planes,
                     data.requirements.reflective_instances) {}

ReflectionMaps::ReflectionMaps(Device& device, const SceneData& data, MapKind kind,
                               const MapSettings& settings, const MapView& view,
                               std::vector<interop::ProxyPlane>& proxy_planes,
                               const std::vector<std::uint32_t>& instances)
    : kind_(kind),
      settings_(settings),
      reflectors_(fine_reflectors(data, instances, settings.refinement)),
      faces_(faces_of(kind, settings.polyhedron)),
      probes_(
          place_probes(data, reflectors_.instances, kind, {settings.most_probes, settings.capture_point})),
      infos_(describe_probes(data, reflectors_, probes_, kind, maps_per_probe(), settings,
                             map_sizes(device, data, reflectors_, probes_, kind, faces_, settings, view),
                             proxy_planes)),
      info_buffer_(make_buffer<interop::ProbeInfo>(device, infos_, "probes")),
      face_block_(make_face_block(device, faces_)),
      most_probes_(most_of_a_reflector(probes_, reflectors_)),
      ranges_(make_buffer<interop::ProbeRange>(device, probe_ranges(probes_, reflectors_.instances.size()),
                                               "probes of reflectors")),
      texels_(device,
              std::max<std::uint64_t>(1, total_texels(device, infos_, maps_per_probe(), settings)) *
                  sizeof(glm::vec3),
              "reflection maps"),
      states_(device, (1 + std::max(1u, map_count())) * sizeof(std::uint32_t), "states of reflection maps") {
    states_.fill_with_zero();
}

std::uint32_t ReflectionMaps::stride(std::uint32_t probe) const {
    return infos_[probe].map_size + 2 * interop::MAP_BORDER;
}

std::uint32_t ReflectionMaps::first_texel(std::uint32_t map) const {
    const std::uint32_t probe = map / maps_per_probe();
    return infos_[probe].first_texel + map % maps_per_probe() * stride(probe) * stride(probe);
}

interop::CameraInfo ReflectionMaps::map_camera(std::uint32_t map) const {
    const interop::ProbeInfo& info = infos_[map / maps_per_probe()];
    // The picture reaches half a border texel's neighbours beyond the map: see MAP_BORDER.
    const float edge = static_cast<float>(stride(map / maps_per_probe())) / static_cast<float>(info.map_size);
    if (kind_ == MapKind::sphere)
        return {info.capture_point, edge * info.map_right, edge * info.map_up, info.map_forward};
    const FacePicture picture = face_picture(settings_.polyhedron, map % maps_per_probe());
    return {info.capture_point, edge * glm::vec3(picture.right), edge * glm::vec3(picture.up),
            glm::vec3(picture.centre)};
}

std::uint32_t ReflectionMaps::maps_per_probe() const {
    return kind_ == MapKind::sphere ? 1 : static_cast<std::uint32_t>(faces_.size());
}

std::uint32_t ReflectionMaps::map_count() const {
    return static_cast<std::uint32_t>(infos_.size()) * maps_per_probe();
}

std::uint32_t ReflectionMaps::least_size() const {
    std::uint32_t least = infos_.empty() ? 0 : infos_.front().map_size;
    for (const interop::ProbeInfo& info : infos_)
        least = std::min(least, info.map_size);
    return least;
}

std::uint32_t ReflectionMaps::largest_size() const {
    std::uint32_t largest = 0;
    for (const interop::ProbeInfo& info : infos_)
        largest = std::max(largest, info.map_size);
    return largest;
}

void ReflectionMaps::orient_to(const Camera& eye) {
    if (infos_.empty()) return;
    for (interop::ProbeInfo& info : infos_) {
        info.map_right = glm::vec3(eye.right);
        info.map_up = glm::vec3(eye.up);
        info.map_forward = glm::vec3(eye.forward);
    }
    info_buffer_.upload(std::as_bytes(std::span(infos_)));
}

void ReflectionMaps::reuse_from(ReflectionMaps& previous) {
    const auto same_layout = [](const interop::ProbeInfo& a, const interop::ProbeInfo& b) {
        return a.first_texel == b.first_texel && a.map_size == b.map_size;
    };
    if (!std::equal(infos_.begin(), infos_.end(), previous.infos_.begin(), previous.infos_.end(),
                    same_layout))
        return;
    texels_ = std::move(previous.texels_);
    states_ = std::move(previous.states_);
    const std::vector<std::uint32_t> now = probe_instances();
    const std::vector<std::uint32_t> then = previous.probe_instances();
    std::vector<std::uint32_t> moved;
    for (std::uint32_t probe = 0; probe < infos_.size(); ++probe) {
        if (infos_[probe].capture_point == previous.infos_[probe].capture_point && now[probe] == then[probe])
            continue;
        for (std::uint32_t face = 0; face < maps_per_probe(); ++face)
            moved.push_back(probe * maps_per_probe() + face);
    }
    set_states(moved, interop::MAP_EMPTY);
}

void ReflectionMaps::forget(const SeenChanges& changes) {
    std::vector<std::uint32_t> changed;
    const std::vector<std::uint32_t> owners = probe_instances();
    for (std::uint32_t map = 0; map < map_count(); ++map) {
        // A sphere map sees all around.
        if (kind_ == MapKind::sphere ||
            changes.appearance_may_change_in(ViewPyramid(map_camera(map)), owners[map / maps_per_probe()])) {
            changed.push_back(map);
        }
    }
    set_states(changed, interop::MAP_EMPTY);
}

void ReflectionMaps::want_all() {
    auto states = states_.download_records<std::uint32_t>(1 + map_count());
    for (std::size_t map = 1; map < states.size(); ++map) {
        if (states[map] == interop::MAP_EMPTY) states[map] = interop::MAP_WANTED;
    }
    count_states(states);
}

std::vector<std::uint32_t> ReflectionMaps::wanted() const {
    std::vector<std::uint32_t> maps;
    if (states_.download_records<std::uint32_t>(1).front() == 0) return maps;
    const auto states = states_.download_records<std::uint32_t>(1 + map_count());
    for (std::uint32_t map = 0; map < map_count(); ++map) {
        if (states[1 + map] == interop::MAP_WANTED) maps.push_back(map);
    }
    return maps;
}

void ReflectionMaps::set_states(const std::vector<std::uint32_t>& maps, std::uint32_t state) {
    auto states = states_.download_records<std::uint32_t>(1 + map_count());
    for (const std::uint32_t map : maps)
        states[1 + map] = state;
    count_states(std::move(states));
}

void ReflectionMaps::count_states(std::vector<std::uint32_t> states) {
    const auto first = states.begin() + 1;
    states.front() = static_cast<std::uint32_t>(std::count(first, states.end(), interop::MAP_WANTED));
    captured_ = static_cast<std::uint32_t>(std::count(first, states.end(), interop::MAP_CAPTURED));
    states_.upload(std::as_bytes(std::span(states)));
}

Bindings ReflectionMaps::bindings() const {
    return {{interop::BINDING_PROBES, &info_buffer_},
            {interop::BINDING_PROBE_RANGES, &ranges_},
            {interop::BINDING_MAP_FACES, &face_block_},
            {interop::BINDING_MAP_TEXELS, &texels_},
            {interop::BINDING_MAP_STATES, &states_}};
}

Specialization ReflectionMaps::specialise(Specialization others) const {
    others[interop::SPEC_MOST_PROBES] = most_probes_;
    return others;
}

std::vector<std::uint32_t> ReflectionMaps::probe_instances() const {
    std::vector<std::uint32_t> result;
    for (const Probe& probe : probes_)
        result.push_back(reflectors_.instances[probe.reflector]);
    return result;
}

Image ReflectionMaps::map(std::uint32_t probe, std::uint32_t face) const {
    Image image(stride(probe), stride(probe));
    const std::uint64_t first = first_texel(probe * maps_per_probe() + face);
    texels_.download(std::as_writable_bytes(std::span(image.pixels)), first * sizeof(glm::vec3));
    return image;
}

}  // namespace utsuri
