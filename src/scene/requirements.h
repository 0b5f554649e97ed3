// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/scene.h"

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

namespace utsuri {

/// What shading a material takes.
struct SurfaceFeatures {
    bool glossy = false;  ///< some point has a glossy specular lobe
    bool mirror = false;  ///< some point reflects like a perfect mirror
    bool textured = false;

    // clang-tidy 14 takes the 0 that such a comparison is held against for a null pointer.
    // NOLINTNEXTLINE(modernize-use-nullptr)
    friend auto operator<=>(const SurfaceFeatures&, const SurfaceFeatures&) = default;
    /// What either takes.
    friend SurfaceFeatures operator|(const SurfaceFeatures& a, const SurfaceFeatures& b) {
        return {a.glossy || b.glossy, a.mirror || b.mirror, a.textured || b.textured};
    }
};

/// Perceptual roughness over the points of a material.
struct RoughnessRange {
    float least = 1.0f;
    float most = 1.0f;
};

/// Least and largest byte of each channel over a texture, R, G, B, A.
struct TextureRange {
    std::array<std::uint8_t, 4> least{255, 255, 255, 255};
    std::array<std::uint8_t, 4> most{0, 0, 0, 0};

    friend bool operator==(const TextureRange&, const TextureRange&) = default;
};
TextureRange find_texture_range(const Texture& texture);

/// What is known of the textures of a scene, one entry each.
using TextureRanges = std::vector<std::optional<TextureRange>>;

/// What rendering a scene takes. It picks the specialization of every kernel and decides which resources
/// exist at all.
struct Requirements {
    std::uint64_t triangles = 0;
    std::uint64_t vertices = 0;
    std::uint32_t instances = 0;
    std::uint32_t materials = 0;  ///< used by an instance
    std::uint32_t textures = 0;   ///< used by such a material
    std::uint64_t texels = 0;
    std::uint64_t emissive_triangles = 0;
    std::uint32_t punctual_lights = 0;
    bool environment = false;                         ///< uniform environment
    bool glossy = false;                              ///< glossy specular lobes
    bool mirror = false;                              ///< perfect mirrors or smooth dielectrics
    std::vector<std::uint32_t> reflective_instances;  ///< with triangles and a mirror lobe; ascending
    std::vector<std::uint32_t> glossy_instances;      ///< with triangles and a glossy lobe; ascending
    std::vector<SurfaceFeatures> surfaces;            ///< of each material, in use or not
    std::vector<RoughnessRange> roughness;            ///< of each material
    std::vector<bool> diffuse;  ///< of each material, whether some point reflects diffusely
    /// Most specular reflections a ray can meet: 0 without specular lobes, 1 where all surfaces that have one
    /// lie in one plane, else unbounded.
    std::uint32_t max_depth = 0;
};

/// Requirements::max_depth where surfaces with specular lobes can face each other.
inline constexpr std::uint32_t kUnboundedDepth = 0xffffffffu;

/// Whether some point of the material reflects like a perfect mirror.
bool may_be_mirror(const Scene& scene, const Material& material);
/// Whether some point of the material has a glossy specular lobe.
bool may_be_glossy(const Scene& scene, const Material& material);

/// @param scene valid: check_scene()
Requirements find_requirements(const Scene& scene);
/// All of them but max_depth, which takes a pass over vertices: what is left goes over instances, materials
/// and textures.
/// @param ranges one of each texture; those that are asked for and missing are found and put there
Requirements find_requirements_but_depth(const Scene& scene, TextureRanges& ranges);
/// Requirements::max_depth. It depends on where the vertices of instances with a specular lobe are, and on
/// nothing else.
/// @param needs all else that the scene requires
std::uint32_t find_max_depth(const Scene& scene, const Requirements& needs);

}  // namespace utsuri
