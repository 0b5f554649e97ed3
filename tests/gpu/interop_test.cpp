// SPDX-License-Identifier: Apache-2.0
// Structs of shaders/interop have the same layout in C++ and in the compiled kernels.
#include "support/product_kernels.h"
#include "support/spirv_module.h"

#include "interop/bvh.h"
#include "interop/distance_map.h"
#include "interop/frame.h"
#include "interop/glossy_map.h"
#include "interop/light_mesh.h"
#include "interop/light_sums.h"
#include "interop/light_tree.h"
#include "interop/lobe_albedo.h"
#include "interop/radiance_bounds.h"
#include "interop/raster.h"
#include "interop/rays.h"
#include "interop/reflection.h"
#include "interop/scene.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>

namespace utsuri {
namespace {

namespace fs = std::filesystem;
using test::SpirvModule;

struct HostMember {
    std::string name;
    std::size_t offset;
};
struct HostStruct {
    std::size_t size;
    std::vector<HostMember> members;
};

#define AT(type, member)                         \
    HostMember {                                 \
#member, offsetof(interop::type, member) \
    }

/// Every struct of shaders/interop as the C++ compiler lays it out.
std::map<std::string, HostStruct> host_structs() {
    using namespace interop;
    return {
        {"BvhNode",
         {sizeof(BvhNode),
          {AT(BvhNode, origin_exponents), AT(BvhNode, bases_meta), AT(BvhNode, lower_xy),
           AT(BvhNode, lower_z_upper_x), AT(BvhNode, upper_yz)}}},
        {"BvhTriangle",
         {sizeof(BvhTriangle), {AT(BvhTriangle, v0), AT(BvhTriangle, v1), AT(BvhTriangle, v2)}}},
        {"CameraInfo",
         {sizeof(CameraInfo),
          {AT(CameraInfo, origin), AT(CameraInfo, right), AT(CameraInfo, up), AT(CameraInfo, forward)}}},
        {"FramePush",
         {sizeof(FramePush),
          {AT(FramePush, camera), AT(FramePush, width), AT(FramePush, height), AT(FramePush, first_row),
           AT(FramePush, rows), AT(FramePush, first_tile), AT(FramePush, sample_begin),
           AT(FramePush, sample_end), AT(FramePush, seed), AT(FramePush, max_depth),
           AT(FramePush, excluded_instance)}}},
        {"DistanceSample",
         {sizeof(DistanceSample),
          {AT(DistanceSample, centre), AT(DistanceSample, corner), AT(DistanceSample, bend)}}},
        {"DistanceBounds",
         {sizeof(DistanceBounds), {AT(DistanceBounds, nearest), AT(DistanceBounds, farthest)}}},
        {"DistanceMapInfo",
         {sizeof(DistanceMapInfo),
          {AT(DistanceMapInfo, first_sample), AT(DistanceMapInfo, first_bounds),
           AT(DistanceMapInfo, plane_normal), AT(DistanceMapInfo, plane_distance)}}},
        {"MeasuredView",
         {sizeof(MeasuredView),
          {AT(MeasuredView, capture_point), AT(MeasuredView, excluded_instance),
           AT(MeasuredView, plane_normal), AT(MeasuredView, plane_distance)}}},
        {"MeasureFacePush",
         {sizeof(MeasureFacePush),
          {AT(MeasureFacePush, view), AT(MeasureFacePush, face), AT(MeasureFacePush, first_sample),
           AT(MeasureFacePush, begin), AT(MeasureFacePush, end)}}},
        {"BoundDistancesPush",
         {sizeof(BoundDistancesPush),
          {AT(BoundDistancesPush, first_source), AT(BoundDistancesPush, first_bounds),
           AT(BoundDistancesPush, size)}}},
        {"RadianceSample",
         {sizeof(RadianceSample), {AT(RadianceSample, centre), AT(RadianceSample, corner)}}},
        {"FilmSum", {sizeof(FilmSum), {AT(FilmSum, sum), AT(FilmSum, compensation)}}},
        {"FilmPixel", {sizeof(FilmPixel), {AT(FilmPixel, halves)}}},
        {"Counters",
         {sizeof(Counters),
          {AT(Counters, rays), AT(Counters, nonfinite), AT(Counters, lookups), AT(Counters, traced),
           AT(Counters, truncated), AT(Counters, incomplete)}}},
        {"AovPixel",
         {sizeof(AovPixel),
          {AT(AovPixel, depth), AT(AovPixel, position), AT(AovPixel, geometric_normal),
           AT(AovPixel, shading_normal), AT(AovPixel, albedo), AT(AovPixel, texcoord), AT(AovPixel, triangle),
           AT(AovPixel, instance), AT(AovPixel, material), AT(AovPixel, mirror)}}},
        {"LightMeshRoot",
         {sizeof(LightMeshRoot),
          {AT(LightMeshRoot, tree), AT(LightMeshRoot, rows), AT(LightMeshRoot, first_cell),
           AT(LightMeshRoot, unused)}}},
        {"LightMeshSplit",
         {sizeof(LightMeshSplit),
          {AT(LightMeshSplit, constant), AT(LightMeshSplit, slope), AT(LightMeshSplit, first),
           AT(LightMeshSplit, second)}}},
        {"LightMeshSide",
         {sizeof(LightMeshSide),
          {AT(LightMeshSide, constant), AT(LightMeshSide, red_bounds), AT(LightMeshSide, along_b1),
           AT(LightMeshSide, green_bounds), AT(LightMeshSide, along_b2), AT(LightMeshSide, blue_bounds)}}},
        {"LightMeshPoint",
         {sizeof(LightMeshPoint),
          {AT(LightMeshPoint, front), AT(LightMeshPoint, back), AT(LightMeshPoint, lit),
           AT(LightMeshPoint, dark)}}},
        {"LightMeshPlace",
         {sizeof(LightMeshPlace),
          {AT(LightMeshPlace, triangle), AT(LightMeshPlace, b1), AT(LightMeshPlace, b2),
           AT(LightMeshPlace, known), AT(LightMeshPlace, lit), AT(LightMeshPlace, dark)}}},
        {"LightPush",
         {sizeof(LightPush),
          {AT(LightPush, first_point), AT(LightPush, end_point), AT(LightPush, samples), AT(LightPush, seed),
           AT(LightPush, light_bounds), AT(LightPush, plain_triangles), AT(LightPush, triangles),
           AT(LightPush, changed_boxes)}}},
        {"LightGroup", {sizeof(LightGroup), {AT(LightGroup, reference), AT(LightGroup, most_samples)}}},
        {"SummedLight",
         {sizeof(SummedLight),
          {AT(SummedLight, middle), AT(SummedLight, size_squared), AT(SummedLight, area),
           AT(SummedLight, group), AT(SummedLight, radiance), AT(SummedLight, is_double_sided),
           AT(SummedLight, v0), AT(SummedLight, light), AT(SummedLight, v1), AT(SummedLight, first_piece),
           AT(SummedLight, v2), AT(SummedLight, unused)}}},
        {"LightBounds",
         {sizeof(LightBounds), {AT(LightBounds, infinite), AT(LightBounds, lower), AT(LightBounds, upper)}}},
        {"ChangedBox", {sizeof(ChangedBox), {AT(ChangedBox, lower), AT(ChangedBox, upper)}}},
        {"FrameInfo",
         {sizeof(FrameInfo),
          {AT(FrameInfo, jitter), AT(FrameInfo, pixel_size), AT(FrameInfo, width), AT(FrameInfo, near_plane),
           AT(FrameInfo, sample_index), AT(FrameInfo, seed), AT(FrameInfo, max_depth),
           AT(FrameInfo, tolerance)}}},
        {"ViewPush",
         {sizeof(ViewPush),
          {AT(ViewPush, camera), AT(ViewPush, normal), AT(ViewPush, offset), AT(ViewPush, number),
           AT(ViewPush, reflections), AT(ViewPush, next)}}},
        {"DeferredReflection",
         {sizeof(DeferredReflection),
          {AT(DeferredReflection, triangle), AT(DeferredReflection, b1), AT(DeferredReflection, b2),
           AT(DeferredReflection, request)}}},
        {"DeferredView", {sizeof(DeferredView), {AT(DeferredView, eye), AT(DeferredView, reflections)}}},
        {"DeferredCount",
         {sizeof(DeferredCount),
          {AT(DeferredCount, groups_x), AT(DeferredCount, groups_y), AT(DeferredCount, groups_z),
           AT(DeferredCount, pixels)}}},
        {"DeferredPush",
         {sizeof(DeferredPush),
          {AT(DeferredPush, first_row), AT(DeferredPush, rows), AT(DeferredPush, first_tile)}}},
        {"AddDrawnPush", {sizeof(AddDrawnPush), {AT(AddDrawnPush, pixels), AT(AddDrawnPush, sample_index)}}},
        {"RayInfo",
         {sizeof(RayInfo),
          {AT(RayInfo, origin), AT(RayInfo, direction), AT(RayInfo, t_max), AT(RayInfo, excluded)}}},
        {"HitInfo",
         {sizeof(HitInfo), {AT(HitInfo, t), AT(HitInfo, triangle), AT(HitInfo, b1), AT(HitInfo, b2)}}},
        {"TraceRaysPush", {sizeof(TraceRaysPush), {AT(TraceRaysPush, first), AT(TraceRaysPush, count)}}},
        {"ProxyPlane", {sizeof(ProxyPlane), {AT(ProxyPlane, outward), AT(ProxyPlane, offset)}}},
        {"ProxyInfo",
         {sizeof(ProxyInfo),
          {AT(ProxyInfo, lower), AT(ProxyInfo, upper), AT(ProxyInfo, first_plane), AT(ProxyInfo, planes)}}},
        {"ProbeRange", {sizeof(ProbeRange), {AT(ProbeRange, first), AT(ProbeRange, count)}}},
        {"ProbeInfo",
         {sizeof(ProbeInfo),
          {AT(ProbeInfo, capture_point), AT(ProbeInfo, first_texel), AT(ProbeInfo, map_size),
           AT(ProbeInfo, proxy), AT(ProbeInfo, map_right), AT(ProbeInfo, map_up),
           AT(ProbeInfo, map_forward)}}},
        {"ReflectorVertex",
         {sizeof(ReflectorVertex), {AT(ReflectorVertex, position), AT(ReflectorVertex, normal)}}},
        {"VertexReflection",
         {sizeof(VertexReflection), {AT(VertexReflection, direction), AT(VertexReflection, sphere_map)}}},
        {"MapFace",
         {sizeof(MapFace),
          {AT(MapFace, outward), AT(MapFace, right), AT(MapFace, up), AT(MapFace, half_diagonal)}}},
        {"ReflectorTriangle",
         {sizeof(ReflectorTriangle),
          {AT(ReflectorTriangle, vertices), AT(ReflectorTriangle, triangle), AT(ReflectorTriangle, places),
           AT(ReflectorTriangle, reflector)}}},
        {"Piece", {sizeof(Piece), {AT(Piece, polygon), AT(Piece, face)}}},
        {"PieceCorner",
         {sizeof(PieceCorner),
          {AT(PieceCorner, position), AT(PieceCorner, reflection), AT(PieceCorner, place)}}},
        {"PrefixSumPush", {sizeof(PrefixSumPush), {AT(PrefixSumPush, count)}}},
        {"ClipPush",
         {sizeof(ClipPush),
          {AT(ClipPush, polygons), AT(ClipPush, faces), AT(ClipPush, most_cut), AT(ClipPush, begin),
           AT(ClipPush, end)}}},
        {"DrawArguments",
         {sizeof(DrawArguments),
          {AT(DrawArguments, vertex_count), AT(DrawArguments, instance_count),
           AT(DrawArguments, first_vertex), AT(DrawArguments, first_instance)}}},
        {"ReflectVerticesPush",
         {sizeof(ReflectVerticesPush),
          {AT(ReflectVerticesPush, eye), AT(ReflectVerticesPush, right), AT(ReflectVerticesPush, up),
           AT(ReflectVerticesPush, forward), AT(ReflectVerticesPush, begin), AT(ReflectVerticesPush, end)}}},
        {"ResolveMapPush",
         {sizeof(ResolveMapPush),
          {AT(ResolveMapPush, texels), AT(ResolveMapPush, first_texel), AT(ResolveMapPush, samples)}}},
        {"GlossyMapInfo",
         {sizeof(GlossyMapInfo),
          {AT(GlossyMapInfo, first_probe), AT(GlossyMapInfo, probes), AT(GlossyMapInfo, levels),
           AT(GlossyMapInfo, least_roughness), AT(GlossyMapInfo, steps_per_unit),
           AT(GlossyMapInfo, blend_width)}}},
        {"GlossyProbe",
         {sizeof(GlossyProbe),
          {AT(GlossyProbe, capture_point), AT(GlossyProbe, proxy), AT(GlossyProbe, first_level)}}},
        {"GlossyLevel", {sizeof(GlossyLevel), {AT(GlossyLevel, first_texel), AT(GlossyLevel, size)}}},
        {"LobeAlbedo",
         {sizeof(LobeAlbedo), {AT(LobeAlbedo, constant), AT(LobeAlbedo, schlick), AT(LobeAlbedo, lost)}}},
        {"MeasureInverseDistancesPush",
         {sizeof(MeasureInverseDistancesPush),
          {AT(MeasureInverseDistancesPush, capture_point), AT(MeasureInverseDistancesPush, excluded_instance),
           AT(MeasureInverseDistancesPush, size), AT(MeasureInverseDistancesPush, begin),
           AT(MeasureInverseDistancesPush, end)}}},
        {"HalveMapPush",
         {sizeof(HalveMapPush),
          {AT(HalveMapPush, first_source), AT(HalveMapPush, first_texel), AT(HalveMapPush, size),
           AT(HalveMapPush, begin), AT(HalveMapPush, end)}}},
        {"PrefilterMapPush",
         {sizeof(PrefilterMapPush),
          {AT(PrefilterMapPush, source_size), AT(PrefilterMapPush, size), AT(PrefilterMapPush, first_texel),
           AT(PrefilterMapPush, alpha), AT(PrefilterMapPush, begin), AT(PrefilterMapPush, end)}}},
        {"TriangleInfo",
         {sizeof(TriangleInfo),
          {AT(TriangleInfo, vertices), AT(TriangleInfo, material), AT(TriangleInfo, instance),
           AT(TriangleInfo, light), AT(TriangleInfo, layers)}}},
        {"TextureSlotInfo",
         {sizeof(TextureSlotInfo),
          {AT(TextureSlotInfo, texture), AT(TextureSlotInfo, sampling), AT(TextureSlotInfo, first_texel),
           AT(TextureSlotInfo, width), AT(TextureSlotInfo, height)}}},
        {"MaterialInfo",
         {sizeof(MaterialInfo),
          {AT(MaterialInfo, base_colour), AT(MaterialInfo, metallic), AT(MaterialInfo, emissive),
           AT(MaterialInfo, roughness), AT(MaterialInfo, dielectric_f0), AT(MaterialInfo, specular),
           AT(MaterialInfo, ior), AT(MaterialInfo, double_sided), AT(MaterialInfo, base_colour_texture),
           AT(MaterialInfo, metallic_roughness_texture), AT(MaterialInfo, emissive_texture),
           AT(MaterialInfo, specular_texture), AT(MaterialInfo, specular_colour_texture)}}},
        {"LightInfo",
         {sizeof(LightInfo),
          {AT(LightInfo, type), AT(LightInfo, triangle), AT(LightInfo, probability), AT(LightInfo, position),
           AT(LightInfo, direction), AT(LightInfo, intensity), AT(LightInfo, range),
           AT(LightInfo, spot_scale), AT(LightInfo, spot_offset), AT(LightInfo, path),
           AT(LightInfo, path_length)}}},
        {"LightCluster",
         {sizeof(LightCluster),
          {AT(LightCluster, centre), AT(LightCluster, radius), AT(LightCluster, power),
           AT(LightCluster, axis), AT(LightCluster, cos_spread), AT(LightCluster, child)}}},
        {"LightTreeNode", {sizeof(LightTreeNode), {AT(LightTreeNode, first), AT(LightTreeNode, second)}}},
    };
}

#undef AT

/// What differs between the two layouts; empty if nothing.
std::string layout_problem(const SpirvModule::Struct& device, const HostStruct& host) {
    if (device.members.size() != host.members.size()) {
        return fmt::format("{} members, not {}", device.members.size(), host.members.size());
    }
    for (std::size_t i = 0; i < host.members.size(); ++i) {
        const SpirvModule::Member& member = device.members[i];
        if (member.name != host.members[i].name || member.offset != host.members[i].offset) {
            return fmt::format("{} at {}, not {} at {}", member.name, member.offset, host.members[i].name,
                               host.members[i].offset);
        }
    }
    if (device.end() != host.size) return fmt::format("{} bytes, not {}", device.end(), host.size);
    for (const std::uint32_t stride : device.array_strides) {
        if (stride != host.size) return fmt::format("arrays of stride {}, not {}", stride, host.size);
    }
    return {};
}

/// Structs that kernels make of texels word by word, and how many words those take.
const std::map<std::string, std::size_t> kReadAsTexels = {
    {"BvhNode", 20},       {"BvhTriangle", 9},  {"LightMeshRoot", 4},  {"LightMeshSplit", 4},
    {"LightMeshSide", 12}, {"LightCluster", 8}, {"LightTreeNode", 16}, {"SummedLight", 24}};

TEST(Interop, StructsReadAsTexelsAreWordAfterWord) {
    const auto hosts = host_structs();
    for (const auto& [name, words] : kReadAsTexels)
        EXPECT_EQ(hosts.at(name).size, sizeof(std::uint32_t) * words) << name;
}

TEST(Interop, StructsHaveTheSameLayoutInEveryKernel) {
    const auto hosts = host_structs();
    std::set<std::string> met;
    for (const test::ProductKernel& kernel : test::product_kernels()) {
        const SpirvModule module(kernel.spirv);
        for (const SpirvModule::Struct& device : module.laid_out_structs()) {
            const auto host = hosts.find(device.name);
            if (host == hosts.end()) continue;  // the blocks around them
            EXPECT_EQ(layout_problem(device, host->second), "") << kernel.name << ": " << device.name;
            met.insert(device.name);
        }
    }
    for (const auto& [name, host] : hosts)
        EXPECT_TRUE(met.contains(name) || kReadAsTexels.contains(name)) << name << " is in no kernel";
}

TEST(Interop, StructsAreAllKnownToTheTest) {
    const auto hosts = host_structs();
    const std::regex definition("^struct ([A-Za-z0-9]+) \\{");
    std::set<std::string> defined;
    for (const auto& entry : fs::directory_iterator(fs::path(UTSURI_SOURCE_DIR) / "shaders" / "interop")) {
        std::ifstream stream(entry.path());
        for (std::string line; std::getline(stream, line);) {
            std::smatch match;
            if (std::regex_search(line, match, definition)) defined.insert(match[1]);
        }
    }
    EXPECT_GT(defined.size(), 0u);
    for (const std::string& name : defined)
        EXPECT_TRUE(hosts.contains(name)) << name;
    EXPECT_EQ(defined.size(), hosts.size());
}

TEST(Interop, ComparisonFindsAShiftedMemberAndAWrongStride) {
    const SpirvModule::Struct right{
        "HitInfo", {{"t", 0, 4}, {"triangle", 4, 4}, {"b1", 8, 4}, {"b2", 12, 4}}, {16}};
    EXPECT_EQ(layout_problem(right, host_structs().at("HitInfo")), "");
    SpirvModule::Struct shifted = right;
    shifted.members[2].offset = 16;
    EXPECT_NE(layout_problem(shifted, host_structs().at("HitInfo")), "");
    SpirvModule::Struct padded = right;
    padded.array_strides = {32};
    EXPECT_NE(layout_problem(padded, host_structs().at("HitInfo")), "");
}

}  // namespace
}  // namespace utsuri
