// SPDX-License-Identifier: Apache-2.0
// Counter-based samples: a pure function of (pixel, sample, dimension, seed), so a picture does not depend on how the
// work is cut. Padded two-dimensional Sobol points, Owen-scrambled and shuffled by hashing (Burley 2020, with the
// permutation constants of Vegdahl 2021). src/base/sampler.h is the same code for the host.
#ifndef UTSURI_LIB_SAMPLER
#define UTSURI_LIB_SAMPLER

/// Dimension pair 0 places the sample in its pixel; surfaces use those from 1 on.
const uint FIRST_SURFACE_DIMENSION = 1u;
/// Pairs that one surface uses: two for a light sample, one for the direction of a lobe, one for roulette.
const uint DIMENSIONS_PER_SURFACE = 4u;

/// A bijective hash of 32 bits (pcg output permutation: Jarzynski and Olano 2020).
uint hash(uint x) {
    uint state = x * 747796405u + 2891336453u;
    uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (word >> 22u) ^ word;
}

uint hash_combine(uint a, uint b) {
    return hash(a ^ hash(b));
}

/// Owen scrambling of the bits of x, most significant first (Laine and Karras 2011).
uint owen_scramble(uint x, uint seed) {
    x = bitfieldReverse(x);
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16) | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return bitfieldReverse(x);
}

/// Point `index` of the two-dimensional Sobol sequence. The second matrix is Pascal's triangle modulo 2, which factors
/// into five shifts.
uvec2 sobol_2d(uint index) {
    uint y = index;
    y ^= (y & 0xaaaaaaaau) >> 1;
    y ^= (y & 0xccccccccu) >> 2;
    y ^= (y & 0xf0f0f0f0u) >> 4;
    y ^= (y & 0xff00ff00u) >> 8;
    y ^= (y & 0xffff0000u) >> 16;
    return uvec2(bitfieldReverse(index), bitfieldReverse(y));
}

/// Upper 24 bits as a float in [0, 1): never 1, unlike a conversion of all 32.
float to_unit_interval(uint bits) {
    return float(bits >> 8) * 5.9604644775390625e-8;
}

/// What distinguishes the sample sequences of pixels, seeds and estimates.
uint sampler_key(uvec2 pixel, uint seed, uint estimate) {
    return hash_combine(hash_combine(hash_combine(pixel.x, pixel.y), seed), estimate);
}

/// Two numbers in [0, 1) for sample `index` in a pair of dimensions.
vec2 sample_2d(uint key, uint index, uint dimension_pair) {
    uint seed = hash_combine(key, dimension_pair);
    uvec2 point = sobol_2d(owen_scramble(index, seed));
    return vec2(to_unit_interval(owen_scramble(point.x, hash(seed ^ 0x9e3779b9u))),
                to_unit_interval(owen_scramble(point.y, hash(seed ^ 0x7f4a7c15u))));
}

#endif
