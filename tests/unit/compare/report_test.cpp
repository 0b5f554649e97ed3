// SPDX-License-Identifier: Apache-2.0
#include "compare/comparison/report.h"

#include "compare/comparison/comparison_json.h"
#include "compare/comparison/reflection_pictures.h"

#include "image/error_map.h"
#include "image_io/image_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace utsuri {
namespace {

using nlohmann::ordered_json;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr std::uint32_t kWidth = 8;
constexpr std::uint32_t kHeight = 6;
constexpr std::string_view kPngUri = "data:image/png;base64,";
constexpr std::string_view kDataBegin = "<script type=\"application/json\" id=\"data\">";

Image ramp(float slope) {
    Image image(kWidth, kHeight);
    for (std::uint32_t y = 0; y < kHeight; ++y) {
        for (std::uint32_t x = 0; x < kWidth; ++x) {
            const float value = slope * static_cast<float>(x + y * kWidth);
            image.at(x, y) = {value, 0.5f * value, 1.0f};
        }
    }
    return image;
}

/// A reference and every method; the second has no metrics over reflective pixels.
Comparison make_comparison() {
    Comparison comparison;
    comparison.scene = "scenes/room.glb";
    comparison.command = "utsuri compare scenes/room.glb -o out";
    comparison.device.name = "a device";
    comparison.settings.width = kWidth;
    comparison.settings.height = kHeight;
    comparison.exposure = -3.0;
    comparison.reference.samples = 64;
    comparison.reference.image = ramp(0.1f);
    comparison.notes = {"a camera was added"};
    float slope = 0.11f;
    for (const Method& method : all_methods(light_methods().front())) {
        MethodResult result;
        result.method = method;
        result.samples = 16;
        result.image = ramp(slope);
        result.flip = Plane(kWidth, kHeight, slope);
        result.metrics.flip = static_cast<double>(slope);
        result.metrics.pixels = kWidth * kHeight;
        comparison.methods.push_back(result);
        slope += 0.2f;
    }
    return comparison;
}

std::string data_text(const std::string& page) {
    const std::size_t begin = page.find(kDataBegin);
    if (begin == std::string::npos) return {};
    const std::size_t first = begin + kDataBegin.size();
    return page.substr(first, page.find("</script>", first) - first);
}

ordered_json data_of(const std::string& page) {
    return ordered_json::parse(data_text(page));
}

std::size_t count(std::string_view text, std::string_view part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at + 1))
        ++found;
    return found;
}

/// RFC 4648, section 4; the digits must be right, the padding as well.
std::vector<std::byte> decode_base64(std::string_view text) {
    constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::vector<std::byte> bytes;
    EXPECT_EQ(text.size() % 4, 0u);
    std::uint32_t bits = 0;
    int held = 0;
    for (const char c : text.substr(0, text.find('='))) {
        const std::size_t digit = kDigits.find(c);
        EXPECT_NE(digit, std::string_view::npos) << "'" << c << "'";
        bits = bits << 6 | static_cast<std::uint32_t>(digit);
        held += 6;
        if (held < 8) continue;
        held -= 8;
        bytes.push_back(static_cast<std::byte>(bits >> held & 0xffu));
    }
    return bytes;
}

std::vector<std::byte> decode_picture(const ordered_json& uri) {
    const auto text = uri.get<std::string>();
    EXPECT_EQ(text.substr(0, kPngUri.size()), kPngUri);
    return decode_base64(std::string_view(text).substr(kPngUri.size()));
}

TEST(Report, HoldsTheComparisonAsJson) {
    const Comparison comparison = make_comparison();
    ordered_json data = data_of(make_report(comparison));
    ASSERT_TRUE(data.contains("pictures"));
    data.erase("pictures");
    EXPECT_EQ(data, ordered_json::parse(comparison_to_json(comparison).dump()));
    ASSERT_EQ(data["methods"].size(), all_methods(light_methods().front()).size());
    EXPECT_EQ(data["methods"][0]["name"], "direct/trace");
    EXPECT_EQ(data["methods"][1]["name"], "direct/polygon-map");
    EXPECT_EQ(data["methods"][2]["name"], "direct/sphere-map");
}

TEST(Report, IsOneWholePage) {
    const std::string page = make_report(make_comparison());
    EXPECT_THAT(page, HasSubstr("<!doctype html>\n<html lang=\"en\">"));
    EXPECT_THAT(page, HasSubstr("<meta name=\"viewport\""));
    EXPECT_THAT(page, HasSubstr("<title>scenes/room.glb"));
    EXPECT_EQ(page.substr(page.size() - 8), "</html>\n");
    EXPECT_THAT(page, HasSubstr("prefers-color-scheme"));
    EXPECT_THAT(page, HasSubstr("function startViewer("));
    EXPECT_THAT(page, Not(HasSubstr("{{")));
}

