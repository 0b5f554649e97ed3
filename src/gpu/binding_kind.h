// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/device_selection.h"

#include <cstdint>

namespace utsuri {

/// How kernels read a buffer.
enum class BindingKind { storage, uniform_block, texels };

/// What is read as texels comes four words at a time, and buffers of it are whole texels: CPUs gather them
/// for all lanes of a subgroup at once, where they load other buffers word by word.
inline constexpr std::uint64_t kTexelBytes = 16;

/// What descriptors of a kind of binding are.
vk::DescriptorType descriptor_type(BindingKind kind);

/// Bytes of the largest buffer that kernels of a device can read so; a uniform block counts as storage, since
/// kernels declare its size.
std::uint64_t most_bytes(const DeviceSummary& device, BindingKind kind);

}  // namespace utsuri
