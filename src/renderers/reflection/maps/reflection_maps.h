// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/scene_data.h"
#include "renderers/film/film_kernel.h"
#include "renderers/reflection/maps/map_settings.h"
#include "renderers/reflection/maps/map_size.h"
#include "renderers/reflection/maps/seen_changes.h"
#include "renderers/reflection/proxies/proxy.h"
#include "renderers/reflection/reflectors/probes.h"
#include "renderers/reflection/reflectors/reflectors.h"
#include "renderers/reflection/reflectors/tolerance.h"

#include "geometry/polyhedron.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace utsuri {

/// The maps of every reflective instance, seen from one probe or several without the instance itself. They
/// are captured when they are first looked up: see MapCapture.
class ReflectionMaps {
  public:
    /// @param view that fitted maps are fine enough for
    /// @param proxy_planes where the planes of proxies that are no boxes are put, behind those of others
    /// @throws UsageError if the maps cannot fit into one buffer of the device, with the largest size that
    /// would
    ReflectionMaps(Device& device, const SceneData& data, MapKind kind, const MapSettings& settings,
                   const MapView& view, std::vector<interop::ProxyPlane>& proxy_planes);
    /// @param instances that get maps, ascending
    ReflectionMaps(Device& device, const SceneData& data, MapKind kind, const MapSettings& settings,
                   const MapView& view, std::vector<interop::ProxyPlane>& proxy_planes,
                   const std::vector<std::uint32_t>& instances);

    /// Turns sphere maps, before any is captured, to an eye whose axes they follow.
    void orient_to(const Camera& eye);

    /// Takes maps over from those of the scene before it changed, where they are as many and as fine: of the
    /// capture points that stay where they are.
    void reuse_from(ReflectionMaps& previous);
    /// Drops maps that a change may have changed.
    void forget(const SeenChanges& changes);

    /// Asks for all maps that are not there, as if something had looked them up.
    void want_all();
    /// Maps that were looked up since they were last captured, ascending: each is number
    /// probe * maps_per_probe() + face.
    [[nodiscard]] std::vector<std::uint32_t> wanted() const;
    void mark_captured(const std::vector<std::uint32_t>& maps) { set_states(maps, interop::MAP_CAPTURED); }
    [[nodiscard]] std::uint32_t captured_count() const { return captured_; }
    [[nodiscard]] std::uint32_t map_count() const;
    /// Texels along an edge of the smallest and of the largest maps; 0 without maps.
    [[nodiscard]] std::uint32_t least_size() const;
    [[nodiscard]] std::uint32_t largest_size() const;

    /// What sees a map, its border included.
    [[nodiscard]] interop::CameraInfo map_camera(std::uint32_t map) const;
    /// Texels along an edge of a probe's maps, with their borders.
    [[nodiscard]] std::uint32_t stride(std::uint32_t probe) const;
    /// Where a map is among the texels.
    [[nodiscard]] std::uint32_t first_texel(std::uint32_t map) const;
    /// Of all maps, a vec3 each.
    [[nodiscard]] const Buffer& texels() const { return texels_; }
    [[nodiscard]] MapKind kind() const { return kind_; }

    [[nodiscard]] const Reflectors& reflectors() const { return reflectors_; }
    /// Of each probe: those of a reflector follow one another.
    [[nodiscard]] const std::vector<interop::ProbeInfo>& infos() const { return infos_; }
    [[nodiscard]] const std::vector<Probe>& probes() const { return probes_; }
    /// The instance that each probe belongs to.
    [[nodiscard]] std::vector<std::uint32_t> probe_instances() const;
    [[nodiscard]] Bindings bindings() const;
    /// What stages that look the maps up are told about them, added to others.
    [[nodiscard]] Specialization specialise(Specialization others) const;

    /// The texels of one map, border included, as a picture.
    [[nodiscard]] Image map(std::uint32_t probe, std::uint32_t face) const;
    [[nodiscard]] std::uint32_t maps_per_probe() const;
    /// Of the polyhedron of maps; none for sphere maps.
    [[nodiscard]] const std::vector<interop::MapFace>& faces() const { return faces_; }

  private:
    void set_states(const std::vector<std::uint32_t>& maps, std::uint32_t state);
    /// Makes states known, the number of each kind with them.
    void count_states(std::vector<std::uint32_t> states);

    MapKind kind_;
    MapSettings settings_;
    Reflectors reflectors_;
    std::vector<interop::MapFace> faces_;
    std::vector<Probe> probes_;
    std::vector<interop::ProbeInfo> infos_;
    Buffer info_buffer_;
    Buffer face_block_;
    std::uint32_t most_probes_;  ///< of one reflector, that there are
    Buffer ranges_;
    Buffer texels_;
    std::uint32_t captured_ = 0;
    Buffer states_;
};

}  // namespace utsuri
