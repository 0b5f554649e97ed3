// SPDX-License-Identifier: Apache-2.0
// Kernels whose work may be more than one dispatch takes: the same bits however it is cut.
#include "renderers/reflection/glossy/map_prefilter.h"
#include "support/test_device.h"

#include "gpu/budgeted_run.h"

#include "interop/bindings.h"
#include "interop/glossy_map.h"
#include "interop/reflection.h"
#include "interop/specialization.h"
#include "interop/workgroup.h"
#include "kernels/cut_polygons.h"
#include "kernels/halve_map.h"
#include "kernels/prefilter_map.h"
#include "kernels/prefix_sum.h"
#include "kernels/reflect_vertices.h"
#include "kernels/sort_polygons.h"

#include <array>
#include <cstdint>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace utsuri {
namespace {

/// What dispatches are cut to: one workgroup, a number that divides nothing here, and all at once.
constexpr std::array kMostGroups = {1u, 3u, kMaxGroups};

class RandomNumbers {
  public:
    /// In [-1, 1).
    float next() { return static_cast<float>(engine_() >> 8) * 0x1p-23f - 1.0f; }
    glm::vec3 vector() {
        const float x = next();
        const float y = next();
        return {x, y, next()};
    }

  private:
    std::mt19937 engine_{7};
};

/// All that a buffer holds.
std::vector<std::uint32_t> words_of(const Buffer& buffer) {
    return buffer.download_records<std::uint32_t>(buffer.size() / sizeof(std::uint32_t));
}

class SplitDispatch : public DeviceTest {
  protected:
    static Buffer zeroed(std::uint64_t bytes, const std::string& name) {
        Buffer buffer(device(), bytes, name);
        buffer.fill_with_zero();
        return buffer;
    }

    template <typename Push>
    static void run_over(const std::string& name, std::span<const std::uint32_t> spirv,
                         const Specialization& constants, const Bindings& bindings, const Push& push,
                         std::uint32_t count, std::uint32_t most_groups) {
        const Kernel kernel(device(), name, spirv, constants, sizeof(Push));
        const BindingSet set = kernel.bind(bindings);
        device().run(name, [&](const vk::raii::CommandBuffer& commands) {
            kernel.dispatch_over(commands, set, push, count, most_groups);
        });
    }
};

TEST_F(SplitDispatch, VerticesReflectTheSame) {
    constexpr std::uint32_t kVertices = 1000;
    RandomNumbers numbers;
    std::vector<interop::ReflectorVertex> vertices(kVertices);
    for (interop::ReflectorVertex& vertex : vertices)
        vertex = {numbers.vector(), numbers.vector()};
    const Buffer input = make_buffer<interop::ReflectorVertex>(device(), vertices, "vertices");
    std::vector<std::vector<std::uint32_t>> results;
    for (const std::uint32_t most_groups : kMostGroups) {
        const Buffer output = zeroed(kVertices * sizeof(interop::VertexReflection), "reflections");
        const interop::ReflectVerticesPush push{{0, 0, 5}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}, 0, 0};
        run_over(
            "reflect_vertices", kernels::reflect_vertices, {},
            {{interop::BINDING_REFLECTOR_VERTICES, &input}, {interop::BINDING_VERTEX_REFLECTIONS, &output}},
            push, kVertices, most_groups);
        results.push_back(words_of(output));
    }
    EXPECT_EQ(results[0], results[2]);
    EXPECT_EQ(results[1], results[2]);
}

// One more than the workgroups that every device takes have invocations.
TEST_F(SplitDispatch, TheVertexBeyondTheLargestDispatchIsReflected) {
    constexpr std::uint32_t kVertices = kMaxGroups * interop::WORKGROUP_SIZE + 1;
    Buffer input = zeroed(std::uint64_t{kVertices} * sizeof(interop::ReflectorVertex), "vertices");
    const interop::ReflectorVertex vertex{{1, -1, 0}, {0, 1, 0}};
    for (const std::uint32_t at : {0u, kVertices - 1}) {
        input.upload(std::as_bytes(std::span(&vertex, 1)),
                     std::uint64_t{at} * sizeof(interop::ReflectorVertex));
    }
    const Buffer output = zeroed(std::uint64_t{kVertices} * sizeof(interop::VertexReflection), "reflections");
    const interop::ReflectVerticesPush from_zero{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}, 0, 0};
    run_over("reflect_vertices", kernels::reflect_vertices, {},
             {{interop::BINDING_REFLECTOR_VERTICES, &input}, {interop::BINDING_VERTEX_REFLECTIONS, &output}},
             from_zero, kVertices, kMaxGroups);
    for (const std::uint32_t at : {0u, kVertices - 1}) {
        interop::VertexReflection found{};
        output.download(std::as_writable_bytes(std::span(&found, 1)),
                        std::uint64_t{at} * sizeof(interop::VertexReflection));
        EXPECT_EQ(found.direction, glm::vec3(1, 1, 0)) << at;
    }
}

