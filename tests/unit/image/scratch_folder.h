// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

namespace utsuri::test {

/// A test with an empty folder of its own, removed afterwards.
class ScratchFolder : public testing::Test {
  protected:
    void SetUp() override {
        const testing::TestInfo* info = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::path(testing::TempDir()) /
                  (std::string("utsuri_") + info->test_suite_name() + "_" + info->name());
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    [[nodiscard]] std::filesystem::path path(const std::string& name) const { return folder_ / name; }

    template <typename Byte>
    std::filesystem::path store(const std::string& name, const std::vector<Byte>& bytes) const {
        static_assert(sizeof(Byte) == 1);
        std::ofstream(path(name), std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
        return path(name);
    }

    /// The names in the folder.
    [[nodiscard]] std::set<std::string> listing() const {
        std::set<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(folder_))
            names.insert(entry.path().filename());
        return names;
    }

  private:
    std::filesystem::path folder_;
};

/// Runs `action`, which must throw InputError, write nothing to the terminal, and name each of `parts`.
template <typename Action>
void expect_input_error(const Action& action, const std::vector<std::string>& parts) {
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    std::string message;
    try {
        action();
    } catch (const InputError& error) {
        message = error.what();
    }
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_NE(message, "") << "no InputError";
    for (const std::string& part : parts)
        EXPECT_THAT(message, testing::HasSubstr(part));
    EXPECT_THAT(message, testing::Not(testing::HasSubstr("\n")));
}

}  // namespace utsuri::test
