// SPDX-License-Identifier: Apache-2.0
#include "gpu/binding_kind.h"

namespace utsuri {

vk::DescriptorType descriptor_type(BindingKind kind) {
    switch (kind) {
        case BindingKind::uniform_block:
            return vk::DescriptorType::eUniformBuffer;
        case BindingKind::texels:
            return vk::DescriptorType::eUniformTexelBuffer;
        case BindingKind::storage:
            break;
    }
    return vk::DescriptorType::eStorageBuffer;
}

std::uint64_t most_bytes(const DeviceSummary& device, BindingKind kind) {
    return kind == BindingKind::texels ? kTexelBytes * device.texel_elements : device.storage_range_bytes;
}

}  // namespace utsuri
