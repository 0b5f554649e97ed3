// SPDX-License-Identifier: Apache-2.0
#include "base/file.h"

#include "base/error.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace utsuri {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

class File : public testing::Test {
  protected:
    void SetUp() override {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = fs::path(testing::TempDir()) / fmt::format("utsuri_file_{}", test->name());
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    void TearDown() override {
        std::error_code error;
        fs::permissions(folder_, fs::perms::owner_all, error);
        fs::remove_all(folder_, error);
    }

    [[nodiscard]] std::vector<std::string> names() const {
        std::vector<std::string> result;
        for (const auto& entry : fs::directory_iterator(folder_)) {
            result.push_back(entry.path().filename().string());
        }
        std::sort(result.begin(), result.end());
        return result;
    }

    /// Takes the right to write from the folder; false where that stops nobody, as for a superuser.
    [[nodiscard]] bool make_unwritable() const {
        fs::permissions(folder_, fs::perms::owner_read | fs::perms::owner_exec);
        return !std::ofstream(folder_ / "probe").is_open();
    }

    fs::path folder_;
};

std::string text_of(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

template <typename Function>
std::string input_error_of(Function&& function) {
    try {
        function();
    } catch (const InputError& error) {
        return error.what();
    }
    return "no InputError";
}

TEST_F(File, ReadsBackEveryByte) {
    std::string all(256, '\0');
    for (std::size_t i = 0; i < all.size(); ++i)
        all[i] = static_cast<char>(i);
    write_text_atomically(folder_ / "all.bin", all);
    const std::vector<std::byte> bytes = read_file(folder_ / "all.bin", "read test file");
    ASSERT_EQ(bytes.size(), all.size());
    for (std::size_t i = 0; i < bytes.size(); ++i)
        ASSERT_EQ(std::to_integer<std::size_t>(bytes[i]), i);
}

TEST_F(File, ReadsAnEmptyFile) {
    write_text_atomically(folder_ / "empty", "");
    EXPECT_THAT(read_file(folder_ / "empty", "read test file"), IsEmpty());
}

TEST_F(File, TellsWhatCannotBeRead) {
    EXPECT_THAT(input_error_of([&] { read_file(folder_ / "none.glb", "read scene"); }),
                AllOf(HasSubstr("read scene"), HasSubstr("none.glb"), HasSubstr("no such file")));
    EXPECT_THAT(input_error_of([&] { read_file(folder_, "read scene"); }),
                AllOf(HasSubstr("read scene"), HasSubstr("is a folder, expected a file")));
}

TEST_F(File, WritesThroughATemporaryOfTheSameExtension) {
    fs::path seen;
    write_file_atomically(folder_ / "image.exr", [&](const fs::path& temporary) {
        seen = temporary;
        EXPECT_FALSE(fs::exists(folder_ / "image.exr"));
        std::ofstream(temporary) << "pixels";
    });
    EXPECT_EQ(seen.extension(), ".exr");
    EXPECT_NE(seen, folder_ / "image.exr");
    EXPECT_THAT(names(), testing::ElementsAre("image.exr"));
    EXPECT_EQ(text_of(folder_ / "image.exr"), "pixels");
}

TEST_F(File, LeavesTheOldFileAndNoPartOfTheNewOneWhereWritingThrows) {
    write_text_atomically(folder_ / "report.html", "old");
    const auto write = [](const fs::path& temporary) {
        std::ofstream(temporary) << "half of the ne";
        throw std::runtime_error("disk full");
    };
    EXPECT_THROW(write_file_atomically(folder_ / "report.html", write), std::runtime_error);
    EXPECT_THAT(names(), testing::ElementsAre("report.html"));
    EXPECT_EQ(text_of(folder_ / "report.html"), "old");
}

TEST_F(File, ReplacesAnOldFile) {
    write_text_atomically(folder_ / "a.json", "a long old text");
    write_text_atomically(folder_ / "a.json", "new");
    EXPECT_EQ(text_of(folder_ / "a.json"), "new");
}

TEST_F(File, TellsWhereNothingCanBeWritten) {
    EXPECT_THAT(input_error_of([&] { write_text_atomically(folder_ / "none" / "a.json", "x"); }),
                AllOf(HasSubstr("a.json"), HasSubstr("the folder"), HasSubstr("does not exist")));
    EXPECT_THAT(input_error_of([&] { write_text_atomically(folder_, "x"); }),
                HasSubstr("is a folder, expected a file name"));
}

TEST_F(File, TellsThatAFolderIsNotWritable) {
    if (!make_unwritable()) GTEST_SKIP() << "permissions do not bind this user";
    EXPECT_THAT(input_error_of([&] { write_text_atomically(folder_ / "a.json", "x"); }),
                AllOf(HasSubstr("a.json"), HasSubstr("writable")));
    EXPECT_THAT(input_error_of([&] { make_output_folder(folder_); }), HasSubstr("permission denied"));
}

TEST_F(File, TellsThatADeviceWithoutSpaceIsFull) {
    const fs::path full = "/dev/full";
    if (!fs::exists(full)) GTEST_SKIP() << "no device that is always full";
    EXPECT_THAT(input_error_of([&] { write_text_atomically(full, "x"); }), HasSubstr("disk full"));
    EXPECT_TRUE(fs::is_character_file(full));
}

TEST_F(File, LeavesLinksAndReplacesWhatTheyLeadTo) {
    fs::create_directory(folder_ / "there");
    write_text_atomically(folder_ / "there" / "a.json", "old");
    fs::create_symlink(folder_ / "there" / "a.json", folder_ / "link.json");
    write_text_atomically(folder_ / "link.json", "new");
    EXPECT_TRUE(fs::is_symlink(folder_ / "link.json"));
    EXPECT_EQ(text_of(folder_ / "there" / "a.json"), "new");
}

TEST_F(File, WritesIntoWhatIsNoFile) {
    const fs::path device = "/dev/null";
    if (!fs::exists(device)) GTEST_SKIP() << "no device that takes all";
    write_text_atomically(device, "x");
    EXPECT_TRUE(fs::is_character_file(device));
}

TEST_F(File, TellsBeforehandWhatCannotBeWritten) {
    EXPECT_NO_THROW(check_writable(folder_ / "a.json"));
    EXPECT_THAT(names(), IsEmpty());
    write_text_atomically(folder_ / "a.json", "old");
    EXPECT_NO_THROW(check_writable(folder_ / "a.json"));
    EXPECT_EQ(text_of(folder_ / "a.json"), "old");
    EXPECT_THAT(input_error_of([&] { check_writable(folder_ / "none" / "a.json"); }),
                HasSubstr("does not exist"));
    EXPECT_THAT(input_error_of([&] { check_writable(folder_); }), HasSubstr("is a folder"));
    fs::permissions(folder_ / "a.json", fs::perms::owner_read);
    if (std::ofstream(folder_ / "a.json", std::ios::app)) GTEST_SKIP() << "permissions do not bind this user";
    EXPECT_THAT(input_error_of([&] { write_text_atomically(folder_ / "a.json", "new"); }),
                HasSubstr("may not be changed"));
}

TEST_F(File, MakesFoldersWithTheirParents) {
    make_output_folder(folder_ / "a" / "b" / "c");
    EXPECT_TRUE(fs::is_directory(folder_ / "a" / "b" / "c"));
    EXPECT_TRUE(fs::is_empty(folder_ / "a" / "b" / "c"));
    EXPECT_NO_THROW(make_output_folder(folder_ / "a"));
}

TEST_F(File, TellsThatAFileIsInTheWayOfAFolder) {
    write_text_atomically(folder_ / "taken", "x");
    EXPECT_THAT(input_error_of([&] { make_output_folder(folder_ / "taken"); }),
                AllOf(HasSubstr("create output folder"), HasSubstr("taken")));
    EXPECT_EQ(text_of(folder_ / "taken"), "x");
}

}  // namespace
}  // namespace utsuri
