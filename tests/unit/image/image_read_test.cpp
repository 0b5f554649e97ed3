// SPDX-License-Identifier: Apache-2.0
#include "base/file.h"
#include "image/colour.h"
#include "image_io/image_io.h"

#include "unit/image/image_bytes.h"
#include "unit/image/scratch_folder.h"
#include "unit/image/test_images.h"

#include <gtest/gtest.h>

#include <cstring>

namespace utsuri {
namespace {

using test::expect_input_error;
using test::make_png;

class ReadImage : public test::ScratchFolder {
  protected:
    void expect_refused(const std::filesystem::path& file, const std::string& reason) const {
        expect_input_error([&] { static_cast<void>(read_image(file)); },
                           {"read image", file.string(), reason});
    }
    /// An EXR of noise cut after `fraction` of its bytes.
    [[nodiscard]] std::filesystem::path cut(const std::filesystem::path& whole, double fraction) const {
        std::vector<std::byte> bytes = read_file(whole, "test");
        bytes.resize(static_cast<std::size_t>(fraction * static_cast<double>(bytes.size())));
        return store("cut_" + std::to_string(fraction) + whole.extension().string(), bytes);
    }
};

TEST_F(ReadImage, DecodesSrgbBytes) {
    const auto file = store("rgb.png", make_png(2, 1, {8, 2}, {0, 128, 255, 10, 20, 30}, 6));
    const Image image = read_image(file);
    ASSERT_EQ(image.width, 2u);
    ASSERT_EQ(image.height, 1u);
    EXPECT_NEAR(image.at(0, 0).y, 0.2158605, 1e-6);
    EXPECT_EQ(image.at(0, 0).x, 0.0f);
    EXPECT_NEAR(image.at(0, 0).z, 1.0, 1e-6);
    EXPECT_NEAR(image.at(1, 0).z, srgb_decode(30.0f / 255.0f), 1e-7);
}

TEST_F(ReadImage, DecodesSixteenBits) {
    const auto file = store("deep.png", make_png(1, 1, {16, 2}, {0x80, 0x00, 0x12, 0x34, 0xff, 0xff}, 6));
    const Image image = read_image(file);
    EXPECT_NEAR(image.at(0, 0).x, srgb_decode(32768.0f / 65535.0f), 1e-6);
    EXPECT_NEAR(image.at(0, 0).y, srgb_decode(4660.0f / 65535.0f), 1e-7);
}

TEST_F(ReadImage, ExpandsGreyAndDropsAlphaWithoutMultiplyingIt) {
    const Image grey = read_image(store("grey.png", make_png(2, 1, {8, 0}, {0, 128}, 2)));
    EXPECT_NEAR(grey.at(1, 0).x, 0.2158605, 1e-6);
    EXPECT_EQ(grey.at(1, 0).x, grey.at(1, 0).y);
    EXPECT_EQ(grey.at(1, 0).x, grey.at(1, 0).z);
    const Image transparent = read_image(store("rgba.png", make_png(1, 1, {8, 6}, {128, 128, 128, 64}, 4)));
    EXPECT_NEAR(transparent.at(0, 0).y, 0.2158605, 1e-6);
    const Image grey_alpha = read_image(store("ga.png", make_png(1, 1, {8, 4}, {128, 0}, 2)));
    EXPECT_NEAR(grey_alpha.at(0, 0).z, 0.2158605, 1e-6);
}

TEST_F(ReadImage, GoesByContentNotByName) {
    const auto file = store("picture.exr", make_png(1, 1, {8, 0}, {255}, 1));
    EXPECT_NEAR(read_image(file).at(0, 0).x, 1.0, 1e-6);
}

TEST_F(ReadImage, Jpeg) {
    const Image image = read_image(store("grey.jpg", test::make_grey_jpeg()));
    ASSERT_EQ(image.width, 8u);
    for (const glm::vec3& pixel : image.pixels)
        EXPECT_NEAR(pixel.y, 0.2158605, 1e-6);
}

TEST_F(ReadImage, RadianceIsLinear) {
    // Two pixels without run lengths: mantissas 128, 64, 32 at exponent 129 are 1, 0.5, 0.25.
    const std::string header = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n";
    test::Bytes bytes(header.begin(), header.end());
    bytes.insert(bytes.end(), {128, 64, 32, 129, 128, 64, 32, 139});
    const Image image = read_image(store("two.hdr", bytes));
    // A decoder may add half a step of the mantissa.
    EXPECT_NEAR(image.at(0, 0).x, 1.0, 0.5 / 128.0);
    EXPECT_NEAR(image.at(0, 0).y, 0.5, 0.5 / 128.0);
    EXPECT_NEAR(image.at(1, 0).z, 256.0, 4.0);
}

TEST_F(ReadImage, TakesChannelsByName) {
    const std::vector<float> depth{5.0f, 6.0f};
    const std::vector<float> colour{1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f};
    write_exr_channels(path("layers.exr"), 2, 1,
                       {{{"A.depth"}, depth.data()}, {{"R", "G", "B"}, colour.data()}});
    const Image image = read_image(path("layers.exr"));
    EXPECT_EQ(image.at(0, 0), glm::vec3(1.0f, 2.0f, 3.0f));
    EXPECT_EQ(image.at(1, 0), glm::vec3(4.0f, 5.0f, 6.0f));
    write_exr_channels(path("y.exr"), 2, 1, {{{"Y"}, depth.data()}});
    EXPECT_EQ(read_image(path("y.exr")).at(1, 0), glm::vec3(6.0f));
}

TEST_F(ReadImage, RefusesWhatIsNoImage) {
    expect_refused(path("missing.exr"), "no such file");
    expect_refused(path("."), "folder");
    expect_refused(store("empty.png", test::Bytes{}), "empty");
    expect_refused(store("text.png", test::Bytes{'h', 'e', 'l', 'l', 'o', '\n'}),
                   "EXR, HDR, TIFF, PNG or JPEG");
    expect_refused(store("magic.exr", test::Bytes{0x76, 0x2f, 0x31, 0x01}), "cut short");
    expect_refused(store("magic.png", test::Bytes{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'}), "cut short");
    expect_refused(store("magic.tif", test::Bytes{'I', 'I', '*', 0}), "cut short");
    expect_refused(store("magic.jpg", test::Bytes{0xff, 0xd8, 0xff}), "cut short");
    expect_refused(store("magic.hdr", test::Bytes{'#', '?', 'R', 'G', 'B', 'E', '\n'}), "cut short");
}

TEST_F(ReadImage, RefusesTruncatedFiles) {
    const Image noise = test::noise(64, 64, 1);
    write_exr(path("whole.exr"), noise, ExrPrecision::single);
    write_png(path("whole.png"), noise, 0.0);
    for (const double fraction : {0.02, 0.3, 0.6, 0.95}) {
        expect_refused(cut(path("whole.exr"), fraction), "cut short");
        expect_refused(cut(path("whole.png"), fraction), "cut short");
    }
    std::string header = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4 +X 4\nabcd";
    expect_refused(store("cut.hdr", test::Bytes(header.begin(), header.end())), "cut short");
}

TEST_F(ReadImage, RefusesTruncatedTiff) {
    // One grey byte at `offset` of a little-endian file; entries are tag, type, count, value.
    const auto tiff = [](std::uint8_t offset) {
        test::Bytes bytes{'I', 'I', '*', 0, 8, 0, 0, 0, 8, 0};
        const std::vector<std::pair<std::uint16_t, std::uint8_t>> entries{
            {256, 1}, {257, 1}, {258, 8}, {259, 1}, {262, 1}, {273, offset}, {278, 1}, {279, 1}};
        for (const auto& [tag, value] : entries) {
            bytes.insert(bytes.end(),
                         {static_cast<std::uint8_t>(tag & 0xff), static_cast<std::uint8_t>(tag >> 8), 3, 0, 1,
                          0, 0, 0, value, 0, 0, 0});
        }
        bytes.insert(bytes.end(), {0, 0, 0, 0, 128});
        return bytes;
    };
    const std::uint8_t last = 8 + 2 + 8 * 12 + 4;
    EXPECT_NEAR(read_image(store("one.tif", tiff(last))).at(0, 0).y, 0.2158605, 1e-6);
    expect_refused(store("outside.tif", tiff(last + 50)), "cut short");
    test::Bytes cut_entries = tiff(last);
    cut_entries.resize(40);
    expect_refused(store("cut.tif", cut_entries), "cut short");
}

TEST_F(ReadImage, SkipsPngProfilesSilently) {
    test::Bytes png = make_png(1, 1, {8, 0}, {128}, 1);
    test::Bytes profile;
    const std::string body = "broken profile";
    test::append_chunk(profile, "iCCP", test::Bytes(body.begin(), body.end()));
    png.insert(png.begin() + 8 + 12 + 13, profile.begin(), profile.end());
    testing::internal::CaptureStderr();
    EXPECT_NEAR(read_image(store("profile.png", png)).at(0, 0).y, 0.2158605, 1e-6);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(ReadImage, LinearPngIsTakenAsItIs) {
    test::Bytes png = make_png(1, 1, {8, 0}, {128}, 1);
    test::Bytes gamma;
    test::append_chunk(gamma, "gAMA", {0x00, 0x01, 0x86, 0xa0});  // 100000: an exponent of one
    png.insert(png.begin() + 8 + 12 + 13, gamma.begin(), gamma.end());
    EXPECT_NEAR(read_image(store("linear.png", png)).at(0, 0).y, 128.0 / 255.0, 1e-6);
}

TEST_F(ReadImage, RefusesDamagedChecksums) {
    std::vector<std::byte> bytes = encode_png(test::noise(16, 16, 1), 0.0);
    bytes[bytes.size() / 2] ^= std::byte{0x55};
    expect_refused(store("flipped.png", bytes), "damaged");
}

TEST_F(ReadImage, RefusesSizesThatTheFileCannotHold) {
    expect_refused(store("wide.png", make_png(70000, 1, {8, 0}, {1}, 1)), "65536");
    expect_refused(store("big.png", make_png(65536, 65536, {8, 0}, {1}, 1)), "268435456");
    expect_refused(store("false.png", make_png(16384, 16384, {8, 0}, {1}, 1)), "cannot be in");
    expect_refused(store("none.png", make_png(0, 5, {8, 0}, {1}, 1)), "");
    const std::string header = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2000000000 +X 2000000000\n";
    expect_refused(store("huge.hdr", test::Bytes(header.begin(), header.end())), "");
}

TEST_F(ReadImage, RefusesHostileExrWindows) {
    write_exr(path("whole.exr"), test::noise(8, 8, 1), ExrPrecision::half);
    const std::vector<std::byte> whole = read_file(path("whole.exr"), "test");
    for (const std::int32_t last : {99999, 1999999999, -5}) {
        std::vector<std::byte> bytes = whole;
        for (const std::string_view key : {"dataWindow", "displayWindow"}) {
            const auto* begin = reinterpret_cast<const char*>(bytes.data());
            const std::size_t at = std::string_view(begin, bytes.size()).find(key);
            ASSERT_NE(at, std::string_view::npos);
            // The name and its zero, "box2i" and its zero, the size; then min x, min y, max x, max y.
            const std::size_t maximum = at + key.size() + 1 + 6 + 4 + 8;
            std::memcpy(bytes.data() + maximum, &last, sizeof last);
            std::memcpy(bytes.data() + maximum + 4, &last, sizeof last);
        }
        expect_refused(store("window.exr", bytes), "");
    }
}

}  // namespace
}  // namespace utsuri