TEST(Report, FetchesNothing) {
    const std::string page = make_report(make_comparison());
    for (const char* part :
         {"http://", "https://", "@import", "url(", "src=", "fetch(", "XMLHttpRequest", "\"//"}) {
        EXPECT_THAT(page, Not(HasSubstr(part)));
    }
    EXPECT_THAT(page, HasSubstr("default-src 'none'"));
    EXPECT_EQ(count(page, "href="), 1u);
    EXPECT_THAT(page, HasSubstr("href=\"data:,\""));
}

TEST(Report, HoldsThePicturesAsPng) {
    const Comparison comparison = make_comparison();
    const ordered_json pictures = data_of(make_report(comparison))["pictures"];
    const std::vector<std::byte> reference = decode_picture(pictures["reference"]);
    constexpr std::array<unsigned char, 8> kSignature = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    ASSERT_GE(reference.size(), kSignature.size());
    for (std::size_t i = 0; i < kSignature.size(); ++i)
        EXPECT_EQ(std::to_integer<unsigned>(reference[i]), kSignature[i]);
    EXPECT_EQ(reference, encode_png(comparison.reference.image, comparison.exposure));
    ASSERT_EQ(pictures["methods"].size(), comparison.methods.size());
    for (std::size_t i = 0; i < comparison.methods.size(); ++i) {
        const MethodResult& result = comparison.methods[i];
        EXPECT_EQ(decode_picture(pictures["methods"][i]["image"]),
                  encode_png(result.image, comparison.exposure));
        EXPECT_EQ(decode_picture(pictures["methods"][i]["error_map"]),
                  encode_png_coded(error_map(result.flip)));
    }
}

/// The second method tells errors, the third also what it traced.
Comparison comparison_with_predictions() {
    Comparison comparison = make_comparison();
    for (const std::size_t i : {1u, 2u}) {
        ReflectionErrors& errors = comparison.methods[i].reflection_errors.emplace();
        errors.predicted = Plane(kWidth, kHeight, 2.0f);
        errors.measured = Plane(kWidth, kHeight, 0.5f);
    }
    comparison.methods[2].reflection_errors->traced = Plane(kWidth, kHeight, 1.0f);
    return comparison;
}

TEST(Report, HoldsPicturesOfErrorsOfReflections) {
    const Comparison comparison = comparison_with_predictions();
    const ordered_json methods = data_of(make_report(comparison))["pictures"]["methods"];
    for (const char* name : {"predicted", "measured", "traced"})
        EXPECT_FALSE(methods[0].contains(name)) << name;
    for (const std::size_t i : {1u, 2u}) {
        const ReflectionErrors& errors = *comparison.methods[i].reflection_errors;
        EXPECT_EQ(decode_picture(methods[i]["predicted"]),
                  encode_png_coded(displacement_picture(errors.predicted)));
        EXPECT_EQ(decode_picture(methods[i]["measured"]),
                  encode_png_coded(displacement_picture(errors.measured)));
    }
    EXPECT_TRUE(methods[1]["traced"].is_null());
    EXPECT_EQ(decode_picture(methods[2]["traced"]),
              encode_png_coded(traced_picture(comparison.methods[2].reflection_errors->traced)));
}

TEST(Report, ShowsTheScaleOfDisplacementsFromEndToEnd) {
    const ordered_json scale = data_of(make_report(make_comparison()))["pictures"]["displacement_scale"];
    EXPECT_EQ(scale["least"].get<float>(), kLeastDisplacement);
    EXPECT_EQ(scale["most"].get<float>(), kMostDisplacement);
    const Texture drawn = decode_texture(decode_picture(scale["image"]), "scale of displacements");
    Plane ends(2, 1);
    ends.values = {kLeastDisplacement, kMostDisplacement};
    const Texture expected = decode_texture(encode_png_coded(displacement_picture(ends)), "ends");
    constexpr std::size_t kTexel = 4;
    for (std::size_t c = 0; c < kTexel; ++c) {
        EXPECT_EQ(drawn.rgba[c], expected.rgba[c]);
        EXPECT_EQ(drawn.rgba[drawn.rgba.size() - kTexel + c], expected.rgba[kTexel + c]);
    }
}

