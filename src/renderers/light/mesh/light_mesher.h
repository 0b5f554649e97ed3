// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/light/mesh/light_mesh.h"
#include "renderers/light/mesh/mesh_tree.h"

#include "interop/light_mesh.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace utsuri {

/// How a mesh is made.
struct MeshSettings {
    double coarsest = 0.0;          ///< distance of neighbouring points, at most, metres
    double finest = 0.0;            ///< edges that are no longer are not split for the sake of light, metres
    double tolerance = 0.0;         ///< of light between points, as a share of the light there
    std::uint64_t most_points = 0;  ///< where things touch, and again where light changes
    std::uint64_t room = 0;         ///< for all points
};

/// Bytes that a mesh takes on the device: as it is before it is made finer, and at most.
struct MeshBytes {
    std::uint64_t least = 0;
    std::uint64_t most = 0;
};
MeshBytes predict_mesh_bytes(const SceneData& scene, const MeshSettings& settings);

/// Makes a mesh as dense as its light needs. Starts coarse, cut where things touch; then asks for light in
/// the middle of leaves' longest edges, and splits where it is not what lies between the ends. What comes out
/// depends on the scene and on what is told alone, not on how it is asked.
class LightMesher {
  public:
    /// @param scene must outlive this
    LightMesher(const SceneData& scene, const MeshSettings& settings);

    /// Where light is to be told next; nowhere when the mesh is done.
    [[nodiscard]] std::span<const interop::LightMeshPlace> wanted() const;
    /// @param light at all of wanted()
    void tell(std::span<const interop::LightMeshPoint> light);
    /// All places asked for so far, and the light at those told.
    [[nodiscard]] const std::vector<interop::LightMeshPlace>& places() const { return mesh_.places(); }
    [[nodiscard]] const std::vector<interop::LightMeshPoint>& light() const { return light_; }
    /// What the mesh is when done, without the points that turned out as not needed.
    [[nodiscard]] LightMesh finish() const;

  private:
    /// A leaf, and the point that tells whether it is fine enough.
    struct Test {
        std::uint32_t leaf;
        std::uint32_t edge;
        std::uint32_t point;
    };
    void make_tests();
    void refine();
    /// Tells wanted places what the ends of their edges agree on.
    void expect();
    [[nodiscard]] double disagreement(const Test& test) const;
    [[nodiscard]] double mean_light() const;

    MeshSettings settings_;
    MeshTree mesh_;
    std::vector<interop::LightMeshPoint> light_;
    std::vector<Test> tests_;
    std::size_t untested_ = 0;    ///< the first leaf of the mesh that no test was made of
    std::uint64_t limit_ = 0;     ///< of points, the coarse mesh included
    std::optional<double> mean_;  ///< light of the coarse mesh, roughly
};

}  // namespace utsuri
