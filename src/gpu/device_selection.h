// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/vulkan_instance.h"

#include <string>
#include <string_view>
#include <vector>

namespace utsuri {

/// What a physical device is and whether it can run the kernels.
struct DeviceSummary {
    std::size_t index = 0;  ///< position in the loader's list; what --device takes
    std::string name;
    std::string kind;                ///< "discrete GPU", "integrated GPU", "virtual GPU", "CPU" or "other"
    std::string driver;              ///< name and version as the driver tells them
    std::string api;                 ///< highest Vulkan version, for example "1.3.230"
    std::uint64_t memory_bytes = 0;  ///< of the largest device-local heap
    std::uint64_t storage_range_bytes = 0;  ///< largest buffer a kernel can see
    std::uint64_t texel_elements = 0;       ///< most texels of a buffer that a kernel can read as such
    std::uint32_t subgroup_size = 0;
    bool draws = false;  ///< can rasterise triangles, and write to buffers then: some compute cards cannot
    std::uint32_t image_size = 0;      ///< longest side of a picture that can be drawn into
    std::vector<std::string> missing;  ///< what the kernels need and this device lacks, by name

    [[nodiscard]] bool usable() const { return missing.empty(); }
};

/// All devices, in the loader's order; none without a driver.
/// @throws DeviceError if they cannot be listed
std::vector<DeviceSummary> list_devices(const VulkanInstance& instance);

/// The device to use.
/// @param wanted an index, or a part of a name without regard to case; empty takes the usable device of the
/// fastest
///               kind (discrete, integrated, virtual, CPU), the first of its kind
/// @throws DeviceError if there is none, it is not usable, or `wanted` fits none or several; the text lists
/// devices
DeviceSummary choose_device(const VulkanInstance& instance, std::string_view wanted);

}  // namespace utsuri
