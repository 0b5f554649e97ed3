// SPDX-License-Identifier: Apache-2.0
#include "gpu/probe.h"
#include "support/test_device.h"

#include "kernels/film_probe.h"

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
    // A plain float32 sum of 2^24, 1, -2^24 is 0, and so is a compensated one whose terms a compiler has cancelled.
    EXPECT_EQ(total({16777216.0f, 1.0f, -16777216.0f, 1}), 1.0);
}

TEST_F(FilmProbe, SumsMoreSamplesThanAFloatCanCount) {
    // Added plainly, 0.1f stops to count at 2^21 after some 18 million additions, and is 1 % off long before.
    constexpr std::uint32_t kCount = 20000000;
    const double expected = static_cast<double>(0.1f) * kCount;
    // Two units roundoff of the sum (Higham 2002, section 4.3); the compensation is part of the total.
    EXPECT_NEAR(total({0.1f, 0.0f, 0.0f, kCount}), expected, 2.0 * 0x1p-24 * expected);
}

}  // namespace
}  // namespace utsuri
