// SPDX-License-Identifier: Apache-2.0
#include "base/check.h"
#include "base/error.h"
#include "base/file.h"
#include "image/colour.h"
#include "image/error_map.h"
#include "image_io/image_io.h"

#include "unit/image/scratch_folder.h"
#include "unit/image/test_images.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace utsuri {
namespace {

using test::expect_input_error;

class WriteImage : public test::ScratchFolder {};

Image wild_values() {
    Image image = test::noise(5, 3, 1);
    image.at(0, 0) = glm::vec3(-1.5f, 1e-30f, 6e4f);
    image.at(1, 0) = glm::vec3(std::numeric_limits<float>::infinity());
    image.at(2, 0) = glm::vec3(std::numeric_limits<float>::quiet_NaN());
    return image;
}

TEST_F(WriteImage, FloatExrIsExact) {
    Image image = wild_values();
    image.at(3, 1) = glm::vec3(3e38f, -3e38f, 1e-44f);
    write_exr(path("a.exr"), image, ExrPrecision::single);
    const Image back = read_image(path("a.exr"));
    ASSERT_TRUE(back.same_size(image));
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        if (i == 2) {
            EXPECT_TRUE(std::isnan(back.pixels[i].x));
        } else {
            EXPECT_EQ(back.pixels[i], image.pixels[i]) << i;
        }
    }
    EXPECT_EQ(listing(), std::set<std::string>{"a.exr"});
}

TEST_F(WriteImage, HalfExrRoundsToElevenBits) {
    const Image image = test::noise(9, 4, 2);
    write_exr(path("a.exr"), image, ExrPrecision::half);
    const Image back = read_image(path("a.exr"));
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(back.pixels[i][c], image.pixels[i][c], 0x1p-11f * image.pixels[i][c] + 0x1p-25f);
        }
    }
    EXPECT_NE(back.pixels, image.pixels);
    write_exr(path("wild.exr"), wild_values(), ExrPrecision::half);
    EXPECT_TRUE(std::isinf(read_image(path("wild.exr")).at(1, 0).x));
}

TEST_F(WriteImage, HalfExrRefusesToOverflow) {
    Image image(2, 1, glm::vec3(65504.0f));
    EXPECT_NO_THROW(write_exr(path("a.exr"), image, ExrPrecision::half));
    EXPECT_EQ(read_image(path("a.exr")).at(0, 0).x, 65504.0f);
    image.at(1, 0).y = -65520.0f;
    EXPECT_THROW(write_exr(path("b.exr"), image, ExrPrecision::half), UsageError);
    EXPECT_EQ(listing(), std::set<std::string>{"a.exr"});
}

TEST_F(WriteImage, EqualPicturesGiveEqualFilesWithTheirMetadata) {
    const Image image = test::noise(20, 20, 3);
    const ImageMetadata metadata{{"utsuri:scene", "room.gltf"}, {"utsuri:seed", "7"}};
    write_exr(path("a.exr"), image, ExrPrecision::single, metadata);
    write_exr(path("b.exr"), image, ExrPrecision::single, metadata);
    const std::vector<std::byte> bytes = read_file(path("a.exr"), "test");
    EXPECT_EQ(bytes, read_file(path("b.exr"), "test"));
    const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    EXPECT_THAT(text, testing::HasSubstr("utsuri:scene"));
    EXPECT_THAT(text, testing::HasSubstr("room.gltf"));
    // Nothing that differs from one day to the next.
    EXPECT_THAT(text, testing::Not(testing::ContainsRegex("20[0-9][0-9]:[0-9][0-9]:")));
}

TEST_F(WriteImage, ExrChannelsNeedDistinctNames) {
    const float value = 1.0f;
    EXPECT_THROW(write_exr_channels(path("a.exr"), 1, 1, {{{"Z"}, &value}, {{"Z"}, &value}}), CheckFailure);
    EXPECT_THROW(write_exr_channels(path("a.exr"), 1, 1, {}), CheckFailure);
}

TEST_F(WriteImage, PngStoresSrgbRoundedToNearest) {
    // Values a third of a step off each code, above and below.
    const Image image = test::grey_picture(256, 2, [](std::uint32_t x, std::uint32_t y) {
        const float offset = y == 0 ? 0.33f : -0.33f;
        return 0.25f * srgb_decode((static_cast<float>(x) + offset) / 255.0f);
    });
    write_png(path("a.png"), image, 2.0);
    const Image back = read_image(path("a.png"));
    ASSERT_TRUE(back.same_size(image));
    for (std::uint32_t y = 0; y < 2; ++y) {
        for (std::uint32_t x = 0; x < 256; ++x) {
            EXPECT_NEAR(back.at(x, y).x, srgb_decode(static_cast<float>(x) / 255.0f), 1e-6) << x << ' ' << y;
        }
    }
    EXPECT_EQ(listing(), std::set<std::string>{"a.png"});
}

