// SPDX-License-Identifier: Apache-2.0
#include "base/command_line.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace utsuri {
namespace {

std::string command(const std::vector<std::string>& words) {
    return shell_command(words);
}

TEST(ShellCommand, PlainWordsStayAsTheyAre) {
    EXPECT_EQ(command({"utsuri", "render", "a/b.glb", "--size", "64x48", "-o", "x.exr"}),
              "utsuri render a/b.glb --size 64x48 -o x.exr");
    EXPECT_EQ(command({}), "");
}

TEST(ShellCommand, QuotesWhatAShellWouldTakeApart) {
    EXPECT_EQ(command({"two words"}), "'two words'");
    EXPECT_EQ(command({""}), "''");
    EXPECT_EQ(command({"$HOME", "a;b", "*"}), "'$HOME' 'a;b' '*'");
    EXPECT_EQ(command({"it's"}), "'it'\\''s'");
}

}  // namespace
}  // namespace utsuri
