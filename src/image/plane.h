// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace utsuri {

/// One scalar a pixel, row-major, top row first: the map of a metric.
struct Plane {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<float> values;  ///< width * height values

    Plane() = default;
    Plane(std::uint32_t w, std::uint32_t h, float value = 0.0f)
        : width(w), height(h), values(static_cast<std::size_t>(w) * h, value) {}

    [[nodiscard]] float& at(std::uint32_t x, std::uint32_t y) {
        return values[static_cast<std::size_t>(y) * width + x];
    }
    [[nodiscard]] const float& at(std::uint32_t x, std::uint32_t y) const {
        return values[static_cast<std::size_t>(y) * width + x];
    }
};

/// The mean in double; not-a-number for an empty map.
[[nodiscard]] inline double mean(const Plane& map) {
    double sum = 0.0;
    for (const float value : map.values)
        sum += static_cast<double>(value);
    return sum / static_cast<double>(map.values.size());
}

}  // namespace utsuri
