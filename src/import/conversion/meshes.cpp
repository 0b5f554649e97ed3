// SPDX-License-Identifier: Apache-2.0
#include "import/conversion/meshes.h"

#include "import/conversion/normals.h"
#include "import/conversion/triangles.h"
#include "import/document/accessors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace utsuri {
namespace {

std::optional<std::size_t> attribute(const tinygltf::Primitive& primitive, const char* name) {
    const auto found = primitive.attributes.find(name);
    if (found == primitive.attributes.end()) return std::nullopt;
    return static_cast<std::size_t>(found->second);
}

void note_unused_attributes(FeatureNotes& ignored, const tinygltf::Primitive& primitive,
                            const std::string& place) {
    bool extra_texcoords = false;
    bool colours = false;
    for (const auto& [name, accessor] : primitive.attributes) {
        extra_texcoords = extra_texcoords || (name.starts_with("TEXCOORD_") && name != "TEXCOORD_0");
        colours = colours || name.starts_with("COLOR_");
    }
    if (colours) ignored.add("vertex colours are not drawn", place);
    if (extra_texcoords) ignored.add("texture coordinate sets other than TEXCOORD_0 are not used", place);
    if (!primitive.targets.empty())
        ignored.add("morph targets are not applied, the base shape is drawn", place);
}

/// Reads one primitive; the steps are in the order of the members.
class PrimitiveReader {
  public:
    PrimitiveReader(ImportContext& context, std::size_t mesh, std::size_t primitive)
        : context_(context),
          document_(context.document),
          primitive_(document_.model.meshes[mesh].primitives[primitive]),
          place_(fmt::format("meshes[{}].primitives[{}]", mesh, primitive)) {
        const tinygltf::Mesh& source = document_.model.meshes[mesh];
        mesh_.name = source.name.empty() ? fmt::format("meshes[{}]", mesh) : source.name;
        if (source.primitives.size() > 1) mesh_.name += fmt::format("[{}]", primitive);
    }

    Mesh read() {
        if (primitive_.mode < static_cast<int>(Topology::triangles)) {
            const char* shapes = primitive_.mode == TINYGLTF_MODE_POINTS ? "points" : "lines";
            context_.ignored.add(fmt::format("{} are not drawn", shapes), place_);
            return {};
        }
        note_unused_attributes(context_.ignored, primitive_, place_);
        read_triangles();
        if (mesh_.triangles.empty()) return {};
        read_vertices();
        drop_triangles();
        finish_normals();
        return std::move(mesh_);
    }

  private:
    void read_triangles() {
        const auto positions = attribute(primitive_, "POSITION");
        if (!positions)
            document_.fail(place_ + ".attributes.POSITION", "missing; must be an accessor of VEC3");
        vertex_count_ = document_.model.accessors[*positions].count;
        if (vertex_count_ > std::numeric_limits<std::uint32_t>::max()) {
            document_.fail(place_ + ".attributes.POSITION", "more than 2^32 - 1 vertices; must be split");
        }
        std::vector<std::uint32_t> indices;
        if (primitive_.indices >= 0) {
            indices = read_indices(document_, context_.buffers, static_cast<std::size_t>(primitive_.indices),
                                   place_ + ".indices");
            check_range(indices);
        } else {
            indices.resize(vertex_count_);
            std::iota(indices.begin(), indices.end(), 0u);
        }
        const auto topology = static_cast<Topology>(primitive_.mode);
        const bool is_list = topology == Topology::triangles;
        const std::size_t left_over =
            is_list ? indices.size() % 3 : (indices.size() < 3 ? indices.size() : 0);
        if (left_over > 0) {
            drop(fmt::format("{} at the end that make no triangle", counted(left_over, "vertex reference")));
        }
        mesh_.triangles = assemble_triangles(topology, indices);
    }

    void check_range(const std::vector<std::uint32_t>& indices) const {
        const auto bad = std::find_if(indices.begin(), indices.end(),
                                      [&](std::uint32_t index) { return index >= vertex_count_; });
        if (bad == indices.end()) return;
        document_.fail(place_ + ".indices",
                       fmt::format("index {} is {}; must be below the number of vertices, {}",
                                   bad - indices.begin(), *bad, vertex_count_));
    }

