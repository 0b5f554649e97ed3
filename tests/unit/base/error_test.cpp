// SPDX-License-Identifier: Apache-2.0
#include "base/error.h"

#include <gtest/gtest.h>

namespace utsuri {
namespace {

TEST(Error, ReadsOperationObjectProblem) {
    EXPECT_STREQ(InputError("read scene", "'a.glb'", "no such file").what(),
                 "read scene 'a.glb': no such file");
    EXPECT_STREQ(DeviceError("choose a Vulkan device", "", "none is there").what(),
                 "choose a Vulkan device: none is there");
}

TEST(Error, HasTheExitCodeOfItsKind) {
    EXPECT_EQ(UsageError("a", "b", "c").exit_code(), ExitCode::usage);
    EXPECT_EQ(InputError("a", "b", "c").exit_code(), ExitCode::input);
    EXPECT_EQ(DeviceError("a", "b", "c").exit_code(), ExitCode::device);
}

TEST(Error, ExitCodesAreTheContractOfTheCommandLine) {
    EXPECT_EQ(static_cast<int>(ExitCode::success), 0);
    EXPECT_EQ(static_cast<int>(ExitCode::difference), 1);
    EXPECT_EQ(static_cast<int>(ExitCode::usage), 2);
    EXPECT_EQ(static_cast<int>(ExitCode::input), 3);
    EXPECT_EQ(static_cast<int>(ExitCode::device), 4);
    EXPECT_EQ(static_cast<int>(ExitCode::interrupted), 130);
}

}  // namespace
}  // namespace utsuri
