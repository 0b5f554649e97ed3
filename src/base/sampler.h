// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>

#include <cstdint>

namespace utsuri {

// The host's copy of shaders/lib/sampler.glsl, bit for bit; see there for sources.

/// A bijective hash of 32 bits.
std::uint32_t hash(std::uint32_t x);
/// Owen scrambling of the bits of x.
std::uint32_t owen_scramble(std::uint32_t x, std::uint32_t seed);
/// Point `index` of the two-dimensional Sobol sequence.
glm::uvec2 sobol_2d(std::uint32_t index);
/// What distinguishes the sample sequences of pixels, seeds and estimates.
std::uint32_t sampler_key(glm::uvec2 pixel, std::uint32_t seed, std::uint32_t estimate);
/// Two numbers in [0, 1) for sample `index` in a pair of dimensions.
glm::vec2 sample_2d(std::uint32_t key, std::uint32_t index, std::uint32_t dimension_pair);

}  // namespace utsuri
