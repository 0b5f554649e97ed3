// SPDX-License-Identifier: Apache-2.0
#include "renderers/light/direct/light_cache.h"

#include "renderers/light/direct/light_simulation.h"
#include "renderers/light/mesh/packed_mesh.h"

#include "interop/bindings.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <bit>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace utsuri {
namespace {

/// Light that is known, by where it is.
class KnownLight {
  public:
    /// @param moved triangles whose light is not known; ascending
    KnownLight(const std::vector<interop::LightMeshPlace>& places,
               const std::vector<interop::LightMeshPoint>& light, const std::vector<std::uint32_t>& moved) {
        by_place_.reserve(places.size());
        for (std::size_t i = 0; i < light.size(); ++i) {
            if (!std::binary_search(moved.begin(), moved.end(), places[i].triangle))
                by_place_.emplace(places[i], light[i]);
        }
    }

    [[nodiscard]] const interop::LightMeshPoint* find(const interop::LightMeshPlace& place) const {
        const auto found = by_place_.find(place);
        return found == by_place_.end() ? nullptr : &found->second;
    }

  private:
    struct Hash {
        std::size_t operator()(const interop::LightMeshPlace& place) const {
            // Odd factors spread the bits (Knuth's multiplicative hashing).
            std::uint64_t hash = place.triangle;
            for (const std::uint32_t word : {std::bit_cast<std::uint32_t>(place.b1),
                                             std::bit_cast<std::uint32_t>(place.b2), place.lit, place.dark})
                hash = (hash ^ word) * 0x9e3779b97f4a7c15u;
            return static_cast<std::size_t>(hash ^ (hash >> 32));
        }
    };
    struct Same {
        bool operator()(const interop::LightMeshPlace& a, const interop::LightMeshPlace& b) const {
            // What is expected decides how many samples are taken.
            return a.triangle == b.triangle && a.b1 == b.b1 && a.b2 == b.b2 && a.lit == b.lit &&
                   a.dark == b.dark;
        }
    };
    std::unordered_map<interop::LightMeshPlace, interop::LightMeshPoint, Hash, Same> by_place_;
};

}  // namespace

MeshSettings mesh_settings(const SceneData& data, const LightSettings& settings, std::uint64_t buffer_bytes) {
    MeshSettings result;
    result.coarsest = settings.spacing * glm::length(glm::dvec3(data.bounds.extent()));
    result.finest = result.coarsest / settings.refinement;
    result.tolerance = settings.tolerance;
    result.most_points = settings.most_points;
    result.room = most_packed_points(data.triangle_infos.size(), buffer_bytes);
    return result;
}

LightCache::LightCache(Device& device, const SceneData& data, const GpuScene& scene,
                       const LightSettings& settings)
    : SurfaceLight(device, data.requirements.glossy),
      device_(device),
      data_(data),
      scene_(scene),
      settings_(settings),
      nodes_(make_buffer<MeshTexel>(device, {}, "light mesh", BindingKind::texels)),
      sides_(make_buffer<interop::LightMeshSide>(device, {}, "light on leaves", BindingKind::texels)) {}

void LightCache::fill(Progress& progress) {
    if (is_filled()) return;
    simulate({}, {}, progress);
    changed_.resize(data_.triangle_infos.size());
    std::iota(changed_.begin(), changed_.end(), 0u);
}

void LightCache::update(const SceneChange& change, Progress& progress) {
    if (is_filled() || !revision_) return;
    const bool follows = *revision_ + 1 == scene_.light_revision() && !change.lights;
    const LightMesh before = std::move(mesh_);
    const Told known = std::exchange(told_, {});
    if (follows) {
        simulate(known, changed_space(data_, change), progress);
    } else {
        simulate({}, {}, progress);
    }
    changed_ = differing_triangles(before, mesh_, static_cast<std::uint32_t>(data_.triangle_infos.size()));
}

void LightCache::simulate(const Told& known, const ChangedSpace& changed, Progress& progress) {
    revision_.reset();  // until all of it is there
    cost_ = {};
    LightMesher mesher(data_,
                       mesh_settings(data_, settings_, most_bytes(device_.summary(), BindingKind::texels)));
    if (mesher.wanted().empty()) {
        keep(mesher.finish());
        revision_ = scene_.light_revision();
        return;
    }
    const KnownLight known_light(known.places, known.light, changed.triangles);
    LightSimulation simulation(device_, data_, scene_, settings_, changed.boxes);
    while (!mesher.wanted().empty()) {
        std::vector<interop::LightMeshPlace> places(mesher.wanted().begin(), mesher.wanted().end());
        std::vector<interop::LightMeshPoint> light(places.size());
        for (std::size_t i = 0; i < places.size(); ++i) {
            const interop::LightMeshPoint* there = known_light.find(places[i]);
            if (there == nullptr) continue;
            light[i] = *there;
            places[i].known = 1;
        }
        simulation.simulate(places, light, progress);
        mesher.tell(light);
    }
    keep(mesher.finish());
    told_ = {mesher.places(), mesher.light()};
    cost_ = simulation.cost();
    revision_ = scene_.light_revision();
}

void LightCache::keep(LightMesh mesh) {
    const PackedMesh packed = pack(mesh, static_cast<std::uint32_t>(data_.triangle_infos.size()));
    Buffer nodes = make_buffer<MeshTexel>(device_, packed.nodes, "light mesh", BindingKind::texels);
    Buffer sides =
        make_buffer<interop::LightMeshSide>(device_, packed.sides, "light on leaves", BindingKind::texels);
    mesh_ = std::move(mesh);
    nodes_ = std::move(nodes);
    sides_ = std::move(sides);
}

Bindings LightCache::kept_bindings() const {
    return {{interop::BINDING_LIGHT_MESH_NODES, &nodes_}, {interop::BINDING_LIGHT_MESH_LEAVES, &sides_}};
}

}  // namespace utsuri