/// Triangles whose corners reflect in directions of their own, so that many straddle faces of a cube.
struct Polygons {
    std::vector<interop::ReflectorTriangle> triangles;
    std::vector<interop::ReflectorVertex> vertices;
    std::vector<interop::VertexReflection> reflections;
};

Polygons random_polygons(std::uint32_t count) {
    RandomNumbers numbers;
    Polygons polygons;
    for (std::uint32_t i = 0; i < count; ++i) {
        polygons.triangles.push_back(
            {{3 * i, 3 * i + 1, 3 * i + 2}, i, {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(0, 1)}, 0});
        const glm::vec3 about = numbers.vector();
        for (int corner = 0; corner < 3; ++corner) {
            polygons.vertices.push_back({numbers.vector(), numbers.vector()});
            polygons.reflections.push_back({about + 0.5f * numbers.vector(), glm::vec2(0.0f)});
        }
    }
    return polygons;
}

std::array<interop::MapFace, interop::MAP_MOST_FACES> faces_of_a_cube() {
    std::array<interop::MapFace, interop::MAP_MOST_FACES> faces{};
    for (std::uint32_t i = 0; i < interop::CUBE_FACES; ++i) {
        const auto axis = [i](std::uint32_t offset) {
            glm::vec3 unit(0.0f);
            unit[static_cast<int>((i / 2 + offset) % 3)] = 1.0f;
            return unit;
        };
        faces[i] = {i % 2 == 0 ? axis(0) : -axis(0), axis(1), axis(2), 1.0f};
    }
    return faces;
}

class SplitClipping : public SplitDispatch {
  protected:
    static constexpr std::uint32_t kPolygons = 500;
    static constexpr std::uint32_t kMostCut = 16 * kPolygons;

    /// Sorts and cuts the polygons as ReflectorDrawer does.
    /// @returns what all buffers hold then, the counts of pieces first
    static std::vector<std::vector<std::uint32_t>> cut(std::uint32_t most_groups) {
        const Polygons polygons = random_polygons(kPolygons);
        const auto cube = faces_of_a_cube();
        const Buffer triangles =
            make_buffer<interop::ReflectorTriangle>(device(), polygons.triangles, "triangles");
        const Buffer vertices =
            make_buffer<interop::ReflectorVertex>(device(), polygons.vertices, "vertices");
        const Buffer reflections =
            make_buffer<interop::VertexReflection>(device(), polygons.reflections, "reflections");
        const Buffer faces = make_buffer<interop::MapFace>(device(), cube, "faces");
        const Buffer cut_counts = zeroed((kPolygons + 1) * sizeof(std::uint32_t), "cut counts");
        const Buffer straddling = zeroed((kPolygons + 1) * sizeof(std::uint32_t), "straddling");
        const Buffer straddlers = zeroed(kPolygons * sizeof(std::uint32_t), "straddlers");
        const Buffer whole = zeroed(kPolygons * sizeof(interop::Piece), "whole pieces");
        const Buffer pieces = zeroed(kMostCut * sizeof(interop::Piece), "cut pieces");
        const Buffer corners = zeroed(std::uint64_t{3} * kMostCut * sizeof(interop::PieceCorner), "corners");
        const Buffer arguments = zeroed(3 * sizeof(interop::DrawArguments), "draw arguments");
        const Bindings bindings = {{interop::BINDING_REFLECTOR_TRIANGLES, &triangles},
                                   {interop::BINDING_REFLECTOR_VERTICES, &vertices},
                                   {interop::BINDING_VERTEX_REFLECTIONS, &reflections},
                                   {interop::BINDING_MAP_FACES, &faces},
                                   {interop::BINDING_CUT_COUNTS, &cut_counts},
                                   {interop::BINDING_STRADDLING, &straddling},
                                   {interop::BINDING_DRAWN_POLYGONS, &straddlers},
                                   {interop::BINDING_WHOLE_PIECES, &whole},
                                   {interop::BINDING_CUT_PIECES, &pieces},
                                   {interop::BINDING_CUT_CORNERS, &corners},
                                   {interop::BINDING_DRAW_ARGUMENTS, &arguments}};
        run_twice("sort_polygons", kernels::sort_polygons, bindings, straddling, most_groups);
        run_twice("cut_polygons", kernels::cut_polygons, bindings, cut_counts, most_groups);
        std::vector<std::vector<std::uint32_t>> results;
        for (const Buffer* buffer :
             {&cut_counts, &straddling, &straddlers, &whole, &pieces, &corners, &arguments})
            results.push_back(words_of(*buffer));
        return results;
    }

