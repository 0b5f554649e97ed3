// SPDX-License-Identifier: Apache-2.0
#include "renderers/methods/method.h"

#include "base/error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

namespace utsuri {
namespace {

using testing::HasSubstr;

template <typename Function>
std::string usage_error(Function&& function) {
    try {
        function();
    } catch (const UsageError& error) {
        EXPECT_EQ(error.exit_code(), ExitCode::usage);
        return error.what();
    }
    ADD_FAILURE() << "no UsageError";
    return {};
}

TEST(Method, NamesParseBack) {
    for (const Method& method : all_methods(LightMethod::direct)) {
        EXPECT_EQ(parse_reflection(to_string(method.reflection)), method.reflection);
        EXPECT_EQ(parse_light(to_string(method.light)), method.light);
    }
}

TEST(Method, NameIsLightAndReflection) {
    EXPECT_EQ(method_name({LightMethod::direct, ReflectionMethod::trace}), "direct/trace");
    EXPECT_EQ(method_name({LightMethod::direct, ReflectionMethod::polygon_map}), "direct/polygon-map");
    EXPECT_EQ(method_name({LightMethod::direct, ReflectionMethod::sphere_map}), "direct/sphere-map");
}

TEST(Method, AllMethodsAreDistinctAndTracingComesFirst) {
    const std::vector<Method> methods = all_methods(LightMethod::direct);
    std::set<std::string> names;
    for (const Method& method : methods)
        names.insert(method_name(method));
    EXPECT_EQ(names.size(), methods.size());
    EXPECT_EQ(methods.front().reflection, ReflectionMethod::trace);
}

TEST(Method, OnlyTracingNeedsNoMaps) {
    for (const Method& method : all_methods(LightMethod::direct)) {
        EXPECT_EQ(uses_maps(method), method.reflection != ReflectionMethod::trace);
    }
}

TEST(Method, UnknownReflectionListsTheNames) {
    for (const char* name : {"", "Trace", "trace ", "polygon_map", "direct/trace"}) {
        const std::string text = usage_error([&] { static_cast<void>(parse_reflection(name)); });
        EXPECT_THAT(text, HasSubstr("'" + std::string(name) + "'"));
        for (const Method& method : all_methods(LightMethod::direct)) {
            EXPECT_THAT(text, HasSubstr(std::string(to_string(method.reflection))));
        }
    }
}

TEST(Method, UnknownLightListsTheNames) {
    const std::string text = usage_error([] { static_cast<void>(parse_light("candle")); });
    EXPECT_THAT(text, HasSubstr("'candle'"));
    EXPECT_THAT(text, HasSubstr("direct"));
}

}  // namespace
}  // namespace utsuri
