// SPDX-License-Identifier: Apache-2.0
#include "kernels/film_probe.h"

#include "support/test_device.h"

#include "gpu/probe.h"

namespace utsuri {
namespace {

class FilmProbe : public DeviceTest {
  protected:
    static double total(const interop::FilmQuery& query) {
        const auto answers = test::ask<interop::FilmAnswer>(device(), "film_probe", kernels::film_probe,
                                                            std::vector<interop::FilmQuery>{query});
        return static_cast<double>(answers[0].sum) - static_cast<double>(answers[0].compensation);
    }
};

TEST_F(FilmProbe, KeepsASmallTermBetweenLargeOnes) {
    // A plain float32 sum of 2^24, 1, -2^24 is 0, and so is a compensated one whose terms a compiler has
    // cancelled.
    EXPECT_EQ(total({16777216.0f, 1.0f, -16777216.0f, 1}), 1.0);
}

TEST_F(FilmProbe, KeepsTheDigitsOfALongSum) {
    // Mesa's software driver ends the loops of an invocation after 65535 iterations. By then a plain float32
    // sum of 0.1f is off by some 1e-5: each term is rounded to multiples of 2^-11.
    constexpr std::uint32_t kCount = 60000;
    const double expected = static_cast<double>(0.1f) * kCount;
    // Two units roundoff of the sum (Higham 2002, section 4.3); the compensation is part of the total.
    EXPECT_NEAR(total({0.1f, 0.0f, 0.0f, kCount}), expected, 2.0 * 0x1p-24 * expected);
}

}  // namespace
}  // namespace utsuri
