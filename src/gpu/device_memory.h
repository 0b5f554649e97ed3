// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/device.h"

#include <initializer_list>

namespace utsuri {

/// Memory of a device, counted by it for as long as it is held. Move-only.
class DeviceMemory {
  public:
    /// @param preferences kinds of memory; the first that the device has is taken
    /// @throws DeviceError if there is none of them; vk::SystemError if it is used up
    DeviceMemory(Device& device, const vk::MemoryRequirements& needs,
                 std::initializer_list<vk::MemoryPropertyFlags> preferences);
    DeviceMemory(DeviceMemory&& other) noexcept;
    DeviceMemory& operator=(DeviceMemory&& other) noexcept;
    DeviceMemory(const DeviceMemory&) = delete;
    DeviceMemory& operator=(const DeviceMemory&) = delete;
    ~DeviceMemory();

    [[nodiscard]] const vk::raii::DeviceMemory& handle() const { return memory_; }
    /// Whether the host can map it without flushing.
    [[nodiscard]] bool host_visible() const { return host_visible_; }

  private:
    void release() noexcept;

    Device* device_;
    std::uint64_t bytes_ = 0;
    bool host_visible_ = false;
    vk::raii::DeviceMemory memory_;
};

}  // namespace utsuri
