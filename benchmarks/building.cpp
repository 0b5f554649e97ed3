// SPDX-License-Identifier: Apache-2.0
// Triangles per second of the BVH build, on random triangles and on a closed surface.
#include "geometry/bvh.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <random>

namespace {

struct Geometry {
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> triangles;
};

Geometry random_soup(std::uint32_t count) {
    std::mt19937 generator(1);
    std::uniform_real_distribution<float> place(-1.0f, 1.0f);
    std::uniform_real_distribution<float> edge(-0.01f, 0.01f);
    Geometry geometry;
    for (std::uint32_t i = 0; i < count; ++i) {
        const glm::vec3 corner(place(generator), place(generator), place(generator));
        for (int k = 0; k < 3; ++k) {
            geometry.positions.push_back(corner +
                                         glm::vec3(edge(generator), edge(generator), edge(generator)));
        }
        geometry.triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    return geometry;
}

/// A wavy height field, as scanned or simulated surfaces are.
Geometry surface(std::uint32_t count) {
    const auto edge = static_cast<std::uint32_t>(std::sqrt(count / 2.0));
    Geometry geometry;
    for (std::uint32_t y = 0; y <= edge; ++y) {
        for (std::uint32_t x = 0; x <= edge; ++x) {
            const glm::vec2 p = glm::vec2(x, y) / static_cast<float>(edge);
            geometry.positions.emplace_back(p.x, 0.05f * std::sin(40.0f * p.x) * std::cos(31.0f * p.y), p.y);
        }
    }
    for (std::uint32_t y = 0; y < edge; ++y) {
        for (std::uint32_t x = 0; x < edge; ++x) {
            const std::uint32_t corner = y * (edge + 1) + x;
            geometry.triangles.emplace_back(corner, corner + edge + 1, corner + 1);
            geometry.triangles.emplace_back(corner + 1, corner + edge + 1, corner + edge + 2);
        }
    }
    return geometry;
}

void build(benchmark::State& state, const Geometry& geometry) {
    for (auto _ : state)
        benchmark::DoNotOptimize(utsuri::build_bvh(geometry.positions, geometry.triangles));
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(geometry.triangles.size()));
}

void build_soup(benchmark::State& state) {
    build(state, random_soup(static_cast<std::uint32_t>(state.range(0))));
}
void build_surface(benchmark::State& state) {
    build(state, surface(static_cast<std::uint32_t>(state.range(0))));
}

BENCHMARK(build_soup)->Range(1 << 10, 1 << 20)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(build_surface)->Range(1 << 10, 1 << 20)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
