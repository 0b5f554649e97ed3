// SPDX-License-Identifier: Apache-2.0
#include "support/test_device.h"

#include <cstdlib>
#include <memory>
#include <string_view>

namespace utsuri {
namespace {

struct SharedDevice {
    std::unique_ptr<VulkanInstance> instance;
    std::unique_ptr<Device> device;
};

SharedDevice& shared() {
    static SharedDevice instance;
    return instance;
}

std::string environment(const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr ? value : "";
}

}  // namespace

void DeviceTest::SetUpTestSuite() {
    const Validation validation = environment("UTSURI_VALIDATION") == "1" ? Validation::on : Validation::off;
    shared().instance = std::make_unique<VulkanInstance>(validation);
    shared().device = std::make_unique<Device>(*shared().instance, environment("UTSURI_DEVICE"));
}

void DeviceTest::TearDownTestSuite() {
    shared().device.reset();
    const std::vector<std::string> messages = shared().instance->validation_messages().take();
    for (const std::string& message : messages)
        ADD_FAILURE() << message;
    shared().instance.reset();
}

void DeviceTest::TearDown() {
    for (const std::string& message : shared().instance->validation_messages().take())
        ADD_FAILURE() << message;
}

Device& DeviceTest::device() {
    return *shared().device;
}

}  // namespace utsuri
