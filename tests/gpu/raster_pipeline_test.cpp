// SPDX-License-Identifier: Apache-2.0
#include "gpu/raster_pipeline.h"

#include "support/test_device.h"

#include "base/check.h"
#include "base/error.h"

#include "kernels/raster_probe_frag.h"
#include "kernels/raster_probe_vert.h"

#include <glm/vec4.hpp>
#include <gmock/gmock.h>

#include <array>
#include <bit>
#include <string>
#include <vector>

namespace utsuri {
namespace {

using testing::HasSubstr;

constexpr std::uint32_t kWidth = 37;
constexpr std::uint32_t kHeight = 23;
constexpr std::array<float, 4> kBackground = {0.0f, -3.0f, 1e20f, -1.0f};

class RasterOnDevice : public DeviceTest {
  protected:
    /// What every pixel says after the triangles were drawn: see raster_probe.frag.
    static std::vector<glm::vec4> draw(const std::vector<glm::vec4>& corners, float shift = 0.0f,
                                       const Specialization& specialization = {}) {
        const RasterPipeline pipeline(device(), "raster_probe", kernels::raster_probe_vert,
                                      kernels::raster_probe_frag, specialization, sizeof(float));
        const Buffer buffer = make_buffer<glm::vec4>(device(), corners, "corners");
        const BindingSet set = pipeline.bind({{0, &buffer}});
        const Attachment colour(device(), kWidth, kHeight, kColourFormat, "colour");
        const Attachment depth(device(), kWidth, kHeight, kDepthFormat, "depth");
        const Buffer pixels(device(), kWidth * kHeight * sizeof(glm::vec4), "pixels");
        device().run("draw", [&](const vk::raii::CommandBuffer& commands) {
            draw_into(commands, colour, depth, kBackground, [&] {
                pipeline.draw(commands, set, shift, 0, static_cast<std::uint32_t>(corners.size() / 3));
            });
            colour.copy_rows(commands, 0, kHeight, pixels);
        });
        return pixels.download_records<glm::vec4>(kWidth * kHeight);
    }
};

/// Two triangles that fill the picture at a depth.
std::vector<glm::vec4> whole_picture(float depth) {
    return {{-1, -1, depth, 1}, {1, -1, depth, 1}, {1, 1, depth, 1},
            {-1, -1, depth, 1}, {1, 1, depth, 1},  {-1, 1, depth, 1}};
}

TEST_F(RasterOnDevice, TwoTrianglesLeaveNoGapBetweenThem) {
    const std::vector<glm::vec4> pixels = draw(whole_picture(0.5f));
    int of_first = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        EXPECT_TRUE(pixels[i].x == 1.0f || pixels[i].x == 2.0f) << i;
        of_first += pixels[i].x == 1.0f ? 1 : 0;
    }
    EXPECT_NEAR(of_first, kWidth * kHeight / 2, (kWidth + kHeight) / 2);
}

TEST_F(RasterOnDevice, SamplesTheCentreOfAPixel) {
    const std::vector<glm::vec4> pixels = draw(whole_picture(0.5f));
    for (std::uint32_t y = 0; y < kHeight; ++y) {
        for (std::uint32_t x = 0; x < kWidth; ++x) {
            // Rows run downwards, as y does in Vulkan's clip space. Corners are placed to 1/256 of a pixel.
            EXPECT_NEAR(pixels[y * kWidth + x].y, 2.0 * (x + 0.5) / kWidth - 1.0, 2.0 / kWidth / 256.0);
            EXPECT_NEAR(pixels[y * kWidth + x].z, 2.0 * (y + 0.5) / kHeight - 1.0, 2.0 / kHeight / 256.0);
        }
    }
}

// Depth is reversed: the larger is the nearer, whichever is drawn first.
TEST_F(RasterOnDevice, TheNearestWins) {
    std::vector<glm::vec4> far_first = whole_picture(0.25f);
    for (const glm::vec4& corner : whole_picture(0.5f))
        far_first.push_back(corner);
    std::vector<glm::vec4> near_first = whole_picture(0.5f);
    for (const glm::vec4& corner : whole_picture(0.25f))
        near_first.push_back(corner);
    for (const glm::vec4& pixel : draw(far_first))
        EXPECT_GE(pixel.x, 3.0f);
    for (const glm::vec4& pixel : draw(near_first))
        EXPECT_LE(pixel.x, 2.0f);
}

// Depth alone first, then only what lies at that depth; the vertices of the second draw begin at its first
// triangle.
TEST_F(RasterOnDevice, ShadesOnlyWhatADepthPassLeft) {
    std::vector<glm::vec4> corners = whole_picture(0.25f);
    for (const glm::vec4& corner : whole_picture(0.5f))
        corners.push_back(corner);
    const RasterPipeline depth_pass(device(), "depth pass", kernels::raster_probe_vert, {}, {},
                                    sizeof(float));
    const RasterPipeline equal(device(), "raster_probe", kernels::raster_probe_vert,
                               kernels::raster_probe_frag, {}, sizeof(float), {DepthTest::equal});
    const Buffer buffer = make_buffer<glm::vec4>(device(), corners, "corners");
    const BindingSet depth_set = depth_pass.bind({{0, &buffer}});
    const BindingSet set = equal.bind({{0, &buffer}});
    const Attachment colour(device(), kWidth, kHeight, kColourFormat, "colour");
    const Attachment depth(device(), kWidth, kHeight, kDepthFormat, "depth");
    const Buffer pixels(device(), kWidth * kHeight * sizeof(glm::vec4), "pixels");
    const auto shaded = [&](bool far_ones) {
        device().run("draw", [&](const vk::raii::CommandBuffer& commands) {
            draw_into(commands, colour, depth, kBackground, [&] {
                depth_pass.draw(commands, depth_set, 0.0f, 0, 4);
                equal.draw(commands, set, 0.0f, far_ones ? 0 : 2, 2);
            });
            colour.copy_rows(commands, 0, kHeight, pixels);
        });
        return pixels.download_records<glm::vec4>(kWidth * kHeight);
    };
    for (const glm::vec4& pixel : shaded(false))
        EXPECT_GE(pixel.x, 3.0f);
    for (const glm::vec4& pixel : shaded(true))
        EXPECT_EQ(pixel.x, kBackground[0]);
}

// A second drawing over the first: depth starts anew, colours stay where nothing is drawn or allowed to be.
TEST_F(RasterOnDevice, DrawsOverWhatIsThereWithinARectangle) {
    const std::vector<glm::vec4> corners = whole_picture(0.5f);
    const RasterPipeline pipeline(device(), "raster_probe", kernels::raster_probe_vert,
                                  kernels::raster_probe_frag, {}, sizeof(float));
    const RasterPipeline silent(device(), "raster_probe, no colour", kernels::raster_probe_vert,
                                kernels::raster_probe_frag, {}, sizeof(float), {}, {{kColourFormat}, false});
    const Buffer buffer = make_buffer<glm::vec4>(device(), corners, "corners");
    const BindingSet set = pipeline.bind({{0, &buffer}});
    const BindingSet silent_set = silent.bind({{0, &buffer}});
    const Attachment colour(device(), kWidth, kHeight, kColourFormat, "colour");
    const Attachment depth(device(), kWidth, kHeight, kDepthFormat, "depth");
    const Buffer pixels(device(), kWidth * kHeight * sizeof(glm::vec4), "pixels");
    const PixelRect rectangle{3, 5, 20, 7};
    device().run("draw", [&](const vk::raii::CommandBuffer& commands) {
        draw_into(commands, colour, depth, kBackground, [&] {
            limit_to(commands, {0, 0, kWidth, 10});
            pipeline.draw(commands, set, 0.0f, 0, 1);
        });
        const ColourTarget kept{colour, std::nullopt};
        draw_into(commands, std::span(&kept, 1), depth, [&] {
            limit_to(commands, rectangle);
            pipeline.draw(commands, set, 0.0f, 1, 1);
            limit_to(commands, {0, 0, kWidth, kHeight});
            silent.draw(commands, silent_set, 0.0f, 0, 2);
        });
        colour.copy_rows(commands, 0, kHeight, pixels);
    });
    const std::vector<glm::vec4> drawn = pixels.download_records<glm::vec4>(kWidth * kHeight);
    // Which of the two triangles a pixel lies in, from a picture of both.
    const std::vector<glm::vec4> both = draw(corners);
    for (std::uint32_t y = 0; y < kHeight; ++y) {
        for (std::uint32_t x = 0; x < kWidth; ++x) {
            const bool inside = x >= 3 && x < 23 && y >= 5 && y < 12;
            const float triangle = both[y * kWidth + x].x;
            const bool shows = triangle == 1.0f ? y < 10 : inside;
            EXPECT_EQ(drawn[y * kWidth + x].x, shows ? triangle : kBackground[0]) << x << ' ' << y;
        }
    }
}

TEST_F(RasterOnDevice, DrawsBothSides) {
    std::vector<glm::vec4> turned = whole_picture(0.5f);
    std::swap(turned[1], turned[2]);
    for (const glm::vec4& pixel : draw(turned))
        EXPECT_GE(pixel.x, 1.0f);
}

// Half way across the picture between w = 1 and w = 3 is a quarter of the way in space.
TEST_F(RasterOnDevice, InterpolatesInPerspective) {
    const std::vector<glm::vec4> pixels = draw({{-1, -1, 0.5f, 1},
                                                {3, -3, 0.5f, 3},
                                                {3, 3, 0.5f, 3},
                                                {-1, -1, 0.5f, 1},
                                                {3, 3, 0.5f, 3},
                                                {-1, 1, 0.5f, 1}});
    for (std::uint32_t x = 0; x < kWidth; ++x) {
        const double screen = (x + 0.5) / kWidth;                                // 0 at w = 1, 1 at w = 3
        const double weight = (screen / 3.0) / ((1.0 - screen) + screen / 3.0);  // of the corners at w = 3
        EXPECT_NEAR(pixels[(kHeight / 2) * kWidth + x].y, 2.0 * weight - 1.0, 3.0 * 2.0 / kWidth / 256.0);
    }
}

TEST_F(RasterOnDevice, LeavesTheBackgroundWhereNothingIsDrawn) {
    const std::vector<glm::vec4> nothing = draw({});
    for (const glm::vec4& pixel : nothing)
        EXPECT_EQ(pixel, glm::vec4(kBackground[0], kBackground[1], kBackground[2], kBackground[3]));
    // Moved by half the picture to the right.
    const std::vector<glm::vec4> right = draw(whole_picture(0.5f), 1.0f);
    for (std::uint32_t x = 0; x < kWidth; ++x)
        EXPECT_EQ(right[x].x > 0.0f, 2 * x + 1 >= kWidth) << x;
}

TEST_F(RasterOnDevice, ClipsAtTheNearPlane) {
    // z > w is nearer than the near plane.
    for (const glm::vec4& pixel : draw(whole_picture(1.5f)))
        EXPECT_EQ(pixel.x, 0.0f);
}

TEST_F(RasterOnDevice, TakesSpecializationConstants) {
    for (const glm::vec4& pixel : draw(whole_picture(0.5f), 0.0f, {{0, std::bit_cast<std::uint32_t>(6.5f)}}))
        EXPECT_EQ(pixel.w, 6.5f);
}

TEST_F(RasterOnDevice, IsCompiledOnceForEachStateAndSetOfConstants) {
    const auto pipelines_after = [](const Specialization& specialization, const DepthState& depth,
                                    const ColourState& colour) {
        const RasterPipeline pipeline(device(), "raster_probe", kernels::raster_probe_vert,
                                      kernels::raster_probe_frag, specialization, sizeof(float), depth,
                                      colour);
        return device().pipelines().size();
    };
    const std::size_t once = pipelines_after({}, {}, {});
    EXPECT_EQ(pipelines_after({}, {}, {}), once);
    EXPECT_EQ(pipelines_after({}, {DepthTest::nearer, 7.0f}, {}), once + 1);
    EXPECT_EQ(pipelines_after({}, {DepthTest::equal, 7.0f}, {}), once + 2);
    EXPECT_EQ(pipelines_after({}, {DepthTest::equal, 7.0f}, {{kColourFormat}, false}), once + 3);
    EXPECT_EQ(pipelines_after({{0, 7}}, {DepthTest::equal, 7.0f}, {{kColourFormat}, false}), once + 4);
}

TEST_F(RasterOnDevice, RefusesPicturesLargerThanTheDeviceDraws) {
    const std::uint32_t limit = device().summary().image_size;
    try {
        const Attachment attachment(device(), limit + 1, 1, kColourFormat, "large");
        FAIL() << "made an image of " << limit + 1 << " pixels";
    } catch (const DeviceError& error) {
        EXPECT_THAT(error.what(), HasSubstr(std::to_string(limit)));
    }
}

TEST_F(RasterOnDevice, ReplacesSomeRows) {
    const Attachment colour(device(), kWidth, kHeight, kColourFormat, "colour");
    const Attachment depth(device(), kWidth, kHeight, kDepthFormat, "depth");
    const std::vector rows(2 * kWidth, glm::vec4(7.0f, 8.0f, 9.0f, 10.0f));
    const Buffer replacement = make_buffer<glm::vec4>(device(), rows, "two rows");
    const Buffer pixels(device(), kWidth * kHeight * sizeof(glm::vec4), "pixels");
    device().run("draw", [&](const vk::raii::CommandBuffer& commands) {
        draw_into(commands, colour, depth, kBackground, [] {});
        colour.replace_rows(commands, 5, 2, replacement);
        colour.copy_rows(commands, 0, kHeight, pixels);
    });
    const auto drawn = pixels.download_records<glm::vec4>(kWidth * kHeight);
    for (std::uint32_t y = 0; y < kHeight; ++y) {
        const bool is_replaced = y == 5 || y == 6;
        for (std::uint32_t x = 0; x < kWidth; ++x)
            EXPECT_EQ(drawn[y * kWidth + x].y, is_replaced ? 8.0f : kBackground[1]) << x << ' ' << y;
    }
}

TEST_F(RasterOnDevice, CopiesSomeRows) {
    const Attachment colour(device(), kWidth, kHeight, kColourFormat, "colour");
    const Attachment depth(device(), kWidth, kHeight, kDepthFormat, "depth");
    const RasterPipeline pipeline(device(), "raster_probe", kernels::raster_probe_vert,
                                  kernels::raster_probe_frag, {}, sizeof(float));
    const Buffer buffer = make_buffer<glm::vec4>(device(), whole_picture(0.5f), "corners");
    const BindingSet set = pipeline.bind({{0, &buffer}});
    const Buffer rows(device(), 2 * kWidth * sizeof(glm::vec4), "two rows");
    device().run("draw", [&](const vk::raii::CommandBuffer& commands) {
        draw_into(commands, colour, depth, kBackground, [&] { pipeline.draw(commands, set, 0.0f, 0, 2); });
        colour.copy_rows(commands, 0, 2, rows);
        colour.copy_rows(commands, 5, 2, rows);
    });
    EXPECT_NEAR(rows.download_records<glm::vec4>(1).front().z, 2.0 * 5.5 / kHeight - 1.0,
                2.0 / kHeight / 256.0);
}

}  // namespace
}  // namespace utsuri
