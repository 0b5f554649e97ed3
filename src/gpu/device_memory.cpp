// SPDX-License-Identifier: Apache-2.0
#include "gpu/device_memory.h"

#include "base/error.h"

#include <utility>

namespace utsuri {
namespace {

std::uint32_t choose_type(const Device& device, std::uint32_t type_bits,
                          std::initializer_list<vk::MemoryPropertyFlags> preferences) {
    for (const vk::MemoryPropertyFlags wanted : preferences) {
        if (const auto type = device.memory_type(type_bits, wanted)) return *type;
    }
    throw DeviceError("allocate memory", device.summary().name, "no memory type fits");
}

bool is_mappable(vk::MemoryPropertyFlags flags) {
    using Memory = vk::MemoryPropertyFlagBits;
    const vk::MemoryPropertyFlags mappable = Memory::eHostVisible | Memory::eHostCoherent;
    return (flags & mappable) == mappable;
}

}  // namespace

DeviceMemory::DeviceMemory(Device& device, const vk::MemoryRequirements& needs,
                           std::initializer_list<vk::MemoryPropertyFlags> preferences)
    : device_(&device), bytes_(needs.size), memory_(nullptr) {
    const std::uint32_t type = choose_type(device, needs.memoryTypeBits, preferences);
    memory_ = device.handle().allocateMemory({needs.size, type});
    host_visible_ = is_mappable(device.memory_type_flags(type));
    device.note_memory(static_cast<std::int64_t>(bytes_));
}

DeviceMemory::DeviceMemory(DeviceMemory&& other) noexcept
    : device_(other.device_),
      bytes_(std::exchange(other.bytes_, 0)),
      host_visible_(other.host_visible_),
      memory_(std::move(other.memory_)) {}

DeviceMemory& DeviceMemory::operator=(DeviceMemory&& other) noexcept {
    if (this != &other) {
        release();
        device_ = other.device_;
        bytes_ = std::exchange(other.bytes_, 0);
        host_visible_ = other.host_visible_;
        memory_ = std::move(other.memory_);
    }
    return *this;
}

DeviceMemory::~DeviceMemory() {
    release();
}

void DeviceMemory::release() noexcept {
    if (bytes_ != 0) device_->note_memory(-static_cast<std::int64_t>(std::exchange(bytes_, 0)));
    memory_.clear();
}

}  // namespace utsuri
