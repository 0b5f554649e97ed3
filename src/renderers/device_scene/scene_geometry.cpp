// SPDX-License-Identifier: Apache-2.0
#include "renderers/device_scene/scene_geometry.h"

#include "renderers/device_scene/coplanar_layers.h"
#include "renderers/device_scene/scene_triangles.h"

#include "base/same_bits.h"
#include "base/stopwatch.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace utsuri {
namespace {

bool same_mesh(const Mesh& a, const Mesh& b) {
    return same_bits(a.positions, b.positions) && same_bits(a.normals, b.normals) &&
           same_bits(a.texcoords, b.texcoords) && same_bits(a.triangles, b.triangles);
}

bool same_place(const Instance& a, const Instance& b) {
    return a.mesh == b.mesh && a.world_from_object == b.world_from_object;
}

bool same_meshes(const GeometrySource& source, const Scene& scene) {
    return std::equal(source.meshes.begin(), source.meshes.end(), scene.meshes.begin(), scene.meshes.end(),
                      same_mesh);
}

bool same_places(const GeometrySource& source, const Scene& scene) {
    return std::equal(source.instances.begin(), source.instances.end(), scene.instances.begin(),
                      scene.instances.end(), same_place);
}

/// Calls `work` and tells how long it took.
template <typename Work>
double seconds_of(const Work& work) {
    const Stopwatch stopwatch;
    work();
    return stopwatch.seconds();
}

/// Sorted by counting: with thousands of instances, none may take a scan of its own.
InstanceTriangles sort_by_instance(const SceneData& data, std::size_t instances) {
    const std::vector<interop::TriangleInfo>& infos = data.triangle_infos;
    InstanceTriangles sorted;
    sorted.first.resize(instances + 1);
    for (const interop::TriangleInfo& info : infos)
        ++sorted.first[info.instance + 1];
    std::partial_sum(sorted.first.begin(), sorted.first.end(), sorted.first.begin());
    std::vector<std::uint32_t> next(sorted.first.begin(), sorted.first.end() - 1);
    sorted.triangles.resize(infos.size());
    sorted.bounds.resize(instances);
    for (std::uint32_t t = 0; t < infos.size(); ++t) {
        sorted.bounds[infos[t].instance].extend(bounds_of(data.bvh.triangles[t]));
        sorted.triangles[next[infos[t].instance]++] = t;
    }
    return sorted;
}

void find_layers(SceneData& data) {
    const std::vector<std::uint32_t> layers = count_layers(data);
    bool overlap = false;
    for (std::size_t t = 0; t < layers.size(); ++t) {
        data.triangle_infos[t].layers = layers[t];
        overlap = overlap || layers[t] > 0;
    }
    if (overlap) data.layer_distance = layer_distance(data);
}

/// All but the BVH, which is there.
void describe(const Scene& scene, WorldGeometry world, SceneData& data) {
    data.origin = world.origin;
    data.bounds = world.bounds;
    data.triangle_infos.reserve(data.bvh.order.size());
    for (const std::uint32_t input : data.bvh.order) {
        const std::uint32_t instance = world.instances[input];
        data.triangle_infos.push_back(
            {world.triangles[input], scene.instances[instance].material, instance, interop::NONE, 0});
    }
    data.instance_triangles = sort_by_instance(data, scene.instances.size());
    find_layers(data);
    data.normals = std::move(world.normals);
    if (data.requirements.textures > 0) data.texcoords = std::move(world.texcoords);
}

/// Whether the triangles join the vertices that they joined, wherever these are now.
bool join_same_vertices(const SceneData& before, const WorldGeometry& world) {
    if (world.triangles.size() != before.bvh.order.size()) return false;
    for (std::size_t t = 0; t < before.bvh.order.size(); ++t) {
        if (world.triangles[before.bvh.order[t]] != before.triangle_infos[t].vertices) return false;
    }
    return true;
}

bool at_same_place(const SceneData& before, const WorldGeometry& world) {
    for (std::size_t t = 0; t < before.bvh.order.size(); ++t) {
        const glm::uvec3& vertices = world.triangles[before.bvh.order[t]];
        const interop::BvhTriangle now = {world.positions[vertices.x], world.positions[vertices.y],
                                          world.positions[vertices.z]};
        if (!same_bits(now, before.bvh.triangles[t])) return false;
    }
    return true;
}

/// Of a scene whose meshes are where they were; some may have other materials.
void keep_geometry(SceneData& before, const Scene& scene, SceneData& data) {
    data.origin = before.origin;
    data.bounds = before.bounds;
    data.layer_distance = before.layer_distance;
    data.bvh = std::move(before.bvh);
    data.normals = std::move(before.normals);
    data.texcoords = std::move(before.texcoords);
    data.instance_triangles = std::move(before.instance_triangles);
    data.triangle_infos = before.triangle_infos;
    for (interop::TriangleInfo& info : data.triangle_infos)
        info.material = scene.instances[info.instance].material;
    data.geometry_source = std::move(before.geometry_source);
}

}  // namespace

void make_geometry(const Scene& scene, SceneData& data) {
    WorldGeometry world = make_world_geometry(scene);
    data.build_seconds = seconds_of([&] { data.bvh = build_bvh(world.positions, world.triangles); });
    describe(scene, std::move(world), data);
    data.geometry_source = {scene.meshes, scene.instances};
}

GeometryChange follow_geometry(SceneData& before, const Scene& scene, SceneData& data) {
    const bool kept_meshes = same_meshes(before.geometry_source, scene);
    const bool kept_texcoords = (before.requirements.textures > 0) == (data.requirements.textures > 0);
    if (kept_meshes && kept_texcoords && same_places(before.geometry_source, scene)) {
        keep_geometry(before, scene, data);
        return GeometryChange::none;
    }
    WorldGeometry world = make_world_geometry(scene, before.origin);
    if (!join_same_vertices(before, world)) {
        world = {};  // makes room
        make_geometry(scene, data);
        return GeometryChange::rebuilt;
    }
    const bool stays = at_same_place(before, world);
    if (stays) {
        data.bvh = std::move(before.bvh);
    } else {
        data.bvh = before.bvh;
        data.build_seconds = seconds_of([&] { refit(data.bvh, world.positions, world.triangles); });
    }
    describe(scene, std::move(world), data);
    // What kernels know of layers stays when a thing is lifted off what it lay on: that takes no other
    // kernels.
    if (before.layer_distance > 0.0f) data.layer_distance = layer_distance(data);
    data.geometry_source.instances = scene.instances;
    if (kept_meshes) {
        data.geometry_source.meshes = std::move(before.geometry_source.meshes);
    } else {
        data.geometry_source.meshes = scene.meshes;
    }
    return stays ? GeometryChange::attributes : GeometryChange::moved;
}

}  // namespace utsuri
