// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection_map/reflection_maps.h"

#include "base/error.h"

#include "interop/bindings.h"
#include "interop/specialization.h"
#include "kernels/resolve_map.h"
#include "kernels/trace_cached.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace utsuri {
namespace {

std::uint64_t texels_per_map(std::uint32_t size) {
    const std::uint64_t stride = std::uint64_t{size} + std::uint64_t{2} * interop::MAP_BORDER;
    return stride * stride;
}

/// Texels of all maps; throws where one buffer cannot hold them.
std::uint64_t total_texels(const Device& device, std::size_t probes, std::uint32_t maps,
                           const MapSettings& settings) {
    const std::uint64_t count = static_cast<std::uint64_t>(probes) * maps;
    const std::uint64_t limit = device.summary().storage_range_bytes / sizeof(glm::vec3);
    if (count * texels_per_map(settings.size) > limit) {
        const double per_map = std::sqrt(static_cast<double>(limit) / static_cast<double>(count));
        throw UsageError(
            "capture reflection maps",
            fmt::format("of {} texels from {} capture points", settings.size, probes),
            fmt::format("they need {} MiB and {} can see {} MiB of a buffer; --map-size may be at most {}{}",
                        count * texels_per_map(settings.size) * sizeof(glm::vec3) >> 20,
                        device.summary().name, device.summary().storage_range_bytes >> 20,
                        std::max(1, static_cast<int>(per_map) - 2),
                        settings.most_probes > 1 ? ", or use fewer --probes" : ""));
    }
    return count * texels_per_map(settings.size);
}

std::vector<interop::ReflectorInfo> describe_probes(const SceneData& data, const Reflectors& reflectors,
                                                    const std::vector<Probe>& probes, MapKind kind,
                                                    std::uint32_t maps, const MapSettings& settings,
                                                    std::vector<interop::ProxyPlane>& proxy_planes) {
    std::vector<interop::ReflectorInfo> infos;
    std::uint64_t first_texel = 0;
    for (const Probe& probe : probes) {
        Proxy proxy;
        if (kind == MapKind::proxy) {
            proxy =
                find_proxy(data, reflectors.instances[probe.reflector], probe.capture_point, settings.proxy);
        }
        infos.push_back({glm::vec3(probe.capture_point),
                         static_cast<std::uint32_t>(first_texel),
                         add_proxy(proxy_planes, proxy),
                         {},
                         {},
                         {}});
        first_texel += maps * texels_per_map(settings.size);
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

}  // namespace

ReflectionMaps::ReflectionMaps(Device& device, const SceneData& data, MapKind kind,
                               const MapSettings& settings)
    : ReflectionMaps(device, data, kind, settings, data.requirements.reflective_instances) {}

ReflectionMaps::ReflectionMaps(Device& device, const SceneData& data, MapKind kind,
                               const MapSettings& settings, const std::vector<std::uint32_t>& instances)
    : device_(&device),
      kind_(kind),
      settings_(settings),
      reflectors_(fine_reflectors(data, instances, settings.refinement)),
      faces_(faces_of(kind, settings.polyhedron)),
      probes_(place_probes(data, reflectors_, kind, {settings.most_probes, settings.capture_point})),
      infos_(describe_probes(data, reflectors_, probes_, kind, maps_per_probe(), settings, proxy_planes_)),
      info_buffer_(make_buffer<interop::ReflectorInfo>(device, infos_, "probes")),
      most_probes_(most_of_a_reflector(probes_, reflectors_)),
      ranges_(make_buffer<interop::ProbeRange>(device, probe_ranges(probes_, reflectors_.instances.size()),
                                               "probes of reflectors")),
      proxy_plane_buffer_(make_buffer<interop::ProxyPlane>(device, proxy_planes_, "planes of proxies")),
      texels_(device,
              std::max<std::uint64_t>(1, total_texels(device, infos_.size(), maps_per_probe(), settings)) *
                  sizeof(glm::vec3),
              "reflection maps") {}

interop::CameraInfo ReflectionMaps::map_camera(std::uint32_t probe, std::uint32_t face,
                                               const Camera& eye) const {
    // The picture reaches half a border texel's neighbours beyond the map: see MAP_BORDER.
    const float edge = static_cast<float>(stride()) / static_cast<float>(settings_.size);
    interop::CameraInfo camera{};
    camera.origin = infos_[probe].capture_point;
    if (kind_ == MapKind::sphere) {
        camera.right = edge * glm::vec3(eye.right);
        camera.up = edge * glm::vec3(eye.up);
        camera.forward = glm::vec3(eye.forward);
        return camera;
    }
    const FacePicture picture = face_picture(settings_.polyhedron, face);
    camera.right = edge * glm::vec3(picture.right);
    camera.up = edge * glm::vec3(picture.up);
    camera.forward = glm::vec3(picture.centre);
    return camera;
}

std::uint32_t ReflectionMaps::maps_per_probe() const {
    return kind_ == MapKind::sphere ? 1 : static_cast<std::uint32_t>(faces_.size());
}

FrameCounts ReflectionMaps::capture(const GpuScene& scene, const LightCache& light, const Camera& eye,
                                    const RenderSettings& settings, double& seconds_to_compile,
                                    Progress& progress) {
    FrameCounts counts;
    if (infos_.empty()) return counts;
    for (interop::ReflectorInfo& info : infos_) {
        info.map_right = glm::vec3(eye.right);
        info.map_up = glm::vec3(eye.up);
        info.map_forward = glm::vec3(eye.forward);
    }
    info_buffer_.upload(std::as_bytes(std::span(infos_)));
    Specialization specialization = scene.specialization();
    specialization[interop::SPEC_EXCLUDES_INSTANCE] = 1;
    specialization[interop::SPEC_PROJECTION] =
        kind_ == MapKind::sphere ? interop::PROJECTION_SPHERE_MAP : interop::PROJECTION_PERSPECTIVE;
    Bindings bindings = scene.bindings();
    bindings.merge(light.bindings());
    FilmKernel tracer(*device_, "trace_cached", kernels::trace_cached, specialization, bindings);
    const Kernel resolver(*device_, "resolve_map", kernels::resolve_map, {}, sizeof(interop::ResolveMapPush));
    Film film(*device_, stride(), stride(), "map film");
    seconds_to_compile = tracer.warm_up(film);
    Progress silent;

    const auto maps = static_cast<std::uint32_t>(infos_.size()) * maps_per_probe();
    for (std::uint32_t map = 0; map < maps; ++map) {
        if (progress.cancelled()) throw Interrupted();
        const std::uint32_t probe = map / maps_per_probe();
        film.clear();
        FrameSettings frame;
        frame.camera = map_camera(probe, map % maps_per_probe(), eye);
        // Any odd multiple of the map's number keeps the samples of maps and picture apart.
        frame.seed = settings.seed ^ (0x9e3779b9u * (map + 1));
        frame.specular_depth = std::min(settings.specular_depth, scene.specular_depth());
        frame.excluded_instance = reflectors_.instances[probes_[probe].reflector];
        accumulate(counts, tracer.add_samples(film, frame, settings_.samples, silent));

        interop::ResolveMapPush push{};
        push.samples = settings_.samples;
        for (const Film::Band& band : film.bands()) {
            push.texels = stride() * band.rows;
            push.first_texel =
                infos_[probe].first_texel + (map % maps_per_probe() * stride() + band.first_row) * stride();
            const BindingSet set = resolver.bind(
                {{interop::BINDING_FILM, &band.pixels}, {interop::BINDING_MAP_TEXELS, &texels_}});
            counts.gpu_seconds += device_->run("resolve a map", [&](const vk::raii::CommandBuffer& commands) {
                resolver.dispatch(commands, set, push, (push.texels + 63) / 64);
            });
        }
        progress.update(map + 1, maps);
    }
    return counts;
}

Bindings ReflectionMaps::bindings() const {
    return {{interop::BINDING_REFLECTORS, &info_buffer_},
            {interop::BINDING_PROBE_RANGES, &ranges_},
            {interop::BINDING_PROXY_PLANES, &proxy_plane_buffer_},
            {interop::BINDING_MAP_TEXELS, &texels_}};
}

Specialization ReflectionMaps::specialise(Specialization others) const {
    others[interop::SPEC_MAP_SIZE] = settings_.size;
    others[interop::SPEC_MOST_PROBES] = most_probes_;
    return others;
}

std::vector<std::uint32_t> ReflectionMaps::instances() const {
    std::vector<std::uint32_t> result;
    for (const Probe& probe : probes_)
        result.push_back(reflectors_.instances[probe.reflector]);
    return result;
}

Image ReflectionMaps::map(std::uint32_t probe, std::uint32_t face) const {
    Image image(stride(), stride());
    const std::uint64_t first = infos_[probe].first_texel + face * texels_per_map(settings_.size);
    texels_.download(std::as_writable_bytes(std::span(image.pixels)), first * sizeof(glm::vec3));
    return image;
}

}  // namespace utsuri
