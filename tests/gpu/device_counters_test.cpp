// SPDX-License-Identifier: Apache-2.0
#include "renderers/film/device_counters.h"

#include "renderers/film/film.h"
#include "support/test_device.h"

#include "base/error.h"
#include "gpu/kernel.h"

#include "interop/bindings.h"
#include "interop/frame.h"
#include "interop/raster.h"
#include "kernels/add_drawn.h"

#include <glm/vec4.hpp>
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace utsuri {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// Of 100 drawn pixels, 10 are seen in two mirrors and cut there, one of them not finite; the others took
/// three rays.
constexpr std::uint32_t kPixels = 100;
constexpr std::uint32_t kCut = 10;
constexpr std::uint32_t kTraced = kPixels - kCut;

class CountersOnDevice : public DeviceTest {
  protected:
    /// Adds a drawn picture to a film.
    static void add_drawn(DeviceCounters& counters) {
        constexpr float kCutAtTwo = -2.5f;  // as lib/pixel_state.glsl has it
        constexpr float kThreeRays = interop::DRAWN_LOOKED_UP + 3.0f * interop::DRAWN_RAY;
        std::vector<glm::vec4> pixels(kPixels, {1, 1, 1, kThreeRays});
        std::fill_n(pixels.begin(), kCut, glm::vec4(1, 1, 1, kCutAtTwo));
        pixels.front().x = std::numeric_limits<float>::infinity();
        const Buffer drawn = make_buffer<glm::vec4>(device(), pixels, "drawn");
        const Film film(device(), kPixels, 1, "film");
        const Buffer no_maps = make_buffer<std::uint32_t>(device(), {}, "map states");
        const Kernel kernel(device(), "add_drawn", kernels::add_drawn, {}, sizeof(interop::AddDrawnPush));
        const BindingSet set = kernel.bind({{interop::BINDING_FILM, &film.bands().front().pixels},
                                            {interop::BINDING_DRAWN, &drawn},
                                            {interop::BINDING_COUNTERS, &counters.buffer()},
                                            {interop::BINDING_MAP_STATES, &no_maps}});
        device().run("add drawn", [&](const vk::raii::CommandBuffer& commands) {
            kernel.dispatch(commands, set, interop::AddDrawnPush{kPixels, 0}, group_count(kPixels));
        });
    }

    static FrameCounts read(const DeviceCounters& counters) {
        return counters.read("count", "pixels", "a smaller --depth");
    }

    /// What is there before the picture is added to it.
    static void begin_at(DeviceCounters& counters, const interop::Counters& totals) {
        counters.buffer().upload(std::as_bytes(std::span(&totals, 1)));
    }

    /// @param before of each counter
    static void expect_pictures(const FrameCounts& counts, std::uint64_t pictures, std::uint64_t before) {
        EXPECT_EQ(counts.rays, before + 3 * kTraced * pictures);
        EXPECT_EQ(counts.traced, before + kTraced * pictures);
        EXPECT_EQ(counts.lookups, before + (kTraced + 2 * kCut) * pictures);
        EXPECT_EQ(counts.truncated, before + kCut * pictures);
        EXPECT_EQ(counts.nonfinite, before + pictures);
        EXPECT_EQ(counts.gpu_seconds, 0.0);
    }
};

TEST_F(CountersOnDevice, AddUpUntilTheyAreCleared) {
    DeviceCounters counters(device(), "counters");
    expect_pictures(read(counters), 0, 0);
    add_drawn(counters);
    add_drawn(counters);
    expect_pictures(read(counters), 2, 0);
    counters.clear();
    expect_pictures(read(counters), 0, 0);
}

// Two pictures take some of the counters across 2^32, and leave others below it.
TEST_F(CountersOnDevice, GoOnBeyond32Bits) {
    constexpr std::uint32_t kBefore = 0u - 16u;
    DeviceCounters counters(device(), "counters");
    begin_at(counters, {kBefore, kBefore, kBefore, kBefore, kBefore, 0});
    add_drawn(counters);
    expect_pictures(read(counters), 1, kBefore);
    add_drawn(counters);
    expect_pictures(read(counters), 2, kBefore);
}

TEST_F(CountersOnDevice, TellOfLoopsThatTheDriverEnded) {
    DeviceCounters counters(device(), "counters");
    begin_at(counters, {0, 0, 0, 0, 0, 2});
    try {
        static_cast<void>(read(counters));
        FAIL() << "2 pixels lack samples";
    } catch (const DeviceError& error) {
        EXPECT_THAT(error.what(), AllOf(HasSubstr("count"), HasSubstr("2 pixels early"),
                                        HasSubstr("use a smaller --depth")));
    }
}

}  // namespace
}  // namespace utsuri
