// SPDX-License-Identifier: Apache-2.0
#include "compare/comparison/comparison_json.h"

#include "base/version.h"

#include "small_comparison.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>
#include <set>
#include <string>
#include <vector>

namespace utsuri {
namespace {

using Json = nlohmann::ordered_json;
using test::small_comparison;
using testing::IsSupersetOf;

std::set<std::string> keys(const Json& json) {
    std::set<std::string> names;
    for (const auto& [name, value] : json.items())
        names.insert(name);
    return names;
}

const std::vector<std::string> kMetricNames = {"mse",  "rel_mse", "mape", "psnr",
                                               "ssim", "flip",    "max",  "p999"};

TEST(MetricsJson, HoldsEveryValueUnderItsName) {
    const Json json = metrics_to_json(test::distinct_metrics(1.0));
    EXPECT_EQ(json["mse"], 1.1);
    EXPECT_EQ(json["rel_mse"], 1.2);
    EXPECT_EQ(json["mape"], 1.3);
    EXPECT_EQ(json["psnr"], 1.4);
    EXPECT_EQ(json["ssim"], 1.5);
    EXPECT_EQ(json["flip"], 1.6);
    EXPECT_EQ(json["max"], 1.7);
    EXPECT_EQ(json["p999"], 1.8);
    EXPECT_EQ(json["pixels"], 12);
    EXPECT_EQ(json["nonfinite"], 1);
}

TEST(MetricsJson, WhatWasNotMeasuredIsNull) {
    const Json json = metrics_to_json(Metrics{});
    for (const std::string& name : kMetricNames)
        EXPECT_TRUE(json[name].is_null()) << name;
    EXPECT_EQ(json["pixels"], 0);
}

TEST(MetricsJson, WhatIsInfiniteIsNull) {
    Metrics metrics = test::distinct_metrics(0.0);
    metrics.psnr = std::numeric_limits<double>::infinity();
    metrics.max = -std::numeric_limits<double>::infinity();
    const Json json = metrics_to_json(metrics);
    EXPECT_TRUE(json["psnr"].is_null());
    EXPECT_TRUE(json["max"].is_null());
    EXPECT_EQ(json["mse"], 0.1);
}

TEST(ComparisonJson, TopLevel) {
    const Json json = comparison_to_json(small_comparison());
    EXPECT_EQ(json["schema"], kComparisonSchema);
    EXPECT_EQ(json["utsuri"], kVersion);
    EXPECT_EQ(json["scene"], "rooms/hall.glb");
    EXPECT_EQ(json["command"], "utsuri compare rooms/hall.glb");
    EXPECT_EQ(json["device"], Json({{"name", "a device"}, {"driver", "a driver 1.2"}, {"api", "1.3.230"}}));
    EXPECT_EQ(json["width"], 4);
    EXPECT_EQ(json["height"], 3);
    EXPECT_EQ(json["seed"], 5);
    EXPECT_EQ(json["specular_depth"], 6);
    EXPECT_EQ(json["kept_light"], false);
    EXPECT_EQ(json["exposure"], -1.5);
    EXPECT_EQ(json["light"], "direct");
    EXPECT_EQ(json["triangles"], 38);
    EXPECT_EQ(json["scene_bytes"], 4096);
    EXPECT_EQ(json["import_seconds"], 0.75);
    EXPECT_EQ(json["build_seconds"], 0.0625);
    EXPECT_EQ(json["reflective_pixels"], 2);
    EXPECT_EQ(json["interrupted"], false);
    EXPECT_EQ(json["notes"], Json({"one note", "another \"note\""}));
}

TEST(ComparisonJson, ReferenceHasNoiseInsteadOfErrors) {
    const Json reference = comparison_to_json(small_comparison())["reference"];
    EXPECT_EQ(reference["name"], "direct/trace");
    EXPECT_EQ(reference["settings"]["samples"], 96);
    EXPECT_EQ(reference["noise"], 0.03);
    EXPECT_EQ(reference["noise_mse"], 0.0009);
    EXPECT_FALSE(reference.contains("metrics"));
    EXPECT_FALSE(reference.contains("error_map"));
}

TEST(ComparisonJson, MethodsHaveEveryField) {
    const Comparison comparison = small_comparison();
    const Json json = comparison_to_json(comparison);
    ASSERT_EQ(json["methods"].size(), comparison.methods.size());
    for (std::size_t i = 0; i < comparison.methods.size(); ++i) {
        const Json& method = json["methods"][i];
        EXPECT_EQ(method["name"], method_name(comparison.methods[i].method));
        EXPECT_EQ(method["light"], "direct");
        EXPECT_EQ(method["reflection"], comparison.methods[i].method.reflection->name);
        EXPECT_EQ(method["settings"]["samples"], 4);
        EXPECT_EQ(method["prepare_seconds"], 0.25);
        EXPECT_EQ(method["compile_seconds"], 0.5);
        EXPECT_EQ(method["frame_seconds"], 2.0);
        EXPECT_EQ(method["gpu_seconds"], 1.5);
        EXPECT_EQ(method["peak_bytes"], 3 << 20);
        EXPECT_EQ(method["rays"], 12345678);
        EXPECT_EQ(method["prepare_rays"], 99);
        EXPECT_EQ(method["maps"], 12);
        EXPECT_EQ(method["captured_maps"], 5);
        EXPECT_EQ(method["traced_fraction"], i == 0 ? 1.0 : 0.0);
        EXPECT_EQ(method["truncated_fraction"], 0.125);
        EXPECT_EQ(method["nonfinite"], 7);
        EXPECT_EQ(method["image"], "picture.exr");
        EXPECT_EQ(method["error_map"], "error.png");
        EXPECT_EQ(method["metrics"], metrics_to_json(comparison.methods[i].metrics));
        EXPECT_EQ(method["metrics_reflective"], metrics_to_json(comparison.methods[i].metrics_reflective));
        EXPECT_THAT(keys(method["metrics"]), IsSupersetOf(kMetricNames));
    }
}

TEST(ComparisonJson, ErrorsOfReflectionsWhereToldOnly) {
    Comparison comparison = small_comparison();
    ReflectionErrors& errors = comparison.methods[1].reflection_errors.emplace();
    errors.predicted = Plane(2, 2);
    errors.predicted.values = {-1.0f, 1.0f, 4.0f, std::numeric_limits<float>::infinity()};
    errors.measured = Plane(2, 2);
    errors.measured.values = {-1.0f, 2.0f, 0.5f, 8.0f};
    errors.seconds = 0.75;
    errors.predicted_file = "p.png";
    errors.measured_file = "m.png";
    comparison.methods[2].reflection_errors = errors;
    ReflectionErrors& choosing = *comparison.methods[2].reflection_errors;
    choosing.traced = Plane(2, 2);
    choosing.traced.values = {-1.0f, 0.0f, 1.0f, 1.0f};
    choosing.traced_file = "t.png";
    const Json methods = comparison_to_json(comparison)["methods"];
    EXPECT_FALSE(methods[0].contains("reflection_errors"));
    const Json& told = methods[1]["reflection_errors"];
    EXPECT_EQ(told["pixels"], 3);
    EXPECT_EQ(told["seconds"], 0.75);
    EXPECT_EQ(told["predicted"], Json({{"median", 4.0}, {"p95", nullptr}, {"image", "p.png"}}));
    EXPECT_EQ(told["measured"], Json({{"median", 2.0}, {"p95", 8.0}, {"image", "m.png"}}));
    EXPECT_DOUBLE_EQ(told["exceeded"].get<double>(), 1.0 / 3.0);
    EXPECT_FALSE(told.contains("traced"));
    EXPECT_EQ(methods[2]["reflection_errors"]["traced"], Json({{"pixels", 2}, {"image", "t.png"}}));
}

TEST(ComparisonJson, SettingsOfMapsBelongToMethodsThatUseThem) {
    Comparison comparison = small_comparison();
    MapSettings& maps = *comparison.methods[1].maps;
    maps.size = 64;
    maps.samples = 3;
    maps.capture_point = glm::dvec3(0.5, 1.0, -2.0);
    maps.proxy = GivenProxy{"room.txt", {}};
    const Json json = comparison_to_json(comparison);
    EXPECT_EQ(keys(json["methods"][0]["settings"]), std::set<std::string>{"samples"});
    EXPECT_EQ(json["methods"][1]["settings"], Json({{"samples", 4},
                                                    {"map_size", 64},
                                                    {"map_samples", 3},
                                                    {"polyhedron", "cube"},
                                                    {"faces", 6},
                                                    {"most_probes", 1},
                                                    {"proxy", "room.txt"},
                                                    {"capture_point", {0.5, 1.0, -2.0}}}));
    EXPECT_FALSE(json["methods"][2]["settings"].contains("capture_point"));
}

TEST(ComparisonJson, IsWholeWhenInterrupted) {
    Comparison comparison = small_comparison();
    comparison.methods.clear();
    comparison.interrupted = true;
    const Json json = comparison_to_json(comparison);
    EXPECT_EQ(json["interrupted"], true);
    EXPECT_EQ(json["methods"], Json::array());
}

TEST(ComparisonJson, NamesMethodsThatFailed) {
    Comparison comparison = small_comparison();
    EXPECT_EQ(comparison_to_json(comparison)["failed"], Json::array());
    comparison.failures.push_back({find_method("direct", "sphere-map"), "too large", ExitCode::usage});
    EXPECT_EQ(comparison_to_json(comparison)["failed"],
              Json::array({{{"name", "direct/sphere-map"}, {"message", "too large"}}}));
}

TEST(ComparisonJson, UnknownNoiseIsNull) {
    Comparison comparison = small_comparison();
    comparison.reference_noise = comparison.reference_noise_mse = std::numeric_limits<double>::quiet_NaN();
    const Json json = comparison_to_json(comparison);
    EXPECT_TRUE(json["reference"]["noise"].is_null());
    EXPECT_TRUE(json["reference"]["noise_mse"].is_null());
}

TEST(ComparisonJson, IsWhatAParserReadsBack) {
    Comparison comparison = small_comparison();
    comparison.scene = "a \"quoted\" \\ name\n with \xc3\xa9";
    comparison.methods[1].metrics_reflective = Metrics{};
    const Json json = comparison_to_json(comparison);
    EXPECT_EQ(Json::parse(json.dump()), json);
}

}  // namespace
}  // namespace utsuri
