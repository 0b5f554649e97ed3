// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/proxies/given_proxy.h"

#include "base/error.h"

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace utsuri {
namespace {

using testing::HasSubstr;

/// [10, 14] x [0, 3] x [-7, -2] but for its last side: the world's origin is outside.
const std::string kOpenBox = "1 0 0 14\n-1 0 0 -10  # left\n0 2 0 3\n0 -1 0 0\n0 0 1 -2\n";

class ProxyFile : public testing::Test {
  protected:
    void SetUp() override { path_ = std::filesystem::temp_directory_path() / "utsuri_proxy_test.txt"; }
    void TearDown() override { std::filesystem::remove(path_); }

    GivenProxy read(const std::string& text) {
        std::ofstream(path_) << text;
        return read_proxy(path_);
    }

    void expect_error(const std::string& text, const std::string& part) {
        try {
            read(text);
            ADD_FAILURE() << "read: " << text;
        } catch (const InputError& error) {
            EXPECT_THAT(error.what(), HasSubstr("read proxy"));
            EXPECT_THAT(error.what(), HasSubstr(part));
        }
    }

    std::filesystem::path path_;
};

TEST_F(ProxyFile, HoldsAPlaneALineInTheWorld) {
    const GivenProxy proxy = read("# a room\n" + kOpenBox + "0 0 -1 7\n1 0 1 8\n");
    ASSERT_EQ(proxy.planes.size(), 7u);
    EXPECT_EQ(proxy.name, path_.string());
    EXPECT_EQ(proxy.planes[1].normal, glm::dvec3(-1, 0, 0));
    EXPECT_EQ(proxy.planes[1].offset, -10.0);
    EXPECT_EQ(proxy.planes[2].normal, glm::dvec3(0, 1, 0));
    EXPECT_EQ(proxy.planes[2].offset, 3.0);
    EXPECT_DOUBLE_EQ(glm::length(proxy.planes[6].normal), 1.0);
}

TEST_F(ProxyFile, MustBeNumbers) {
    expect_error(kOpenBox + "0 0 -1\n", "line 6");
    expect_error(kOpenBox + "0 0 -1\n", "distance along it from the world's origin");
    expect_error(kOpenBox + "0 0 0 7\n", "not zero");
    expect_error("", "0 planes; a proxy has 4 to 32");
}

TEST_F(ProxyFile, MustEncloseARegionThatEachPlaneTouches) {
    expect_error(kOpenBox, "enclose nothing");
    // The opposite side of the wall across: nothing is in both half spaces.
    expect_error(kOpenBox + "0 0 -1 1\n", "enclose nothing");
    // The wall across again, and no other side.
    expect_error(kOpenBox + "0 0 -1 2\n", "enclose nothing");
    expect_error(kOpenBox + "0 0 -1 7\n1 0 0 15\n", "line 7");
    expect_error(kOpenBox + "0 0 -1 7\n1 0 0 14\n", "line 7");
}

TEST_F(ProxyFile, MustBeThere) {
    std::filesystem::remove(path_);
    try {
        read_proxy(path_);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("cannot be opened"));
    }
}

}  // namespace
}  // namespace utsuri
