// SPDX-License-Identifier: Apache-2.0
#include "compare/report.h"

#include "compare/comparison_json.h"
#include "compare/report_files.h"

#include "base/check.h"
#include "image/error_map.h"
#include "image_io/image_io.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <utility>

namespace utsuri {
namespace {

using Json = nlohmann::ordered_json;

/// Columns of the picture of the colour scale; more than its width on the page.
constexpr std::uint32_t kScaleColumns = 512;

template <std::size_t N>
std::string_view text(const char (&bytes)[N]) {
    return {bytes, N};
}

/// RFC 4648, section 4.
std::string base64(std::span<const std::byte> bytes) {
    constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string coded;
    coded.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t group = 0;
        for (std::size_t j = 0; j < 3; ++j) {
            group = group << 8 | (j < count ? std::to_integer<std::uint32_t>(bytes[i + j]) : 0u);
        }
        for (std::size_t j = 0; j < 4; ++j) {
            coded += j <= count ? kDigits[group >> (18 - 6 * j) & 63u] : '=';
        }
    }
    return coded;
}

std::string data_uri(std::span<const std::byte> png) {
    return "data:image/png;base64," + base64(png);
}

Json picture(const Image& image, double stops) {
    return image.pixels.empty() ? Json(nullptr) : Json(data_uri(encode_png(image, stops)));
}

Json coded_picture(const Plane& errors) {
    return errors.values.empty() ? Json(nullptr) : Json(data_uri(encode_png_coded(error_map(errors))));
}

/// The colours of errors from 0 to 1, left to right.
Plane error_scale() {
    Plane scale(kScaleColumns, 1);
    for (std::uint32_t x = 0; x < kScaleColumns; ++x) {
        scale.at(x, 0) = static_cast<float>(x) / static_cast<float>(kScaleColumns - 1);
    }
    return scale;
}

Json pictures_to_json(const Comparison& comparison) {
    Json methods = Json::array();
    for (const MethodResult& result : comparison.methods) {
        methods.push_back({{"image", picture(result.image, comparison.exposure)},
                           {"error_map", coded_picture(result.flip)}});
    }
    return {{"reference", picture(comparison.reference.image, comparison.exposure)},
            {"methods", std::move(methods)},
            {"error_scale", coded_picture(error_scale())}};
}

std::string replace_each(std::string_view source,
                         std::span<const std::pair<char, std::string_view>> replacements) {
    std::string result;
    result.reserve(source.size());
    for (const char c : source) {
        const auto found = std::find_if(replacements.begin(), replacements.end(),
                                        [c](const auto& replacement) { return replacement.first == c; });
        if (found == replacements.end()) {
            result += c;
        } else {
            result += found->second;
        }
    }
    return result;
}

/// JSON has these characters only inside strings, where they may be written as escapes. Without them no
/// string can end the script element that holds it.
std::string script_safe(const Json& json) {
    constexpr std::array<std::pair<char, std::string_view>, 3> kEscapes = {
        {{'<', "\\u003c"}, {'>', "\\u003e"}, {'&', "\\u0026"}}};
    // A path need not be UTF-8; what is not is shown as U+FFFD.
    return replace_each(json.dump(-1, ' ', false, Json::error_handler_t::replace), kEscapes);
}

std::string html_text(std::string_view source) {
    constexpr std::array<std::pair<char, std::string_view>, 5> kEntities = {
        {{'<', "&lt;"}, {'>', "&gt;"}, {'&', "&amp;"}, {'"', "&quot;"}, {'\'', "&#39;"}}};
    return replace_each(source, kEntities);
}

struct Part {
    std::string_view marker;
    std::string_view value;
};

/// The template with each marker, in this order and once each, replaced by its value. Values are not
/// searched.
std::string fill_template(std::string_view page, std::span<const Part> parts) {
    std::string filled;
    for (const Part& part : parts) {
        const std::size_t at = page.find(part.marker);
        UTSURI_CHECK_LT(at, page.size());
        filled += page.substr(0, at);
        filled += part.value;
        page.remove_prefix(at + part.marker.size());
    }
    filled += page;
    return filled;
}

}  // namespace

std::string make_report(const Comparison& comparison) {
    Json json = comparison_to_json(comparison);
    json["pictures"] = pictures_to_json(comparison);
    const std::string data = script_safe(json);
    // Of the same bytes as the data, so that the title, too, is UTF-8.
    const std::string scene =
        Json::parse(Json(comparison.scene).dump(-1, ' ', false, Json::error_handler_t::replace))
            .get<std::string>();
    const std::string title = html_text(scene);
    const std::array<Part, 5> parts = {{{"{{title}}", title},
                                        {"/*{{style}}*/", text(report::kStyle)},
                                        {"{{data}}", data},
                                        {"/*{{viewer}}*/", text(report::kViewer)},
                                        {"/*{{script}}*/", text(report::kScript)}}};
    return fill_template(text(report::kTemplate), parts);
}

}  // namespace utsuri
