// SPDX-License-Identifier: Apache-2.0
#include "image/shrink.h"

#include "unit/image/test_images.h"

#include <gtest/gtest.h>

namespace utsuri {
namespace {

Image numbered(std::uint32_t width, std::uint32_t height) {
    return test::grey_picture(width, height, [width](std::uint32_t x, std::uint32_t y) {
        return static_cast<float>(x + y * width);
    });
}

TEST(Shrink, TakesMeansOfSquares) {
    const Image shrunk = shrink_to_width(numbered(4, 4), 2);
    ASSERT_EQ(shrunk.width, 2u);
    ASSERT_EQ(shrunk.height, 2u);
    EXPECT_EQ(shrunk.at(0, 0), glm::vec3(2.5f));   // of 0, 1, 4, 5
    EXPECT_EQ(shrunk.at(1, 1), glm::vec3(12.5f));  // of 10, 11, 14, 15
}

TEST(Shrink, WhatIsLeftAtTheEdgesIsAMeanOfItsOwn) {
    const Image shrunk = shrink_to_width(numbered(5, 3), 4);
    ASSERT_EQ(shrunk.width, 3u);
    ASSERT_EQ(shrunk.height, 2u);
    EXPECT_EQ(shrunk.at(2, 0), glm::vec3(6.5f));   // of 4 and 9
    EXPECT_EQ(shrunk.at(0, 1), glm::vec3(10.5f));  // of 10 and 11
    EXPECT_EQ(shrunk.at(2, 1), glm::vec3(14.0f));
}

TEST(Shrink, NarrowPicturesStayAsTheyAre) {
    const Image image = numbered(5, 3);
    EXPECT_EQ(shrink_to_width(image, 5).pixels, image.pixels);
    EXPECT_EQ(shrink_to_width(image, 1000).pixels, image.pixels);
}

TEST(Shrink, ToAColumn) {
    const Image shrunk = shrink_to_width(numbered(3, 3), 1);
    ASSERT_EQ(shrunk.pixels.size(), 1u);
    EXPECT_EQ(shrunk.at(0, 0), glm::vec3(4.0f));
}

}  // namespace
}  // namespace utsuri
