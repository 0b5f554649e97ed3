// SPDX-License-Identifier: Apache-2.0
// The judge of the oracle tests: it must pass what rounding explains and nothing else.
#include "gpu/hit_judge.h"

#include "support/triangle_soup.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace utsuri {
namespace {

using test::Verdict;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// Two layers of a square each, at z = 0 and z = -1.
class HitJudge : public testing::Test {
  protected:
    static test::TriangleSoup layers() {
        test::TriangleSoup soup;
        for (const float z : {0.0f, -1.0f}) {
            soup.add({0, 0, z}, {1, 0, z}, {1, 1, z});
            soup.add({0, 0, z}, {1, 1, z}, {0, 1, z});
        }
        return soup;
    }

    /// The device triangle with this input index.
    [[nodiscard]] std::uint32_t device_triangle(std::uint32_t input) const {
        return static_cast<std::uint32_t>(std::find(bvh_.order.begin(), bvh_.order.end(), input) -
                                          bvh_.order.begin());
    }

    [[nodiscard]] Verdict judge(const interop::RayInfo& ray, const interop::HitInfo& hit) const {
        std::string explanation;
        const Verdict verdict = test::judge(bvh_, ray, hit, explanation);
        EXPECT_EQ(verdict == Verdict::wrong, !explanation.empty());
        return verdict;
    }

    test::TriangleSoup soup_ = layers();
    Bvh bvh_ = build_bvh(soup_.positions, soup_.triangles);
    interop::RayInfo down_{{0.75f, 0.25f, 2.0f}, {0, 0, -1}, kInfinity, interop::NONE};
    interop::HitInfo nothing_{kInfinity, interop::NONE, 0.0f, 0.0f};
};

TEST_F(HitJudge, AcceptsTheTruth) {
    EXPECT_EQ(judge(down_, {2.0f, device_triangle(0), 0.5f, 0.25f}), Verdict::exact);
    EXPECT_EQ(judge(down_, {std::nextafter(2.0f, 3.0f), device_triangle(0), 0.5f, 0.25f}), Verdict::exact);
}

TEST_F(HitJudge, RefusesAMiss) {
    EXPECT_EQ(judge(down_, nothing_), Verdict::wrong);
}

TEST_F(HitJudge, RefusesAWrongDistance) {
    EXPECT_EQ(judge(down_, {2.001f, device_triangle(0), 0.5f, 0.25f}), Verdict::wrong);
    EXPECT_EQ(judge(down_, {std::nanf(""), device_triangle(0), 0.5f, 0.25f}), Verdict::wrong);
}

TEST_F(HitJudge, RefusesAHitBehindAnother) {
    EXPECT_EQ(judge(down_, {3.0f, device_triangle(2), 0.5f, 0.25f}), Verdict::wrong);
}

TEST_F(HitJudge, RefusesATriangleThatTheRayPassesBy) {
    EXPECT_EQ(judge(down_, {2.0f, device_triangle(1), 0.5f, 0.25f}), Verdict::wrong);
    EXPECT_EQ(judge(down_, {2.0f, 99, 0.5f, 0.25f}), Verdict::wrong);
}

TEST_F(HitJudge, RefusesWhatIsOutOfRangeOrExcluded) {
    interop::RayInfo ray = down_;
    ray.t_max = 1.5f;
    EXPECT_EQ(judge(ray, {2.0f, device_triangle(0), 0.5f, 0.25f}), Verdict::wrong);
    EXPECT_EQ(judge(ray, nothing_), Verdict::exact);
    ray = down_;
    ray.excluded = device_triangle(0);
    EXPECT_EQ(judge(ray, {2.0f, device_triangle(0), 0.5f, 0.25f}), Verdict::wrong);
    EXPECT_EQ(judge(ray, {3.0f, device_triangle(2), 0.5f, 0.25f}), Verdict::exact);
}

TEST_F(HitJudge, AcceptsEitherTriangleOnASharedEdge) {
    interop::RayInfo ray = down_;
    ray.origin = {0.5f, 0.5f, 2.0f};
    for (const std::uint32_t input : {0u, 1u}) {
        EXPECT_NE(judge(ray, {2.0f, device_triangle(input), 0.5f, 0.5f}), Verdict::wrong);
    }
    EXPECT_EQ(judge(ray, {3.0f, device_triangle(2), 0.5f, 0.5f}), Verdict::within_rounding)
        << "no one triangle is hit for certain: a leak, which the watertightness tests look for";
}

TEST_F(HitJudge, AcceptsAMissWithinRoundingOfTheBorderOnly) {
    interop::RayInfo ray = down_;
    ray.direction = {0.0f, 0.3f, -1.0f};
    // The plane z = 0 is met at t = 2, one float above the border y = 0. The way of 0.6 along y makes an
    // error of some 10 units roundoff of it possible.
    ray.origin.y = std::nextafter(-2.0f * 0.3f, 0.0f);
    EXPECT_EQ(judge(ray, {3.0f, device_triangle(2), 0.5f, 0.0f}), Verdict::within_rounding);
    ray.origin.y += 1e-5f;
    EXPECT_EQ(judge(ray, {3.0f, device_triangle(2), 0.5f, 0.0f}), Verdict::wrong);
}

TEST_F(HitJudge, BoundsGrowForSlivers) {
    const interop::BvhTriangle square{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const interop::BvhTriangle needle{{0, 0, -100}, {1, 0, 100}, {0, 1e-4f, 100}};
    const interop::RayInfo ray{{0.25f, 2e-5f, 2.0f}, {0, 0, -1}, kInfinity, interop::NONE};
    const auto plain = test::decide(square, ray);
    EXPECT_NEAR(plain.t, 2.0, 1e-12);
    EXPECT_LT(plain.t_error, 1e-5);
    EXPECT_GT(test::decide(needle, ray).t_error, 10.0 * plain.t_error);
}

}  // namespace
}  // namespace utsuri
