// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vulkan/vulkan_raii.hpp>

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace utsuri {

/// How closely the Vulkan validation layer watches.
enum class Validation { off, on };

/// What the validation layer said, in order. Safe to read while the driver works.
class ValidationMessages {
  public:
    void add(std::string message);
    /// The messages so far, which are then forgotten.
    std::vector<std::string> take();

  private:
    std::mutex mutex_;
    std::vector<std::string> messages_;
};

/// The Vulkan instance: the loader's connection to all devices. Created before and outliving every Device.
class VulkanInstance {
  public:
    /// @param validation `on` needs the Khronos validation layer and watches synchronization too
    /// @throws DeviceError if there is no Vulkan loader or driver, the layer is missing, or its messages
    /// could not be heard
    explicit VulkanInstance(Validation validation = Validation::off);
    VulkanInstance(const VulkanInstance&) = delete;
    VulkanInstance& operator=(const VulkanInstance&) = delete;
    ~VulkanInstance();

    [[nodiscard]] const vk::raii::Instance& handle() const { return *instance_; }
    [[nodiscard]] ValidationMessages& validation_messages() { return *messages_; }
    [[nodiscard]] bool has_debug_names() const { return debug_utils_; }

  private:
    void connect(Validation validation);

    std::unique_ptr<ValidationMessages> messages_ = std::make_unique<ValidationMessages>();
    vk::raii::Context context_;
    bool debug_utils_ = false;
    std::optional<vk::raii::Instance> instance_;
    std::optional<vk::raii::DebugUtilsMessengerEXT> messenger_;
};

}  // namespace utsuri
