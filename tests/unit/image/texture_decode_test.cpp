// SPDX-License-Identifier: Apache-2.0
#include "image_io/image_io.h"

#include "unit/image/image_bytes.h"
#include "unit/image/scratch_folder.h"
#include "unit/image/test_images.h"

#include <gtest/gtest.h>

namespace utsuri {
namespace {

using test::as_bytes;
using test::make_png;
using Rgba = std::vector<std::uint8_t>;

Texture decode(const test::Bytes& bytes) {
    return decode_texture(as_bytes(bytes), "images[3]");
}

void expect_refused(const std::vector<std::byte>& bytes, const std::string& reason) {
    test::expect_input_error([&] { static_cast<void>(decode_texture(bytes, "images[3]")); },
                             {"decode texture", "'images[3]'", reason});
}

TEST(DecodeTexture, KeepsBytesAsStored) {
    const Texture texture =
        decode(make_png(2, 2, {8, 6}, {1, 2, 3, 4, 5, 6, 7, 0, 9, 10, 11, 128, 13, 14, 15, 255}, 8));
    EXPECT_EQ(texture.name, "images[3]");
    EXPECT_EQ(texture.width, 2u);
    EXPECT_EQ(texture.height, 2u);
    EXPECT_EQ(texture.rgba, (Rgba{1, 2, 3, 4, 5, 6, 7, 0, 9, 10, 11, 128, 13, 14, 15, 255}));
}

TEST(DecodeTexture, FillsMissingChannels) {
    EXPECT_EQ(decode(make_png(1, 1, {8, 2}, {10, 20, 30}, 3)).rgba, (Rgba{10, 20, 30, 255}));
    EXPECT_EQ(decode(make_png(2, 1, {8, 0}, {10, 200}, 2)).rgba, (Rgba{10, 10, 10, 255, 200, 200, 200, 255}));
    EXPECT_EQ(decode(make_png(1, 1, {8, 4}, {10, 77}, 2)).rgba, (Rgba{10, 10, 10, 77}));
}

TEST(DecodeTexture, ExpandsPalettesAndBits) {
    EXPECT_EQ(decode(make_png(2, 1, {8, 3}, {1, 0}, 2, {1, 2, 3, 40, 50, 60})).rgba,
              (Rgba{40, 50, 60, 255, 1, 2, 3, 255}));
    // Bits 1 and 0 of a one-bit grey row.
    EXPECT_EQ(decode(make_png(2, 1, {1, 0}, {0x80}, 1)).rgba, (Rgba{255, 255, 255, 255, 0, 0, 0, 255}));
}

TEST(DecodeTexture, RoundsSixteenBitsToEight) {
    // 0x8079 / 65535 * 255 = 127.98, 0x00ff -> 0.99, 0x0040 -> 0.249
    EXPECT_EQ(decode(make_png(1, 1, {16, 2}, {0x80, 0x79, 0x00, 0xff, 0x00, 0x40}, 6)).rgba,
              (Rgba{128, 1, 0, 255}));
}

TEST(DecodeTexture, Jpeg) {
    const Texture texture = decode(test::make_grey_jpeg());
    EXPECT_EQ(texture.width, 8u);
    EXPECT_EQ(texture.height, 8u);
    for (std::size_t i = 0; i < texture.rgba.size(); ++i)
        EXPECT_EQ(texture.rgba[i], i % 4 == 3 ? 255 : 128);
}

TEST(DecodeTexture, RefusesOtherAndDamagedBytes) {
    expect_refused({}, "no bytes");
    expect_refused(as_bytes({'<', 's', 'v', 'g', '>'}), "PNG or JPEG");
    expect_refused(as_bytes({0x76, 0x2f, 0x31, 0x01, 2, 0, 0, 0}), "PNG or JPEG");
    const std::vector<std::byte> whole = encode_png(test::noise(32, 32, 1), 0.0);
    for (const std::size_t kept : {9u, 30u, 200u, 2000u}) {
        expect_refused({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(kept)}, "cut short");
    }
    const std::vector<std::byte> jpeg = as_bytes(test::make_grey_jpeg());
    for (const std::size_t kept : {4u, 100u, 140u}) {
        expect_refused({jpeg.begin(), jpeg.begin() + static_cast<std::ptrdiff_t>(kept)}, "cut short");
    }
    expect_refused(as_bytes(make_png(16384, 16384, {8, 6}, {1}, 1)), "cannot be in");
    expect_refused(as_bytes(make_png(1u << 31, 1, {8, 6}, {1}, 1)), "");
}

}  // namespace
}  // namespace utsuri
