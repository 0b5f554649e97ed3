// SPDX-License-Identifier: Apache-2.0
#include "compare/report.h"

#include "compare/comparison_json.h"
#include "compare/html_page.h"
#include "compare/page_files.h"

#include "image/error_map.h"
#include "image_io/image_io.h"

#include <nlohmann/json.hpp>

#include <array>
#include <utility>

namespace utsuri {
namespace {

using Json = nlohmann::ordered_json;

/// Columns of the picture of the colour scale; more than its width on the page.
constexpr std::uint32_t kScaleColumns = 512;

Json picture(const Image& image, double stops) {
    return image.pixels.empty() ? Json(nullptr) : Json(data_uri("image/png", encode_png(image, stops)));
}

Json coded_picture(const Plane& errors) {
    return errors.values.empty() ? Json(nullptr)
                                 : Json(data_uri("image/png", encode_png_coded(error_map(errors))));
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

}  // namespace

std::string make_report(const Comparison& comparison) {
    Json json = comparison_to_json(comparison);
    json["pictures"] = pictures_to_json(comparison);
    const std::string data = script_safe(json);
    const std::string title = html_text(valid_utf8(comparison.scene));
    const std::array<Part, 7> parts = {{{"{{title}}", title},
                                        {"/*{{page style}}*/", file_text(page_files::kPageStyle)},
                                        {"/*{{style}}*/", file_text(page_files::kReportStyle)},
                                        {"{{data}}", data},
                                        {"/*{{page script}}*/", file_text(page_files::kPageScript)},
                                        {"/*{{viewer}}*/", file_text(page_files::kReportViewer)},
                                        {"/*{{script}}*/", file_text(page_files::kReportScript)}}};
    return fill_template(file_text(page_files::kReportTemplate), parts);
}

}  // namespace utsuri
