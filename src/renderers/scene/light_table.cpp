// SPDX-License-Identifier: Apache-2.0
#include "renderers/scene/light_table.h"

#include "base/check.h"

#include <cstdint>
#include <numeric>
#include <vector>

namespace utsuri {

void make_light_table(std::span<const double> weights, std::span<interop::LightInfo> lights) {
    UTSURI_CHECK_EQ(weights.size(), lights.size());
    const std::size_t count = weights.size();
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    std::vector<double> scaled(count);
    std::vector<std::uint32_t> small;
    std::vector<std::uint32_t> large;
    for (std::uint32_t i = 0; i < count; ++i) {
        UTSURI_CHECK_LT(0.0, sum);
        lights[i].probability = static_cast<float>(weights[i] / sum);
        scaled[i] = weights[i] / sum * static_cast<double>(count);
        (scaled[i] < 1.0 ? small : large).push_back(i);
    }
    while (!small.empty() && !large.empty()) {
        const std::uint32_t poor = small.back();
        const std::uint32_t rich = large.back();
        small.pop_back();
        lights[poor].threshold = static_cast<float>(scaled[poor]);
        lights[poor].alias = rich;
        scaled[rich] -= 1.0 - scaled[poor];
        if (scaled[rich] < 1.0) {
            large.pop_back();
            small.push_back(rich);
        }
    }
    // What is left on either side is full up to rounding.
    for (const auto* rest : {&small, &large}) {
        for (const std::uint32_t i : *rest) {
            lights[i].threshold = 1.0f;
            lights[i].alias = i;
        }
    }
}

}  // namespace utsuri
