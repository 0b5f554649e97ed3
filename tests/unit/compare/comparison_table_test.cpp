// SPDX-License-Identifier: Apache-2.0
#include "compare/comparison/comparison_table.h"

#include "small_comparison.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace utsuri {
namespace {

using test::small_comparison;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr std::size_t kColumns = 110;

std::vector<std::string> lines(const std::string& text) {
    std::vector<std::string> result;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
        result.push_back(line);
    return result;
}

/// The cells after the name in the n-th row that starts with `name`.
std::vector<std::string> row(const std::string& text, const std::string& name, int n) {
    for (const std::string& line : lines(text)) {
        if (!line.starts_with(name + " ") || n-- > 0) continue;
        std::istringstream stream(line.substr(name.size()));
        std::vector<std::string> cells;
        for (std::string cell; stream >> cell;)
            cells.push_back(cell);
        return cells;
    }
    ADD_FAILURE() << "no row " << name << " in\n" << text;
    return {};
}

TEST(FormatSeconds, ChoosesTheUnit) {
    EXPECT_EQ(format_seconds(0.0), "0 us");
    EXPECT_EQ(format_seconds(830e-6), "830 us");
    EXPECT_EQ(format_seconds(1.234e-3), "1.23 ms");
    EXPECT_EQ(format_seconds(12.34e-3), "12.3 ms");
    EXPECT_EQ(format_seconds(4.561), "4.56 s");
    EXPECT_EQ(format_seconds(45.61), "45.6 s");
    EXPECT_EQ(format_seconds(119.4), "119 s");
    EXPECT_EQ(format_seconds(123.0), "2 min 03 s");
    EXPECT_EQ(format_seconds(3599.7), "60 min 00 s");
}

TEST(FormatSeconds, RoundingCarriesIntoTheNextUnit) {
    EXPECT_EQ(format_seconds(0.9994e-3), "999 us");
    EXPECT_EQ(format_seconds(0.9996e-3), "1.00 ms");
    EXPECT_EQ(format_seconds(9.994e-3), "9.99 ms");
    EXPECT_EQ(format_seconds(9.996e-3), "10.0 ms");
    EXPECT_EQ(format_seconds(99.96e-3), "100 ms");
    EXPECT_EQ(format_seconds(0.9994), "999 ms");
    EXPECT_EQ(format_seconds(0.9996), "1.00 s");
    EXPECT_EQ(format_seconds(119.6), "2 min 00 s");
}

TEST(FormatBytes, ChoosesTheUnit) {
    EXPECT_EQ(format_bytes(0), "0 B");
    EXPECT_EQ(format_bytes(5), "5 B");
    EXPECT_EQ(format_bytes(999), "999 B");
    EXPECT_EQ(format_bytes(1000), "0.98 KiB");
    EXPECT_EQ(format_bytes(1024), "1.00 KiB");
    EXPECT_EQ(format_bytes(1536), "1.50 KiB");
    EXPECT_EQ(format_bytes(9u << 20), "9.00 MiB");
    EXPECT_EQ(format_bytes(std::uint64_t{5} << 30), "5.00 GiB");
    EXPECT_EQ(format_bytes(std::uint64_t{7} << 40), "7.00 TiB");
    EXPECT_EQ(format_bytes(std::uint64_t{2000} << 40), "2000 TiB");  // there is no larger unit
}

TEST(FormatCount, ChoosesTheUnit) {
    EXPECT_EQ(format_count(0.0), "0");
    EXPECT_EQ(format_count(999.0), "999");
    EXPECT_EQ(format_count(1000.0), "1.00 k");
    EXPECT_EQ(format_count(12.34e6), "12.3 M");
    EXPECT_EQ(format_count(999600.0), "1.00 M");
    EXPECT_EQ(format_count(4.5e9), "4.50 G");
    EXPECT_EQ(format_count(4.5e12), "4.50 T");
}

TEST(ComparisonTable, CostOfEveryMethod) {
    const Comparison comparison = small_comparison();
    const std::string text = comparison_table(comparison);
    EXPECT_THAT(row(text, "reference", 0), testing::Contains("96"));
    // samples, prepare, compile, frame, a sample, memory, rays, traced, non-finite
    EXPECT_THAT(row(text, "direct/trace", 0), ElementsAre("4", "250", "ms", "500", "ms", "2.00", "s", "500",
                                                          "ms", "3.00", "MiB", "12.3", "M", "100", "%", "7"));
    for (const MethodResult& result : comparison.methods) {
        EXPECT_EQ(row(text, method_name(result.method), 0).front(), "4");
    }
}

TEST(ComparisonTable, ErrorsOfEveryMethod) {
    const Comparison comparison = small_comparison();
    const std::string text = comparison_table(comparison);
    for (const MethodResult& result : comparison.methods) {
        // relMSE, MAPE, MSE, PSNR, SSIM, FLIP, max, p99.9
        EXPECT_THAT(row(text, method_name(result.method), 1),
                    ElementsAre("10.2", "10.3", "10.1", "10.4", "10.5", "10.6", "10.7", "10.8"));
        EXPECT_THAT(row(text, method_name(result.method), 2),
                    ElementsAre("20.2", "20.3", "20.1", "20.4", "20.5", "20.6", "20.7", "20.8"));
    }
}

TEST(ComparisonTable, FactsAroundTheNumbers) {
    const std::string text = comparison_table(small_comparison());
    for (const char* words : {"rooms/hall.glb", "a device", "a driver 1.2", "38 triangles", "4 x 3 pixels",
                              "2 of them reflective", "followed 6 times", "MSE 0.0009", "3 % of the mean"}) {
        EXPECT_THAT(text, HasSubstr(words));
    }
}

TEST(ComparisonTable, NoReflectivePixelsNoRowsAboutThem) {
    Comparison comparison = small_comparison();
    comparison.reflective_pixels = 0;
    EXPECT_THAT(comparison_table(comparison), Not(HasSubstr("error, reflective pixels")));
    EXPECT_THAT(comparison_table(small_comparison()), HasSubstr("error, reflective pixels"));
}

TEST(ComparisonTable, DisplacementsWhereTold) {
    Comparison comparison = small_comparison();
    EXPECT_THAT(comparison_table(comparison), Not(HasSubstr("off its place")));
    ReflectionErrors& errors = comparison.methods[1].reflection_errors.emplace();
    errors.predicted = Plane(2, 2);
    errors.predicted.values = {-1.0f, 1.0f, 4.0f, std::numeric_limits<float>::infinity()};
    errors.measured = Plane(2, 2);
    errors.measured.values = {-1.0f, 0.25f, 8.0f, 12.5f};
    errors.seconds = 0.75;
    // predicted median and p95, measured median and p95, exceeded, found in; the last group of rows.
    EXPECT_THAT(row(comparison_table(comparison), "direct/polygon-map", 3),
                ElementsAre("4.00", "unknown", "8.00", "12.5", "33.3", "%", "750", "ms"));
}

TEST(ComparisonTable, ValuesThatDoNotExist) {
    Comparison comparison = small_comparison();
    comparison.methods[1].metrics = Metrics{};
    comparison.methods[2].metrics.psnr = std::numeric_limits<double>::infinity();
    const std::string text = comparison_table(comparison);
    EXPECT_THAT(row(text, "direct/polygon-map", 1), ElementsAre("-", "-", "-", "-", "-", "-", "-", "-"));
    EXPECT_EQ(row(text, "direct/sphere-map", 1).at(3), "inf");
}

TEST(ComparisonTable, FitsATerminal) {
    Comparison comparison = small_comparison();
    for (MethodResult& result : comparison.methods) {
        result.samples = 1u << 24;
        result.prepare_seconds = result.compile_seconds = 59.94;
        result.frame_seconds = 99.9 * 60;
        result.rays = std::uint64_t{999} << 40;
        result.metrics = test::distinct_metrics(1.234e-100);
        result.metrics.max = 1.23e+100;
        ReflectionErrors& errors = result.reflection_errors.emplace();
        errors.predicted = errors.measured = Plane(4, 3, 123456.0f);
        errors.seconds = 59.94 * 60;
    }
    for (const std::string& line : lines(comparison_table(comparison)))
        EXPECT_LE(line.size(), kColumns) << line;
}

TEST(ComparisonTable, NothingWasFinished) {
    Comparison comparison = small_comparison();
    comparison.methods.clear();
    comparison.reference.samples = 0;  // the time of a sample is the frame's then, not a division by zero
    EXPECT_THAT(row(comparison_table(comparison), "reference", 0), testing::Contains("0"));
}

TEST(ComparisonTable, SaysWhyAMethodIsMissing) {
    Comparison comparison = small_comparison();
    EXPECT_THAT(comparison_table(comparison), Not(HasSubstr("failed")));
    comparison.failures.push_back({find_method("direct", "sphere-map"), "too large", ExitCode::usage});
    EXPECT_THAT(comparison_table(comparison), HasSubstr("direct/sphere-map failed: too large"));
}

TEST(ComparisonTable, SaysThatNoiseIsUnknown) {
    Comparison comparison = small_comparison();
    EXPECT_THAT(comparison_table(comparison), Not(HasSubstr("not estimated")));
    comparison.reference_noise = comparison.reference_noise_mse = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(comparison_table(comparison), HasSubstr("noise was not estimated"));
    EXPECT_THAT(comparison_table(comparison), Not(HasSubstr("nan")));
}

}  // namespace
}  // namespace utsuri
