// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/scene_data.h"

#include "gpu/device.h"

#include "probe_interop.h"

#include <span>
#include <vector>

namespace utsuri::test {

/// Independent pairs of numbers in [0, 1), the same for the same seed.
std::vector<glm::vec2> random_pairs(std::size_t count, std::uint32_t seed);

/// Calls a sampling function of the device once for every input.
std::vector<interop::ProbeOutput> probe(Device& device, const SceneData& data, std::uint32_t sampler,
                                        interop::ProbePush push, std::span<const glm::vec2> inputs);

}  // namespace utsuri::test
