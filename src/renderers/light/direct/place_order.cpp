// SPDX-License-Identifier: Apache-2.0
#include "renderers/light/direct/place_order.h"

#include <algorithm>
#include <numeric>

namespace utsuri {
namespace {

constexpr std::uint32_t kCoordinateBits = 16;

/// A bit of zero after each bit.
std::uint64_t spread(std::uint64_t bits) {
    bits = (bits | bits << 8) & 0x00ff00ffu;
    bits = (bits | bits << 4) & 0x0f0f0f0fu;
    bits = (bits | bits << 2) & 0x33333333u;
    return (bits | bits << 1) & 0x55555555u;
}

std::uint64_t coordinate_bits(float b) {
    constexpr auto kMost = static_cast<float>((1u << kCoordinateBits) - 1u);
    return static_cast<std::uint64_t>(std::clamp(b, 0.0f, 1.0f) * kMost);
}

std::uint64_t key_of(const interop::LightMeshPlace& place) {
    return std::uint64_t{place.triangle} << (2 * kCoordinateBits) | spread(coordinate_bits(place.b1)) |
           spread(coordinate_bits(place.b2)) << 1;
}

}  // namespace

std::vector<std::uint32_t> order_by_place(std::span<const interop::LightMeshPlace> places) {
    std::vector<std::uint64_t> keys(places.size());
    std::ranges::transform(places, keys.begin(), key_of);
    std::vector<std::uint32_t> order(places.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::stable_sort(order, {}, [&](std::uint32_t place) { return keys[place]; });
    return order;
}

}  // namespace utsuri