TEST(Report, ShowsTheColourScaleFromZeroToOne) {
    const ordered_json pictures = data_of(make_report(make_comparison()))["pictures"];
    const Texture scale = decode_texture(decode_picture(pictures["error_scale"]), "colour scale");
    ASSERT_EQ(scale.height, 1u);
    ASSERT_GE(scale.width, 256u);
    Plane ends(2, 1);
    ends.at(1, 0) = 1.0f;
    const Texture expected = decode_texture(encode_png_coded(error_map(ends)), "ends");
    constexpr std::size_t kTexel = 4;
    for (std::size_t c = 0; c < kTexel; ++c) {
        EXPECT_EQ(scale.rgba[c], expected.rgba[c]);
        EXPECT_EQ(scale.rgba[scale.rgba.size() - kTexel + c], expected.rgba[kTexel + c]);
    }
}

TEST(Report, WritesMetricsThatDoNotExistAsNull) {
    Comparison comparison = make_comparison();
    comparison.methods[0].metrics.psnr = std::numeric_limits<double>::infinity();
    const std::string page = make_report(comparison);
    const ordered_json data = data_of(page);
    EXPECT_TRUE(data["methods"][0]["metrics"]["psnr"].is_null());
    EXPECT_TRUE(data["methods"][0]["metrics_reflective"]["flip"].is_null());
    EXPECT_FALSE(data["methods"][0]["metrics"]["flip"].is_null());
    const std::string text = data_text(page);
    EXPECT_THAT(text, Not(HasSubstr("nan")));
    EXPECT_THAT(text, Not(HasSubstr("inf,")));
}

class HostileText : public ::testing::TestWithParam<const char*> {};

TEST_P(HostileText, CannotEndItsPlaceInThePage) {
    const std::string plain = make_report(make_comparison());
    Comparison comparison = make_comparison();
    comparison.scene = GetParam();
    comparison.command = GetParam();
    comparison.device.name = GetParam();
    comparison.notes = {GetParam()};
    const std::string page = make_report(comparison);
    for (const char* markup :
         {"<script", "</script", "<!--", "-->", "<img", "<title>", "</title>", "</style"}) {
        EXPECT_EQ(count(page, markup), count(plain, markup)) << markup;
    }
    const ordered_json data = data_of(page);
    EXPECT_EQ(data["scene"], GetParam());
    EXPECT_EQ(data["command"], GetParam());
    EXPECT_EQ(data["device"]["name"], GetParam());
    EXPECT_EQ(data["notes"][0], GetParam());
}

INSTANTIATE_TEST_SUITE_P(Report, HostileText,
                         ::testing::Values("</script><script>alert(1)</script>", "<!-- <script>", "-->",
                                           "</title><img src=x onerror=alert(1)>",
                                           "a \"b\" 'c' & <d> &lt;.glb", "C:\\scenes\\room.glb",
                                           "{{data}} /*{{style}}*/ /*{{script}}*/", "</style>", "部屋.glb"));

TEST(Report, EscapesTheTitle) {
    Comparison comparison = make_comparison();
    comparison.scene = "<a> & \"b\" 'c'";
    EXPECT_THAT(make_report(comparison), HasSubstr("<title>&lt;a&gt; &amp; &quot;b&quot; &#39;c&#39; –"));
}

TEST(Report, ShowsBytesThatAreNotUtf8AsReplacementCharacters) {
    Comparison comparison = make_comparison();
    comparison.scene = "caf\xe9.glb";
    const std::string page = make_report(comparison);
    EXPECT_THAT(page, HasSubstr("<title>caf\xef\xbf\xbd.glb"));
    EXPECT_EQ(data_of(page)["scene"], "caf\xef\xbf\xbd.glb");
    EXPECT_EQ(count(page, "caf\xe9"), 0u);
}

TEST(Report, CanBeMadeBeforeAnyMethodHasFinished) {
    Comparison comparison = make_comparison();
    comparison.methods.clear();
    comparison.interrupted = true;
    const ordered_json data = data_of(make_report(comparison));
    EXPECT_TRUE(data["methods"].empty());
    EXPECT_TRUE(data["pictures"]["methods"].empty());
    EXPECT_EQ(data["interrupted"], true);
}

TEST(Report, NamesMethodsThatFailed) {
    Comparison comparison = make_comparison();
    comparison.failures.push_back({find_method("direct", "sphere-map"), "too large", ExitCode::usage});
    EXPECT_EQ(data_of(make_report(comparison))["failed"][0]["message"], "too large");
}

TEST(Report, LeavesOutPicturesThatAreEmpty) {
    Comparison comparison = make_comparison();
    comparison.methods[1].flip = Plane();
    comparison.methods[1].image = Image();
    const ordered_json pictures = data_of(make_report(comparison))["pictures"];
    EXPECT_TRUE(pictures["methods"][1]["image"].is_null());
    EXPECT_TRUE(pictures["methods"][1]["error_map"].is_null());
    EXPECT_FALSE(pictures["methods"][2]["image"].is_null());
}

}  // namespace
}  // namespace utsuri
