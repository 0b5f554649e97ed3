// SPDX-License-Identifier: Apache-2.0
#include "base/sampler.h"

namespace utsuri {
namespace {

std::uint32_t reverse_bits(std::uint32_t x) {
    x = ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
    x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
    x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
    x = ((x >> 8) & 0x00ff00ffu) | ((x & 0x00ff00ffu) << 8);
    return (x >> 16) | (x << 16);
}

std::uint32_t hash_combine(std::uint32_t a, std::uint32_t b) {
    return hash(a ^ hash(b));
}

float to_unit_interval(std::uint32_t bits) {
    return static_cast<float>(bits >> 8) * 0x1p-24f;
}

}  // namespace

std::uint32_t hash(std::uint32_t x) {
    const std::uint32_t state = x * 747796405u + 2891336453u;
    const std::uint32_t word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (word >> 22u) ^ word;
}

std::uint32_t owen_scramble(std::uint32_t x, std::uint32_t seed) {
    x = reverse_bits(x);
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16) | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return reverse_bits(x);
}

glm::uvec2 sobol_2d(std::uint32_t index) {
    std::uint32_t y = index;
    y ^= (y & 0xaaaaaaaau) >> 1;
    y ^= (y & 0xccccccccu) >> 2;
    y ^= (y & 0xf0f0f0f0u) >> 4;
    y ^= (y & 0xff00ff00u) >> 8;
    y ^= (y & 0xffff0000u) >> 16;
    return {reverse_bits(index), reverse_bits(y)};
}

std::uint32_t sampler_key(glm::uvec2 pixel, std::uint32_t seed, std::uint32_t estimate) {
    return hash_combine(hash_combine(hash_combine(pixel.x, pixel.y), seed), estimate);
}

glm::vec2 sample_2d(std::uint32_t key, std::uint32_t index, std::uint32_t dimension_pair) {
    const std::uint32_t seed = hash_combine(key, dimension_pair);
    const glm::uvec2 point = sobol_2d(owen_scramble(index, seed));
    return {to_unit_interval(owen_scramble(point.x, hash(seed ^ 0x9e3779b9u))),
            to_unit_interval(owen_scramble(point.y, hash(seed ^ 0x7f4a7c15u)))};
}

}  // namespace utsuri