    /// Reads only the run of vertices that the triangles refer to: many exporters share one accessor among
    /// all primitives.
    void read_vertices() {
        std::uint32_t first = std::numeric_limits<std::uint32_t>::max();
        std::uint32_t last = 0;
        for (const glm::uvec3 t : mesh_.triangles) {
            first = std::min({first, t.x, t.y, t.z});
            last = std::max({last, t.x, t.y, t.z});
        }
        for (glm::uvec3& triangle : mesh_.triangles)
            triangle -= glm::uvec3(first);
        const ElementRange range = {first, std::size_t{last} - first + 1};
        const std::string place = place_ + ".attributes.";
        mesh_.positions =
            read_vec3(document_, context_.buffers, checked("POSITION"), range, place + "POSITION");
        if (attribute(primitive_, "NORMAL")) {
            mesh_.normals =
                read_vec3(document_, context_.buffers, checked("NORMAL"), range, place + "NORMAL");
        }
        if (attribute(primitive_, "TEXCOORD_0")) {
            mesh_.texcoords =
                read_vec2(document_, context_.buffers, checked("TEXCOORD_0"), range, place + "TEXCOORD_0");
        }
    }

    /// The accessor of an attribute that is present, after checking that it has one element a vertex.
    std::size_t checked(const char* name) const {
        const std::size_t accessor = *attribute(primitive_, name);
        const std::size_t count = document_.model.accessors[accessor].count;
        if (count != vertex_count_) {
            document_.fail(
                fmt::format("{}.attributes.{}", place_, name),
                fmt::format("accessors[{}] has {} elements; must have one for each of the {} vertices",
                            accessor, count, vertex_count_));
        }
        return accessor;
    }

    void drop_triangles() {
        const DroppedTriangles dropped = drop_undrawable(mesh_);
        if (dropped.non_finite > 0) {
            drop(counted(dropped.non_finite, "triangle") + " with a vertex that is not finite");
        }
        if (dropped.zero_area > 0) drop(counted(dropped.zero_area, "triangle") + " of zero area");
        drop_unused_vertices(mesh_);
        std::size_t bad_texcoords = 0;
        for (glm::vec2& texcoord : mesh_.texcoords) {
            if (std::isfinite(texcoord.x) && std::isfinite(texcoord.y)) continue;
            texcoord = glm::vec2(0.0f);
            ++bad_texcoords;
        }
        if (bad_texcoords > 0) {
            add(fmt::format("{} not finite, replaced by (0, 0)",
                            counted(bad_texcoords, "texture coordinate")));
        }
    }

    void finish_normals() {
        if (mesh_.triangles.empty()) return;
        if (mesh_.normals.empty()) {
            make_flat_normals(mesh_);
            context_.added.add("no NORMAL attribute, flat normals made", place_);
            return;
        }
        const std::size_t repaired = repair_normals(mesh_);
        if (repaired > 0) {
            add(fmt::format("{} of zero length or not finite, made from the triangles around",
                            counted(repaired, "normal")));
        }
    }

    void drop(const std::string& what) {
        context_.result.dropped.push_back(fmt::format("{}: {} dropped", place_, what));
    }
    void add(const std::string& what) {
        context_.result.added.push_back(fmt::format("{}: {}", place_, what));
    }

    ImportContext& context_;
    const Document& document_;
    const tinygltf::Primitive& primitive_;
    std::string place_;
    std::size_t vertex_count_ = 0;
    Mesh mesh_;
};

}  // namespace

std::optional<std::uint32_t> MeshImporter::mesh_of(std::size_t mesh, std::size_t primitive) {
    const auto [entry, is_new] = imported_.try_emplace({mesh, primitive});
    if (is_new) entry->second = add(PrimitiveReader(context_, mesh, primitive).read());
    return entry->second;
}

std::optional<std::uint32_t> MeshImporter::flattened_mesh(std::uint32_t mesh,
                                                          const glm::dmat4& world_from_object,
                                                          const std::string& place) {
    const Mesh& source = context_.result.scene.meshes[mesh];
    const std::size_t before = source.triangles.size();
    Mesh flat = flattened(source, glm::dmat3(world_from_object));
    const std::size_t lost = before - flat.triangles.size();
    if (lost > 0) {
        context_.result.dropped.push_back(fmt::format("{}: {} left without area by the transform dropped",
                                                      place, counted(lost, "triangle")));
    }
    if (flat.triangles.empty()) return std::nullopt;
    context_.added.add("flattened by the transform, flat normals made", place);
    return add(std::move(flat));
}

std::optional<std::uint32_t> MeshImporter::add(Mesh mesh) {
    if (mesh.triangles.empty()) return std::nullopt;
    context_.result.scene.meshes.push_back(std::move(mesh));
    return static_cast<std::uint32_t>(context_.result.scene.meshes.size() - 1);
}

}  // namespace utsuri
