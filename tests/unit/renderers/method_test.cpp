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
    for (const LightMethod& light : light_methods()) {
        for (const Method& method : all_methods(light))
            EXPECT_EQ(find_method(method.light->name, method.reflection->name), method);
    }
}

TEST(Method, NameIsLightAndReflection) {
    EXPECT_EQ(method_name(find_method("direct", "trace")), "direct/trace");
    EXPECT_EQ(method_name(find_method("direct", "polygon-map")), "direct/polygon-map");
    EXPECT_EQ(method_name(find_method("direct", "sphere-map")), "direct/sphere-map");
}

TEST(Method, AllMethodsAreDistinctAndTracingComesFirst) {
    const std::vector<Method> methods = all_methods(light_methods().front());
    std::set<std::string> names;
    for (const Method& method : methods)
        names.insert(method_name(method));
    EXPECT_EQ(names.size(), methods.size());
    EXPECT_EQ(methods.front(), find_method("direct", "trace"));
}

TEST(Method, OnlyTracingNeedsNoMaps) {
    for (const Method& method : all_methods(light_methods().front())) {
        EXPECT_EQ(method.reflection->traits.looks_up_maps, method.reflection->name != "trace");
    }
}

TEST(Method, HelpListsEveryNameWithWhatItMeans) {
    for (const ReflectionMethod& reflection : reflection_methods()) {
        EXPECT_FALSE(reflection.summary.empty()) << reflection.name;
        const std::string entry = std::string(reflection.name) + " (" + std::string(reflection.summary) + ")";
        EXPECT_THAT(list_reflections(), HasSubstr(entry));
    }
    for (const LightMethod& light : light_methods()) {
        EXPECT_FALSE(light.summary.empty()) << light.name;
        EXPECT_THAT(list_lights(), HasSubstr(std::string(light.name) + " ("));
    }
}

TEST(Method, UnknownReflectionListsTheNames) {
    for (const char* name : {"", "Trace", "trace ", "polygon_map", "direct/trace"}) {
        const std::string text = usage_error([&] { static_cast<void>(find_reflection(name)); });
        EXPECT_THAT(text, HasSubstr("'" + std::string(name) + "'"));
        for (const Method& method : all_methods(light_methods().front())) {
            EXPECT_THAT(text, HasSubstr(std::string(method.reflection->name)));
        }
    }
}

TEST(Method, UnknownLightListsTheNames) {
    const std::string text = usage_error([] { static_cast<void>(find_light("candle")); });
    EXPECT_THAT(text, HasSubstr("'candle'"));
    EXPECT_THAT(text, HasSubstr("direct"));
}

}  // namespace
}  // namespace utsuri
