// SPDX-License-Identifier: Apache-2.0
#include "gpu/vulkan_instance.h"

#include "base/error.h"
#include "gpu/vulkan_call.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace utsuri {
namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

VKAPI_ATTR VkBool32 VKAPI_CALL on_message(VkDebugUtilsMessageSeverityFlagBitsEXT,
                                          VkDebugUtilsMessageTypeFlagsEXT,
                                          const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
    static_cast<ValidationMessages*>(user)->add(data->pMessage != nullptr ? data->pMessage : "(no text)");
    return VK_FALSE;
}

vk::DebugUtilsMessengerCreateInfoEXT messenger_info(ValidationMessages* messages) {
    // The C struct, because headers differ in what type the C++ one gives the callback.
    VkDebugUtilsMessengerCreateInfoEXT info{};
    info.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT;
    info.messageSeverity =
        VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    info.messageType =
        VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
    info.pfnUserCallback = on_message;
    info.pUserData = messages;
    return vk::DebugUtilsMessengerCreateInfoEXT(info);
}

bool has_extension(const std::vector<vk::ExtensionProperties>& available, const char* name) {
    return std::any_of(available.begin(), available.end(), [&](const vk::ExtensionProperties& properties) {
        return std::strcmp(properties.extensionName, name) == 0;
    });
}

constexpr std::string_view kConnect = "connect to Vulkan";

/// Finds the Vulkan loader, a library that machines without drivers may lack.
vk::raii::Context open_loader() {
    try {
        return {};
    } catch (const std::runtime_error& error) {
        throw DeviceError(kConnect, "",
                          fmt::format("the Vulkan loader cannot be loaded ({}); install it (Debian package "
                                      "libvulkan1) with a driver for your device",
                                      error.what()));
    }
}

/// Failures that a user can mend say how.
vk::raii::Instance create_instance(const vk::raii::Context& context, const vk::InstanceCreateInfo& info) {
    try {
        return {context, info};
    } catch (const vk::IncompatibleDriverError&) {
        throw DeviceError(kConnect, "", kNoDriver);
    } catch (const vk::LayerNotPresentError&) {
        throw DeviceError(
            kConnect, kValidationLayer,
            "the layer is not installed; install it (Debian package vulkan-validationlayers) or turn "
            "validation off");
    }
}

}  // namespace

void ValidationMessages::add(std::string message) {
    const std::lock_guard lock(mutex_);
    messages_.push_back(std::move(message));
}

std::vector<std::string> ValidationMessages::take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(messages_, {});
}

VulkanInstance::VulkanInstance(Validation validation) : context_(open_loader()) {
    vulkan_call(kConnect, "", [&] { connect(validation); });
}

void VulkanInstance::connect(Validation validation) {
    const auto extensions = context_.enumerateInstanceExtensionProperties();
    std::vector<const char*> enabled;
    vk::InstanceCreateFlags flags;
    debug_utils_ = has_extension(extensions, VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    if (debug_utils_) enabled.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    if (validation == Validation::on && !debug_utils_) {
        throw DeviceError(kConnect, VK_EXT_DEBUG_UTILS_EXTENSION_NAME,
                          "the Vulkan loader lacks it, and nobody would hear the validation layer; install a "
                          "newer loader (Debian package libvulkan1) or turn validation off");
    }
    // Drivers that map Vulkan onto another API (MoltenVK) are only listed to those who ask for them.
    if (has_extension(extensions, VK_KHR_PORTABILITY_ENUMERATION_EXTENSION_NAME)) {
        enabled.push_back(VK_KHR_PORTABILITY_ENUMERATION_EXTENSION_NAME);
        flags |= vk::InstanceCreateFlagBits::eEnumeratePortabilityKHR;
    }
    std::vector<const char*> layers;
    if (validation == Validation::on) layers.push_back(kValidationLayer);

    const vk::ApplicationInfo application("utsuri", 1, "utsuri", 1, VK_API_VERSION_1_3);
    const vk::InstanceCreateInfo info(flags, &application, layers, enabled);
    const vk::ValidationFeatureEnableEXT synchronization =
        vk::ValidationFeatureEnableEXT::eSynchronizationValidation;
    vk::StructureChain<vk::InstanceCreateInfo, vk::DebugUtilsMessengerCreateInfoEXT,
                       vk::ValidationFeaturesEXT>
        chain(info, messenger_info(messages_.get()), vk::ValidationFeaturesEXT(synchronization));
    if (validation == Validation::off) {
        chain.unlink<vk::DebugUtilsMessengerCreateInfoEXT>();
        chain.unlink<vk::ValidationFeaturesEXT>();
    }
    instance_ = create_instance(context_, chain.get<vk::InstanceCreateInfo>());
    if (validation == Validation::on) {
        messenger_.emplace(*instance_, messenger_info(messages_.get()));
    }
}

VulkanInstance::~VulkanInstance() = default;

}  // namespace utsuri
