// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/scene_data.h"

#include "gpu/binding_kind.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace utsuri {

/// One of the buffers that a scene has on the device.
struct SceneBuffer {
    const char* name;       ///< for messages
    std::uint32_t binding;  ///< where kernels find it
    BindingKind kind;       ///< how they read it
    std::size_t record_bytes;
    std::span<const std::byte> bytes;  ///< what it holds; none where the scene does not require it
};

/// All of them, in one order.
inline constexpr std::size_t kSceneBuffers = 9;
std::array<SceneBuffer, kSceneBuffers> scene_buffers(const SceneData& data);

}  // namespace utsuri
