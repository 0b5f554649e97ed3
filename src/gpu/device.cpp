// SPDX-License-Identifier: Apache-2.0
#include "gpu/device.h"

#include "gpu/pipeline_cache.h"
#include "gpu/vulkan_call.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace utsuri {
namespace {

/// Extensions a device insists on: one that maps Vulkan onto another API must be told that this is known.
std::vector<const char*> required_extensions(const vk::raii::PhysicalDevice& physical) {
    constexpr const char* kPortabilitySubset = "VK_KHR_portability_subset";
    for (const auto& extension : physical.enumerateDeviceExtensionProperties()) {
        if (std::strcmp(extension.extensionName, kPortabilitySubset) == 0) return {kPortabilitySubset};
    }
    return {};
}

vk::raii::Device create_device(const vk::raii::PhysicalDevice& physical, std::uint32_t family) {
    const float priority = 1.0f;
    const vk::DeviceQueueCreateInfo queue({}, family, 1, &priority);
    const std::vector<const char*> extensions = required_extensions(physical);
    vk::PhysicalDeviceVulkan12Features v12;
    v12.scalarBlockLayout = VK_TRUE;
    vk::PhysicalDeviceVulkan13Features v13;
    v13.synchronization2 = VK_TRUE;
    v13.dynamicRendering = VK_TRUE;
    // Every Vulkan 1.3 device has it; the kernels' workgroup sizes, which are specialization constants, need
    // it.
    v13.maintenance4 = VK_TRUE;
    vk::PhysicalDeviceFeatures2 features;
    features.features.fragmentStoresAndAtomics = physical.getFeatures().fragmentStoresAndAtomics;
    const vk::StructureChain chain(vk::DeviceCreateInfo({}, queue, {}, extensions), features, v12, v13);
    return {physical, chain.get<vk::DeviceCreateInfo>()};
}

/// Makes what the commands before it write visible to the host. Waiting for a fence does not, even where
/// memory is coherent: a fence only orders accesses of the device (Vulkan 1.3, chapter "Fences").
void make_visible_to_host(const vk::raii::CommandBuffer& commands) {
    const vk::MemoryBarrier2 to_host(vk::PipelineStageFlagBits2::eAllCommands,
                                     vk::AccessFlagBits2::eMemoryWrite, vk::PipelineStageFlagBits2::eHost,
                                     vk::AccessFlagBits2::eHostRead);
    commands.pipelineBarrier2(vk::DependencyInfo({}, to_host));
}

}  // namespace

std::optional<std::uint32_t> find_queue_family(const std::vector<vk::QueueFamilyProperties>& families) {
    using Flag = vk::QueueFlagBits;
    std::optional<std::uint32_t> found;
    for (std::uint32_t i = 0; i < families.size(); ++i) {
        if (!(families[i].queueFlags & Flag::eCompute) || families[i].timestampValidBits == 0) continue;
        if (families[i].queueFlags & Flag::eGraphics) return i;
        if (!found) found = i;
    }
    return found;
}

Device::Device(const VulkanInstance& instance, std::string_view wanted)
    : summary_(choose_device(instance, wanted)),
      debug_names_(instance.has_debug_names()),
      pipelines_(std::make_unique<PipelineCache>()) {
    vulkan_call("open Vulkan device", summary_.name, [&] {
        vk::raii::PhysicalDevices devices(instance.handle());
        physical_ = std::move(devices[summary_.index]);
        memory_properties_ = physical_->getMemoryProperties();
        const auto families = physical_->getQueueFamilyProperties();
        const std::uint32_t family = find_queue_family(families).value();
        const std::uint32_t bits = families[family].timestampValidBits;
        timestamp_mask_ = bits >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
        timestamp_seconds_ = static_cast<double>(physical_->getProperties().limits.timestampPeriod) * 1e-9;
        device_ = create_device(*physical_, family);
        queue_ = device_->getQueue(family, 0);
        pool_ = device_->createCommandPool({vk::CommandPoolCreateFlagBits::eTransient, family});
        timestamps_ = device_->createQueryPool({{}, vk::QueryType::eTimestamp, 2});
        fence_ = device_->createFence({});
    });
}

Device::~Device() = default;

double Device::run(std::string_view operation,
                   const std::function<void(const vk::raii::CommandBuffer&)>& record) {
    return vulkan_call(operation, summary_.name, [&] {
        vk::raii::CommandBuffers buffers(*device_, {**pool_, vk::CommandBufferLevel::ePrimary, 1});
        const vk::raii::CommandBuffer& commands = buffers.front();
        commands.begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
        commands.resetQueryPool(**timestamps_, 0, 2);
        commands.writeTimestamp2(vk::PipelineStageFlagBits2::eAllCommands, **timestamps_, 0);
        record(commands);
        commands.writeTimestamp2(vk::PipelineStageFlagBits2::eAllCommands, **timestamps_, 1);
        make_visible_to_host(commands);
        commands.end();
        const vk::CommandBufferSubmitInfo buffer_info(*commands);
        queue_->submit2(vk::SubmitInfo2({}, {}, buffer_info), **fence_);
        while (device_->waitForFences(**fence_, VK_TRUE, std::numeric_limits<std::uint64_t>::max()) ==
               vk::Result::eTimeout) {
        }
        device_->resetFences(**fence_);
        const auto [result, ticks] = timestamps_->getResults<std::uint64_t>(
            0, 2, 2 * sizeof(std::uint64_t), sizeof(std::uint64_t),
            vk::QueryResultFlagBits::e64 | vk::QueryResultFlagBits::eWait);
        return static_cast<double>((ticks[1] - ticks[0]) & timestamp_mask_) * timestamp_seconds_;
    });
}

std::optional<std::uint32_t> Device::memory_type(std::uint32_t type_bits,
                                                 vk::MemoryPropertyFlags required) const {
    for (std::uint32_t i = 0; i < memory_properties_.memoryTypeCount; ++i) {
        if ((type_bits >> i & 1u) != 0 &&
            (memory_properties_.memoryTypes[i].propertyFlags & required) == required) {
            return i;
        }
    }
    return std::nullopt;
}

vk::MemoryPropertyFlags Device::memory_type_flags(std::uint32_t type) const {
    return memory_properties_.memoryTypes[type].propertyFlags;
}

void Device::note_memory(std::int64_t bytes) {
    memory_.current = static_cast<std::uint64_t>(static_cast<std::int64_t>(memory_.current) + bytes);
    memory_.peak = std::max(memory_.peak, memory_.current);
}

void Device::set_name(vk::ObjectType type, std::uint64_t handle, const std::string& name) const {
    if (debug_names_) device_->setDebugUtilsObjectNameEXT({type, handle, name.c_str()});
}

}  // namespace utsuri