  private:
    static void run_twice(const std::string& name, std::span<const std::uint32_t> spirv,
                          const Bindings& bindings, const Buffer& counts, std::uint32_t most_groups) {
        const interop::ClipPush push{kPolygons, interop::CUBE_FACES, kMostCut, 0, 0};
        Specialization constants{{interop::SPEC_FACE_COUNT, interop::CUBE_FACES}};
        run_over(name, spirv, constants, bindings, push, kPolygons, most_groups);
        const Kernel sum(device(), "prefix_sum", kernels::prefix_sum, {}, sizeof(interop::PrefixSumPush));
        const BindingSet set = sum.bind({{interop::BINDING_SUMMED_COUNTS, &counts}});
        device().run("prefix_sum", [&](const vk::raii::CommandBuffer& commands) {
            sum.dispatch(commands, set, interop::PrefixSumPush{kPolygons}, 1);
        });
        constants[interop::SPEC_WRITES] = 1;
        run_over(name, spirv, constants, bindings, push, kPolygons, most_groups);
    }
};

TEST_F(SplitClipping, PolygonsAreCutTheSame) {
    const auto whole = cut(kMaxGroups);
    // More straddle than a workgroup has invocations, and no piece lacks room.
    EXPECT_GT(whole[1].back(), interop::WORKGROUP_SIZE);
    EXPECT_GT(whole[0].back(), whole[1].back());
    EXPECT_LE(whole[0].back(), kMostCut);
    EXPECT_EQ(cut(1), whole);
    EXPECT_EQ(cut(3), whole);
}

class SplitConvolution : public SplitDispatch {
  protected:
    static constexpr std::uint32_t kSource = 32;
    static constexpr std::uint32_t kFinestTexels = interop::GLOSSY_MAP_FACES * kSource * kSource;

    /// Texels of a cube of maps with all of its coarser levels.
    static std::vector<float> random_source(std::uint32_t channels) {
        RandomNumbers numbers;
        std::vector<float> values(channels * MapPrefilter::source_texels(kSource));
        for (float& value : values)
            value = 1.0f + numbers.next();
        return values;
    }

    Buffer light_ = make_buffer<float>(device(), random_source(3), "light");
    Buffer inverse_distances_ = make_buffer<float>(device(), random_source(1), "inverse distances");
    Specialization constants_{{interop::SPEC_KEEPS_DISTANCES, 1}};
};

TEST_F(SplitConvolution, MapsAreHalvedTheSame) {
    constexpr std::uint32_t kHalf = kSource / 2;
    std::vector<std::vector<std::uint32_t>> results;
    for (const std::uint32_t most_groups : kMostGroups) {
        run_over("halve_map", kernels::halve_map, constants_,
                 {{interop::BINDING_MAP_TEXELS, &light_},
                  {interop::BINDING_MAP_INVERSE_DISTANCES, &inverse_distances_}},
                 interop::HalveMapPush{0, kFinestTexels, kHalf, 0, 0},
                 interop::GLOSSY_MAP_FACES * kHalf * kHalf, most_groups);
        results.push_back(words_of(light_));
        const std::vector<std::uint32_t> distances = words_of(inverse_distances_);
        results.back().insert(results.back().end(), distances.begin(), distances.end());
        // The next run finds nothing of this one.
        light_ = make_buffer<float>(device(), random_source(3), "light");
        inverse_distances_ = make_buffer<float>(device(), random_source(1), "inverse distances");
    }
    EXPECT_EQ(results[0], results[2]);
    EXPECT_EQ(results[1], results[2]);
}

TEST_F(SplitConvolution, MapsAreConvolvedTheSameWithinAnyBudget) {
    constexpr std::uint32_t kSize = 16;
    const auto texels = static_cast<std::uint32_t>(prefiltered_texels(kSize));
    const Kernel kernel(device(), "prefilter_map", kernels::prefilter_map, constants_,
                        sizeof(interop::PrefilterMapPush));
    std::vector<std::vector<std::uint32_t>> results;
    // No dispatch is as short as the first budget, so that each gets one workgroup; none is as long as the
    // last.
    for (const double seconds : {1e-12, 1e-4, 1e6}) {
        const Buffer convolved = zeroed(texels * sizeof(glm::vec3), "convolved");
        const Buffer distances = zeroed(texels * sizeof(float), "convolved distances");
        const BindingSet set = kernel.bind({{interop::BINDING_MAP_TEXELS, &light_},
                                            {interop::BINDING_MAP_INVERSE_DISTANCES, &inverse_distances_},
                                            {interop::BINDING_GLOSSY_TEXELS, &convolved},
                                            {interop::BINDING_GLOSSY_INVERSE_DISTANCES, &distances}});
        DispatchBudget budget(seconds);
        run_in_budget(device(), "convolve", kernel, set,
                      interop::PrefilterMapPush{kSource, kSize, 0, 0.3f, 0, 0}, texels, budget);
        results.push_back(words_of(convolved));
        const std::vector<std::uint32_t> found = words_of(distances);
        results.back().insert(results.back().end(), found.begin(), found.end());
    }
    EXPECT_EQ(results[0], results[2]);
    EXPECT_EQ(results[1], results[2]);
    // Nothing is left out: light of at least 0 is nowhere 0 once it is convolved.
    for (const std::uint32_t word : results[0])
        ASSERT_NE(word, 0u);
}

}  // namespace
}  // namespace utsuri
