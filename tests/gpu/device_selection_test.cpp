// SPDX-License-Identifier: Apache-2.0
#include "gpu/device_selection.h"

#include "base/error.h"
#include "gpu/device.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>

namespace utsuri {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class DeviceSelection : public testing::Test {
  protected:
    void SetUp() override {
        ASSERT_FALSE(devices_.empty()) << "tests need a Vulkan device, software is enough";
    }

    std::string error_of(std::string_view wanted) {
        try {
            choose_device(instance_, wanted);
        } catch (const DeviceError& error) {
            return error.what();
        }
        return "no DeviceError";
    }

    VulkanInstance instance_;
    std::vector<DeviceSummary> devices_ = list_devices(instance_);
};

TEST_F(DeviceSelection, DescribesEachDevice) {
    for (std::size_t i = 0; i < devices_.size(); ++i) {
        EXPECT_EQ(devices_[i].index, i);
        EXPECT_FALSE(devices_[i].name.empty());
        EXPECT_FALSE(devices_[i].driver.empty());
        EXPECT_EQ(std::count(devices_[i].api.begin(), devices_[i].api.end(), '.'), 2);
        EXPECT_GT(devices_[i].memory_bytes, 0u);
        // The least that Vulkan allows.
        EXPECT_GE(devices_[i].storage_range_bytes, std::uint64_t{1} << 27);
        EXPECT_GE(devices_[i].subgroup_size, 1u);
    }
}

TEST_F(DeviceSelection, TakesAnIndex) {
    for (const DeviceSummary& device : devices_) {
        if (!device.usable()) continue;
        EXPECT_EQ(choose_device(instance_, fmt::format("{}", device.index)).name, device.name);
    }
}

TEST_F(DeviceSelection, TakesAPartOfANameInAnyCase) {
    const DeviceSummary chosen = choose_device(instance_, "");
    std::string upper = chosen.name;
    std::transform(upper.begin(), upper.end(), upper.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    const auto same_name = std::count_if(devices_.begin(), devices_.end(), [&](const DeviceSummary& device) {
        return device.name == chosen.name;
    });
    if (same_name > 1) GTEST_SKIP() << "two devices of one name";
    EXPECT_EQ(choose_device(instance_, upper).index, chosen.index);
}

TEST_F(DeviceSelection, TellsThatNoneFits) {
    for (const std::string wanted : {"no such device", "999", "-1", "0x0"}) {
        EXPECT_THAT(error_of(wanted), AllOf(HasSubstr("'" + wanted + "'"), HasSubstr("0 devices fit"),
                                            HasSubstr("0: " + devices_[0].name)));
    }
}

TEST_F(DeviceSelection, TellsThatSeveralFit) {
    if (devices_.size() < 2) GTEST_SKIP() << "needs two devices";
    // A letter that the names of two devices share.
    for (char letter = 'a'; letter <= 'z'; ++letter) {
        const auto has_letter = [&](const DeviceSummary& device) {
            return std::any_of(device.name.begin(), device.name.end(),
                               [&](unsigned char c) { return static_cast<char>(std::tolower(c)) == letter; });
        };
        const auto count = std::count_if(devices_.begin(), devices_.end(), has_letter);
        if (count < 2) continue;
        EXPECT_THAT(error_of(std::string(1, letter)), HasSubstr(fmt::format("{} devices fit", count)));
        return;
    }
    GTEST_SKIP() << "no letter in common";
}

TEST_F(DeviceSelection, PrefersTheFastestKind) {
    const std::vector<std::string> kinds = {"discrete GPU", "integrated GPU", "virtual GPU", "CPU", "other"};
    const DeviceSummary chosen = choose_device(instance_, "");
    EXPECT_TRUE(chosen.usable());
    const auto rank = [&](const DeviceSummary& device) {
        return std::find(kinds.begin(), kinds.end(), device.kind) - kinds.begin();
    };
    for (const DeviceSummary& device : devices_) {
        EXPECT_LT(rank(device), 5) << device.kind;
        if (device.usable()) {
            EXPECT_LE(rank(chosen), rank(device));
        }
    }
}

TEST(QueueFamily, HasComputeAndTimestampsAndGraphicsWhereItCan) {
    const auto family = [](vk::QueueFlags flags, std::uint32_t timestamp_bits) {
        vk::QueueFamilyProperties properties;
        properties.queueFlags = flags;
        properties.timestampValidBits = timestamp_bits;
        return properties;
    };
    using Flag = vk::QueueFlagBits;
    EXPECT_EQ(find_queue_family({}), std::nullopt);
    EXPECT_EQ(find_queue_family({family(Flag::eTransfer, 64)}), std::nullopt);
    EXPECT_EQ(find_queue_family({family(Flag::eCompute, 0)}), std::nullopt);
    EXPECT_EQ(find_queue_family({family(Flag::eGraphics, 64), family(Flag::eCompute, 36)}), 1u);
    EXPECT_EQ(find_queue_family({family(Flag::eCompute, 64), family(Flag::eCompute | Flag::eGraphics, 64)}),
              1u);
}

}  // namespace
}  // namespace utsuri
