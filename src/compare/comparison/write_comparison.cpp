// SPDX-License-Identifier: Apache-2.0
#include "compare/comparison/write_comparison.h"

#include "compare/comparison/comparison_json.h"
#include "compare/comparison/reflection_pictures.h"
#include "compare/comparison/report.h"
#include "compare/page/json_text.h"

#include "base/file.h"
#include "base/version.h"
#include "image/error_map.h"
#include "image_io/image_io.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace utsuri {
namespace {

void write_pictures(const MethodResult& result, const Comparison& comparison,
                    const std::filesystem::path& folder) {
    const ImageMetadata metadata = {{"Software", fmt::format("utsuri {}", kVersion)},
                                    {"utsuri:method", method_name(result.method)},
                                    {"utsuri:samples", fmt::format("{}", result.samples)},
                                    {"utsuri:scene", comparison.scene}};
    const std::filesystem::path exr = folder / result.image_file;
    write_exr(exr, result.image, ExrPrecision::single, metadata);
    write_png(std::filesystem::path(exr).replace_extension(".png"), result.image, comparison.exposure);
    if (!result.error_map_file.empty())
        write_png_coded(folder / result.error_map_file, error_map(result.flip));
    if (!result.reflection_errors) return;
    const ReflectionErrors& errors = *result.reflection_errors;
    write_png_coded(folder / errors.predicted_file, displacement_picture(errors.predicted));
    write_png_coded(folder / errors.measured_file, displacement_picture(errors.measured));
    if (!errors.traced_file.empty())
        write_png_coded(folder / errors.traced_file, traced_picture(errors.traced));
}

}  // namespace

void write_comparison(const Comparison& comparison, const std::filesystem::path& folder) {
    write_pictures(comparison.reference, comparison, folder);
    for (const MethodResult& result : comparison.methods)
        write_pictures(result, comparison, folder);
    write_text_atomically(folder / "compare.json", json_text(comparison_to_json(comparison), 2) + "\n");
    write_text_atomically(folder / "report.html", make_report(comparison));
}

}  // namespace utsuri