TEST_F(WriteImage, PngClampsAndMarksWhatIsNotFinite) {
    write_png(path("a.png"), wild_values(), 0.0);
    const Image back = read_image(path("a.png"));
    EXPECT_EQ(back.at(0, 0).x, 0.0f);
    EXPECT_NEAR(back.at(0, 0).z, 1.0f, 1e-6);
    for (const std::uint32_t x : {1u, 2u}) {
        EXPECT_NEAR(back.at(x, 0).x, 1.0f, 1e-6);
        EXPECT_EQ(back.at(x, 0).y, 0.0f);
    }
}

TEST_F(WriteImage, CodedPngIsNotCodedAgain) {
    Image image(4, 1, glm::vec3(0.5f));
    image.at(1, 0) = glm::vec3(7.0f, -7.0f, std::numeric_limits<float>::quiet_NaN());
    write_png_coded(path("a.png"), image);
    const Image back = read_image(path("a.png"));
    EXPECT_NEAR(back.at(0, 0).x, srgb_decode(128.0f / 255.0f), 1e-6);
    EXPECT_NEAR(back.at(1, 0).x, 1.0f, 1e-6);
    EXPECT_EQ(back.at(1, 0).y, 0.0f);
    EXPECT_EQ(back.at(1, 0).z, 0.0f);
}

TEST_F(WriteImage, JpegIsNearlyThePicture) {
    // A smooth picture: what quality 95 takes away from it is a few code values, here as linear light.
    constexpr float kFewCodeValues = 0.03f;
    const Image image = test::grey_picture(32, 24, [](std::uint32_t x, std::uint32_t y) {
        return 0.1f + 0.02f * static_cast<float>(x) + 0.01f * static_cast<float>(y);
    });
    const std::vector<std::byte> bytes = encode_jpeg(image, 0.0, 95);
    const Image back = read_image(store("a.jpg", bytes));
    ASSERT_TRUE(back.same_size(image));
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        EXPECT_NEAR(back.pixels[i].x, image.pixels[i].x, kFewCodeValues) << i;
    EXPECT_LT(encode_jpeg(test::noise(64, 64, 1), 0.0, 30).size(),
              encode_jpeg(test::noise(64, 64, 1), 0.0, 95).size());
}

TEST_F(WriteImage, FileAndMemoryAreTheSamePng) {
    const Image image = test::noise(30, 20, 8);
    write_png(path("a.png"), image, 0.5);
    EXPECT_EQ(read_file(path("a.png"), "test"), encode_png(image, 0.5));
}

TEST_F(WriteImage, RefusesPlacesThatCannotBeWritten) {
    const Image image(2, 2);
    const auto everyone = [&](const std::filesystem::path& stem) {
        const std::string png = stem.string() + ".png";
        const std::string exr = stem.string() + ".exr";
        expect_input_error([&] { write_png(png, image, 0.0); }, {"write", png});
        expect_input_error([&] { write_png_coded(png, image); }, {"write", png});
        expect_input_error([&] { write_exr(exr, image, ExrPrecision::half); }, {"write", exr});
        expect_input_error(
            [&] {
                write_exr_channels(exr, 1, 1, {{{"Y"}, &image.pixels[0].x}});
            },
            {"write", exr});
    };
    everyone(path("missing") / "picture");
    std::filesystem::create_directory(path("folder.png"));
    std::filesystem::create_directory(path("folder.exr"));
    everyone(path("folder"));
    if (std::filesystem::is_directory("/proc/self")) everyone("/proc/self/picture");
    EXPECT_EQ(listing(), (std::set<std::string>{"folder.png", "folder.exr"}));
}

TEST_F(WriteImage, EmptyPictureIsRefusedWithoutAFile) {
    expect_input_error([&] { write_png(path("a.png"), Image(), 0.0); }, {"0 x 0"});
    expect_input_error([&] { write_exr(path("a.exr"), Image(), ExrPrecision::single); }, {"0 x 0"});
    EXPECT_TRUE(listing().empty());
}

}  // namespace
}  // namespace utsuri
