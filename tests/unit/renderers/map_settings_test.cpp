// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/maps/map_settings.h"

#include "base/error.h"
#include "geometry/half_space.h"

#include "interop/reflection.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace utsuri {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// What is wrong with settings after something was done to those that are there by default.
template <typename Spoil>
std::string error_after(const Spoil& spoil) {
    MapSettings settings;
    spoil(settings);
    try {
        check_map_settings(settings);
    } catch (const UsageError& error) {
        return error.what();
    }
    return {};
}

std::string error_with_tolerance(const Tolerance& tolerance) {
    return error_after([&](MapSettings& s) { s.tolerance = tolerance; });
}

/// [0, 2] x [0, 2] x [0, 2].
std::vector<HalfSpace> box() {
    return {{{1, 0, 0}, 2},  {{-1, 0, 0}, 0}, {{0, 1, 0}, 2},
            {{0, -1, 0}, 0}, {{0, 0, 1}, 2},  {{0, 0, -1}, 0}};
}

template <typename Spoil>
std::string error_with_proxy(const Spoil& spoil) {
    return error_after([&](MapSettings& s) {
        s.proxy = GivenProxy{"box", box()};
        spoil(s.proxy->planes);
    });
}

TEST(CheckMapSettings, PassesWhereNothingWasChanged) {
    EXPECT_THAT(error_after([](MapSettings&) {}), IsEmpty());
}

TEST(CheckMapSettings, BoundsSizesSamplesAndProbes) {
    const auto error_with = [](std::uint32_t MapSettings::*member, std::uint32_t value) {
        return error_after([&](MapSettings& s) { s.*member = value; });
    };
    struct Range {
        std::uint32_t MapSettings::*member;
        std::uint32_t most;
        const char* name;
    };
    for (const Range& range : {Range{&MapSettings::size, kLargestMapSize, "size"},
                               Range{&MapSettings::samples, kMostMapSamples, "samples"},
                               Range{&MapSettings::most_probes, kMostProbes, "most_probes"}}) {
        EXPECT_THAT(error_with(range.member, 1), IsEmpty());
        EXPECT_THAT(error_with(range.member, range.most), IsEmpty());
        for (const std::uint32_t bad : {0u, range.most + 1}) {
            EXPECT_EQ(error_with(range.member, bad), "use map settings " + std::string(range.name) + ": is " +
                                                         std::to_string(bad) + "; must be from 1 to " +
                                                         std::to_string(range.most));
        }
    }
    EXPECT_THAT(error_after([](MapSettings& s) { s.most_cut_pieces = 0; }), HasSubstr("most_cut_pieces"));
    EXPECT_THAT(error_after([](MapSettings& s) { s.most_cut_pieces = 1; }), IsEmpty());
    EXPECT_THAT(error_after([](MapSettings& s) { s.capture_point = glm::dvec3(0.0, kNan, 0.0); }),
                HasSubstr("capture_point"));
}

TEST(CheckMapSettings, BoundsTolerances) {
    using Of = Tolerance::Of;
    for (const double good : {0.0, 1.0, kMostPlaceTolerance})
        EXPECT_THAT(error_with_tolerance({Of::place, good}), IsEmpty());
    for (const double bad : {-1.0, 1.01 * kMostPlaceTolerance, kNan})
        EXPECT_THAT(error_with_tolerance({Of::place, bad}), HasSubstr("must be pixels from 0 to 1e+06"));
    for (const double good : {kLeastRadianceTolerance, kMostRadianceTolerance})
        EXPECT_THAT(error_with_tolerance({Of::radiance, good}), IsEmpty());
    for (const double bad : {0.0, 0.99 * kLeastRadianceTolerance, 1.01 * kMostRadianceTolerance, kNan})
        EXPECT_THAT(error_with_tolerance({Of::radiance, bad}),
                    HasSubstr("a share of the radiance from 0.0001 to 1"));
}

TEST(CheckMapSettings, BoundsRefinement) {
    for (const double bad : {0.0, -1.0, kNan}) {
        EXPECT_THAT(error_after([&](MapSettings& s) { s.refinement.edge = bad; }),
                    HasSubstr("refinement.edge"));
        EXPECT_THAT(error_after([&](MapSettings& s) { s.refinement.error = bad; }),
                    HasSubstr("refinement.error"));
    }
    EXPECT_THAT(error_after([](MapSettings& s) { s.refinement.edge = 0.125; }), IsEmpty());
}

TEST(CheckMapSettings, NeedsAPolyhedronThatIsClosed) {
    const auto error_with = [](const auto& spoil) {
        return error_after([&](MapSettings& s) { spoil(s.polyhedron.planes); });
    };
    for (const char* name : {"tetrahedron", "octahedron", "dodecahedron", "icosahedron"}) {
        EXPECT_THAT(error_after([&](MapSettings& s) { s.polyhedron = platonic_solid(name); }), IsEmpty());
    }
    EXPECT_EQ(error_with([](auto& planes) { planes.clear(); }),
              "use map settings polyhedron: has 0 planes; must have 4 to 32");
    EXPECT_THAT(error_with([](auto& planes) { planes.resize(interop::MAP_MOST_FACES + 1, planes[0]); }),
                HasSubstr("has 33 planes"));
    EXPECT_THAT(error_with([](auto& planes) { planes[1].normal *= 2.0; }),
                HasSubstr("polyhedron.planes[1].normal: has length 2; must be a unit vector"));
    EXPECT_THAT(error_with([](auto& planes) { planes[2].distance = 0.0; }),
                HasSubstr("polyhedron.planes[2].distance: is 0; must be above 0"));
    EXPECT_THAT(error_with([](auto& planes) { planes[2].distance = kInfinity; }),
                HasSubstr("polyhedron.planes[2]: is not at a finite distance"));
    EXPECT_THAT(error_with([](auto& planes) { planes.pop_back(); }), HasSubstr("bounds no face"));
    EXPECT_THAT(error_with([](auto& planes) { planes.push_back(planes[0]); }), HasSubstr("bounds no face"));
}

TEST(CheckMapSettings, NeedsAProxyThatIsClosed) {
    EXPECT_THAT(error_with_proxy([](auto&) {}), IsEmpty());
    EXPECT_THAT(error_with_proxy([](auto& planes) { planes.resize(3); }),
                HasSubstr("proxy: has 3 planes; must have 4 to 32"));
    EXPECT_THAT(error_with_proxy([](auto& planes) { planes.resize(interop::MAP_MOST_FACES + 1, planes[0]); }),
                HasSubstr("has 33 planes"));
    EXPECT_THAT(error_with_proxy([](auto& planes) { planes[3].normal.y = kNan; }),
                HasSubstr("proxy.planes[3].normal"));
    EXPECT_THAT(error_with_proxy([](auto& planes) { planes[3].offset = kInfinity; }),
                HasSubstr("proxy.planes[3]: is not at a finite distance"));
    EXPECT_THAT(error_with_proxy([](auto& planes) { planes.pop_back(); }),
                HasSubstr("its planes enclose nothing"));
    EXPECT_EQ(error_with_proxy([](auto& planes) {
                  planes.push_back({{1, 0, 0}, 3});
              }),
              "use map settings proxy.planes[6]: bounds no face; each must touch the polyhedron that all "
              "enclose, once");
}

}  // namespace
}  // namespace utsuri
