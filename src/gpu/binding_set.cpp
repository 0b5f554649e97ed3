// SPDX-License-Identifier: Apache-2.0
#include "gpu/binding_set.h"

#include "base/check.h"
#include "base/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace utsuri {
namespace {

/// Every device can read it from buffers. Kernels make of the words what they hold.
constexpr vk::Format kTexelFormat = vk::Format::eR32G32B32A32Uint;

const Buffer& buffer_for(const SpirvBinding& binding, const std::string& pipeline, const Bindings& buffers) {
    const auto found = buffers.find(binding.number);
    if (found == buffers.end()) {
        fail_check(__FILE__, __LINE__,
                   fmt::format("{} has no buffer for binding {}", pipeline, binding.number));
    }
    return *found->second;
}

void check_size(const Device& device, const std::string& pipeline, const Buffer& buffer, BindingKind kind) {
    const std::uint64_t most = most_bytes(device.summary(), kind);
    if (buffer.size() <= most) return;
    throw DeviceError("bind buffers of", pipeline,
                      fmt::format("'{}' has {} bytes; a kernel on this device can see at most {} bytes "
                                  "of it; use a smaller scene, or another device",
                                  buffer.name(), buffer.size(), most));
}

vk::raii::BufferView create_view(const Device& device, const Buffer& buffer) {
    UTSURI_CHECK_EQ(buffer.size() % kTexelBytes, 0u);
    return device.handle().createBufferView({{}, buffer.handle(), kTexelFormat, 0, buffer.size()});
}

vk::raii::DescriptorPool create_pool(const Device& device, std::uint32_t descriptors) {
    std::vector<vk::DescriptorPoolSize> sizes;
    for (const BindingKind kind : {BindingKind::storage, BindingKind::uniform_block, BindingKind::texels})
        sizes.emplace_back(descriptor_type(kind), std::max(descriptors, 1u));
    return device.handle().createDescriptorPool(
        {vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, kDescriptorSets, sizes});
}

}  // namespace

BindingSet::BindingSet(const Device& device, const std::string& pipeline,
                       std::span<const SpirvBinding> declared,
                       std::span<const vk::DescriptorSetLayout> layouts, const Bindings& buffers)
    : pool_(create_pool(device, static_cast<std::uint32_t>(declared.size()))),
      sets_(device.handle().allocateDescriptorSets({*pool_, layouts})) {
    // Writes refer to what lies in these: they must not grow beyond what is reserved.
    std::vector<vk::DescriptorBufferInfo> infos;
    std::vector<vk::BufferView> texels;
    infos.reserve(declared.size());
    texels.reserve(declared.size());
    std::vector<vk::WriteDescriptorSet> writes;
    for (const SpirvBinding& binding : declared) {
        const Buffer& buffer = buffer_for(binding, pipeline, buffers);
        check_size(device, pipeline, buffer, binding.kind);
        vk::WriteDescriptorSet write(*sets_[binding.set], binding.number, 0, 1,
                                     descriptor_type(binding.kind));
        if (binding.kind == BindingKind::texels) {
            views_.push_back(create_view(device, buffer));
            texels.push_back(*views_.back());
            write.pTexelBufferView = &texels.back();
        } else {
            infos.emplace_back(buffer.handle(), 0, VK_WHOLE_SIZE);
            write.pBufferInfo = &infos.back();
        }
        writes.push_back(write);
    }
    device.handle().updateDescriptorSets(writes, {});
}

std::vector<vk::DescriptorSet> BindingSet::handles() const {
    std::vector<vk::DescriptorSet> handles;
    for (const vk::raii::DescriptorSet& set : sets_)
        handles.push_back(*set);
    return handles;
}

BindingSet::BindingSet(BindingSet&& other) noexcept = default;
BindingSet& BindingSet::operator=(BindingSet&& other) noexcept = default;
BindingSet::~BindingSet() = default;

}  // namespace utsuri
