// SPDX-License-Identifier: Apache-2.0
#include "geometry/bounds.h"

#include <gtest/gtest.h>

namespace utsuri {
namespace {

TEST(Bounds, StartsEmpty) {
    const Bounds bounds;
    EXPECT_TRUE(bounds.empty());
    EXPECT_EQ(bounds.half_area(), 0.0f);
}

TEST(Bounds, AreTheSmallestBoxOfTheirPoints) {
    Bounds bounds;
    bounds.extend(glm::vec3(1.0f, -2.0f, 3.0f));
    EXPECT_FALSE(bounds.empty());
    EXPECT_EQ(bounds.half_area(), 0.0f);
    bounds.extend(glm::vec3(-1.0f, 2.0f, 3.5f));
    EXPECT_EQ(bounds.lower, glm::vec3(-1.0f, -2.0f, 3.0f));
    EXPECT_EQ(bounds.upper, glm::vec3(1.0f, 2.0f, 3.5f));
    EXPECT_EQ(bounds.extent(), glm::vec3(2.0f, 4.0f, 0.5f));
    EXPECT_EQ(bounds.half_area(), 2.0f * 4.0f + 4.0f * 0.5f + 0.5f * 2.0f);
}

TEST(Bounds, JoinAndIgnoreEmptyOnes) {
    Bounds a;
    a.extend(glm::vec3(0.0f));
    Bounds b;
    b.extend(glm::vec3(1.0f, 2.0f, 3.0f));
    a.extend(b);
    EXPECT_EQ(a.upper, glm::vec3(1.0f, 2.0f, 3.0f));
    a.extend(Bounds());
    EXPECT_EQ(a.lower, glm::vec3(0.0f));
    EXPECT_EQ(a.upper, glm::vec3(1.0f, 2.0f, 3.0f));
}

}  // namespace
}  // namespace utsuri
