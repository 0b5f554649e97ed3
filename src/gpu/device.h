// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/device_selection.h"
#include "gpu/vulkan_instance.h"

#include <vulkan/vulkan_raii.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace utsuri {

class PipelineCache;

/// Queue family with compute and timestamps; one with graphics, too, if there is one.
std::optional<std::uint32_t> find_queue_family(const std::vector<vk::QueueFamilyProperties>& families);

/// Bytes of device memory held by buffers and attachments.
struct MemoryUsage {
    std::uint64_t current = 0;
    std::uint64_t peak = 0;
};

/// A logical device with one queue, which computes and, if it can, draws. Work is submitted and waited for,
/// so nothing is ever in flight when a call returns. Not copyable or movable: every buffer and kernel refers
/// to it. One thread at a time.
///
/// Like all classes that hold Vulkan objects it is destroyed and moved in its own source file: code that
/// vulkan_raii.hpp inlines differs with NDEBUG, and a debug build may use a release build of this library.
class Device {
  public:
    /// @param wanted see choose_device()
    /// @throws DeviceError
    Device(const VulkanInstance& instance, std::string_view wanted);
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;
    ~Device();

    [[nodiscard]] const vk::raii::Device& handle() const { return *device_; }
    [[nodiscard]] const DeviceSummary& summary() const { return summary_; }

    /// Records commands, submits them, waits for them.
    /// @param operation what the work is, for messages
    /// @return seconds between the device's timestamps before and after the commands
    double run(std::string_view operation, const std::function<void(const vk::raii::CommandBuffer&)>& record);

    /// Index of a memory type that `type_bits` allows and that has all `required` properties.
    [[nodiscard]] std::optional<std::uint32_t> memory_type(std::uint32_t type_bits,
                                                           vk::MemoryPropertyFlags required) const;
    [[nodiscard]] vk::MemoryPropertyFlags memory_type_flags(std::uint32_t type) const;

    [[nodiscard]] MemoryUsage memory() const { return memory_; }
    /// Starts a new measurement: the peak becomes what is held now.
    void reset_peak_memory() { memory_.peak = memory_.current; }
    /// Called by DeviceMemory as it is taken and released.
    void note_memory(std::int64_t bytes);

    /// Bytes that Buffer::upload() copied since the device was opened: what it costs to follow a scene.
    [[nodiscard]] std::uint64_t uploaded_bytes() const { return uploaded_bytes_; }
    /// Called by buffers.
    void note_upload(std::uint64_t bytes) { uploaded_bytes_ += bytes; }

    [[nodiscard]] PipelineCache& pipelines() { return *pipelines_; }

    /// Gives an object a name that validation messages and graphics debuggers show.
    void set_name(vk::ObjectType type, std::uint64_t handle, const std::string& name) const;

  private:
    DeviceSummary summary_;
    std::optional<vk::raii::PhysicalDevice> physical_;
    vk::PhysicalDeviceMemoryProperties memory_properties_;
    bool debug_names_ = false;
    double timestamp_seconds_ = 0.0;    ///< of one tick
    std::uint64_t timestamp_mask_ = 0;  ///< valid bits
    std::optional<vk::raii::Device> device_;
    std::optional<vk::raii::Queue> queue_;
    std::optional<vk::raii::CommandPool> pool_;
    std::optional<vk::raii::QueryPool> timestamps_;
    std::optional<vk::raii::Fence> fence_;
    MemoryUsage memory_;
    std::uint64_t uploaded_bytes_ = 0;
    std::unique_ptr<PipelineCache> pipelines_;
};

}  // namespace utsuri
