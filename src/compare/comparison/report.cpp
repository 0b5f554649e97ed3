// SPDX-License-Identifier: Apache-2.0
#include "compare/comparison/report.h"

#include "compare/comparison/comparison_json.h"
#include "compare/comparison/reflection_pictures.h"
#include "compare/page/html_page.h"
#include "compare/page/json_text.h"
#include "compare/page/page_files.h"

#include "image/error_map.h"
#include "image_io/image_io.h"

#include <fmt/format.h>
#include <glm/common.hpp>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <utility>

namespace utsuri {
namespace {

using Json = nlohmann::ordered_json;

/// Columns of the picture of the colour scale; more than its width on the page.
constexpr std::uint32_t kScaleColumns = 512;

Json picture(const Image& image, double stops) {
    return image.pixels.empty() ? Json(nullptr) : Json(data_uri("image/png", encode_png(image, stops)));
}

Json coded_picture(const Image& image) {
    return image.pixels.empty() ? Json(nullptr) : Json(data_uri("image/png", encode_png_coded(image)));
}

/// A row of values at shares of the scale from 0 to 1, left to right.
template <typename ValueAt>
Plane scale_row(ValueAt value_at) {
    Plane scale(kScaleColumns, 1);
    for (std::uint32_t x = 0; x < kScaleColumns; ++x)
        scale.at(x, 0) = value_at(static_cast<float>(x) / static_cast<float>(kScaleColumns - 1));
    return scale;
}

/// A display coded colour as in style sheets.
std::string css_colour(const glm::vec3& colour) {
    const glm::vec3 bytes = glm::round(255.0f * colour);
    return fmt::format("rgb({:g} {:g} {:g})", bytes.x, bytes.y, bytes.z);
}

Json pictures_of(const MethodResult& result, double stops) {
    Json json = {{"image", picture(result.image, stops)},
                 {"error_map", coded_picture(error_map(result.flip))}};
    if (!result.reflection_errors) return json;
    const ReflectionErrors& errors = *result.reflection_errors;
    json["predicted"] = coded_picture(displacement_picture(errors.predicted));
    json["measured"] = coded_picture(displacement_picture(errors.measured));
    json["traced"] = coded_picture(traced_picture(errors.traced));
    return json;
}

Json displacement_scale() {
    const Plane row = scale_row([](float share) {
        return kLeastDisplacement * std::pow(kMostDisplacement / kLeastDisplacement, share);
    });
    return {{"image", coded_picture(displacement_picture(row))},
            {"least", kLeastDisplacement},
            {"most", kMostDisplacement}};
}

Json pictures_to_json(const Comparison& comparison) {
    Json methods = Json::array();
    for (const MethodResult& result : comparison.methods)
        methods.push_back(pictures_of(result, comparison.exposure));
    return {{"reference", picture(comparison.reference.image, comparison.exposure)},
            {"methods", std::move(methods)},
            {"error_scale", coded_picture(error_map(scale_row([](float share) { return share; })))},
            {"displacement_scale", displacement_scale()},
            {"colours",
             {{"traced", css_colour(traced_colour())},
              {"looked_up", css_colour(looked_up_colour())},
              {"left_out", css_colour(kLeftOutColour)}}}};
}

}  // namespace

std::string make_report(const Comparison& comparison) {
    Json json = comparison_to_json(comparison);
    json["pictures"] = pictures_to_json(comparison);
    const std::string data = script_safe(json);
    const std::string title = html_text(valid_utf8(comparison.scene));
    const std::array<Part, 8> parts = {{{"{{title}}", title},
                                        {"/*{{page style}}*/", file_text(page_files::kPageStyle)},
                                        {"/*{{style}}*/", file_text(page_files::kReportStyle)},
                                        {"{{data}}", data},
                                        {"/*{{page script}}*/", file_text(page_files::kPageScript)},
                                        {"/*{{viewer}}*/", file_text(page_files::kReportViewer)},
                                        {"/*{{maps}}*/", file_text(page_files::kReportMaps)},
                                        {"/*{{script}}*/", file_text(page_files::kReportScript)}}};
    return fill_template(file_text(page_files::kReportTemplate), parts);
}

}  // namespace utsuri
