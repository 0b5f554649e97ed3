// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/device.h"

#include <gtest/gtest.h>

namespace utsuri {

/// Base of tests that need a device. A suite shares one; after each test, messages of the validation layer
/// fail it.
class DeviceTest : public testing::Test {
  public:
    static void SetUpTestSuite();
    static void TearDownTestSuite();

  protected:
    void TearDown() override;
    static Device& device();
};

}  // namespace utsuri
