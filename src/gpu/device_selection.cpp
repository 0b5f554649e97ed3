// SPDX-License-Identifier: Apache-2.0
#include "gpu/device_selection.h"

#include "base/error.h"
#include "gpu/device.h"
#include "gpu/vulkan_call.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>

namespace utsuri {
namespace {

std::string kind_name(vk::PhysicalDeviceType type) {
    switch (type) {
        case vk::PhysicalDeviceType::eDiscreteGpu:
            return "discrete GPU";
        case vk::PhysicalDeviceType::eIntegratedGpu:
            return "integrated GPU";
        case vk::PhysicalDeviceType::eVirtualGpu:
            return "virtual GPU";
        case vk::PhysicalDeviceType::eCpu:
            return "CPU";
        default:
            return "other";
    }
}

int speed_rank(const DeviceSummary& device) {
    const std::vector<std::string> fastest_first = {"discrete GPU", "integrated GPU", "virtual GPU", "CPU",
                                                    "other"};
    return static_cast<int>(std::find(fastest_first.begin(), fastest_first.end(), device.kind) -
                            fastest_first.begin());
}

std::string lower_case(std::string_view text) {
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

std::vector<std::string> missing_features(const vk::raii::PhysicalDevice& device, std::uint32_t api) {
    std::vector<std::string> missing;
    if (api < VK_API_VERSION_1_3) {
        missing.push_back("Vulkan 1.3");
        return missing;
    }
    const auto features = device.getFeatures2<vk::PhysicalDeviceFeatures2, vk::PhysicalDeviceVulkan12Features,
                                              vk::PhysicalDeviceVulkan13Features>();
    const auto& v12 = features.get<vk::PhysicalDeviceVulkan12Features>();
    const auto& v13 = features.get<vk::PhysicalDeviceVulkan13Features>();
    if (v12.scalarBlockLayout == VK_FALSE) missing.push_back("scalarBlockLayout");
    if (v13.dynamicRendering == VK_FALSE) missing.push_back("dynamicRendering");
    if (v13.synchronization2 == VK_FALSE) missing.push_back("synchronization2");
    const auto families = device.getQueueFamilyProperties();
    if (!find_queue_family(families)) missing.push_back("a queue with compute and timestamps");
    return missing;
}

DeviceSummary summarise(const vk::raii::PhysicalDevice& device, std::size_t index) {
    const auto properties =
        device.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceDriverProperties,
                              vk::PhysicalDeviceSubgroupProperties>();
    const auto& base = properties.get<vk::PhysicalDeviceProperties2>().properties;
    const auto& driver = properties.get<vk::PhysicalDeviceDriverProperties>();
    DeviceSummary summary;
    summary.index = index;
    summary.name = base.deviceName.data();
    summary.kind = kind_name(base.deviceType);
    summary.driver = fmt::format("{} {}", driver.driverName.data(), driver.driverInfo.data());
    summary.api = fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(base.apiVersion),
                              VK_API_VERSION_MINOR(base.apiVersion), VK_API_VERSION_PATCH(base.apiVersion));
    summary.storage_range_bytes = base.limits.maxStorageBufferRange;
    summary.texel_elements = base.limits.maxTexelBufferElements;
    summary.subgroup_size = properties.get<vk::PhysicalDeviceSubgroupProperties>().subgroupSize;
    summary.image_size = std::min({base.limits.maxImageDimension2D, base.limits.maxFramebufferWidth,
                                   base.limits.maxFramebufferHeight, base.limits.maxViewportDimensions[0]});
    const auto memory = device.getMemoryProperties();
    for (std::uint32_t i = 0; i < memory.memoryHeapCount; ++i) {
        if (memory.memoryHeaps[i].flags & vk::MemoryHeapFlagBits::eDeviceLocal) {
            summary.memory_bytes = std::max(summary.memory_bytes, std::uint64_t{memory.memoryHeaps[i].size});
        }
    }
    const auto families = device.getQueueFamilyProperties();
    const auto family = find_queue_family(families);
    summary.draws = family && (families[*family].queueFlags & vk::QueueFlagBits::eGraphics) &&
                    device.getFeatures().fragmentStoresAndAtomics;
    summary.missing = missing_features(device, base.apiVersion);
    return summary;
}

std::string describe(const std::vector<DeviceSummary>& devices) {
    std::string text;
    for (const DeviceSummary& device : devices) {
        text +=
            fmt::format("\n  {}: {} ({}){}", device.index, device.name, device.kind,
                        device.usable() ? "" : fmt::format(", lacks {}", fmt::join(device.missing, ", ")));
    }
    return text;
}

std::vector<DeviceSummary> matching(const std::vector<DeviceSummary>& devices, std::string_view wanted) {
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), index);
    const bool is_index = error == std::errc() && end == wanted.data() + wanted.size();
    std::vector<DeviceSummary> result;
    std::copy_if(devices.begin(), devices.end(), std::back_inserter(result),
                 [&](const DeviceSummary& device) {
                     return is_index ? device.index == index
                                     : lower_case(device.name).find(lower_case(wanted)) != std::string::npos;
                 });
    return result;
}

/// None without a driver, which the loader reports as a failed initialization.
std::optional<vk::raii::PhysicalDevices> physical_devices(const vk::raii::Instance& instance) {
    try {
        return std::make_optional<vk::raii::PhysicalDevices>(instance);
    } catch (const vk::InitializationFailedError&) {
        return std::nullopt;
    }
}

}  // namespace

std::vector<DeviceSummary> list_devices(const VulkanInstance& instance) {
    return vulkan_call("list Vulkan devices", "", [&] {
        std::vector<DeviceSummary> result;
        const std::optional<vk::raii::PhysicalDevices> devices = physical_devices(instance.handle());
        for (std::size_t i = 0; devices && i < devices->size(); ++i)
            result.push_back(summarise((*devices)[i], i));
        return result;
    });
}

DeviceSummary choose_device(const VulkanInstance& instance, std::string_view wanted) {
    const std::vector<DeviceSummary> devices = list_devices(instance);
    if (devices.empty()) {
        throw DeviceError("choose a Vulkan device", "", kNoDriver);
    }
    if (!wanted.empty()) {
        const std::vector<DeviceSummary> found = matching(devices, wanted);
        if (found.size() != 1) {
            throw DeviceError("choose Vulkan device", fmt::format("'{}'", wanted),
                              fmt::format("{} devices fit; give an index or a part of one name:{}",
                                          found.size(), describe(devices)));
        }
        if (!found.front().usable()) {
            throw DeviceError("use Vulkan device", fmt::format("'{}'", found.front().name),
                              fmt::format("it lacks {}", fmt::join(found.front().missing, ", ")));
        }
        return found.front();
    }
    std::optional<DeviceSummary> best;
    for (const DeviceSummary& device : devices) {
        if (device.usable() && (!best || speed_rank(device) < speed_rank(*best))) best = device;
    }
    if (!best) {
        throw DeviceError("choose a Vulkan device", "",
                          fmt::format("none of the devices can run the kernels:{}", describe(devices)));
    }
    return *best;
}

}  // namespace utsuri
