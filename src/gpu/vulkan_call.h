// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/error.h"

#include <vulkan/vulkan_raii.hpp>

#include <string_view>
#include <utility>

namespace utsuri {

/// Problem and remedy of a machine without drivers, which some loaders report as a failure to connect and
/// others as an empty list of devices.
inline constexpr std::string_view kNoDriver =
    "no Vulkan driver is installed; install your GPU's driver, or Mesa's software driver (Debian package "
    "mesa-vulkan-drivers)";

/// Runs a function of Vulkan calls; a failing one becomes a DeviceError that names operation, object and
/// result.
template <typename Function>
auto vulkan_call(std::string_view operation, std::string_view object, Function&& function) {
    try {
        return std::forward<Function>(function)();
    } catch (const vk::SystemError& error) {
        throw DeviceError(operation, object, error.what());
    }
}

}  // namespace utsuri
