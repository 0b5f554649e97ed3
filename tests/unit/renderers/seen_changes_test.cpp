// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/maps/seen_changes.h"

#include "support/scenes.h"

#include "geometry/polyhedron.h"

#include "interop/reflection.h"

#include <glm/ext/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace utsuri::test {
namespace {

constexpr std::uint32_t kNone = interop::NONE;
constexpr std::uint32_t kPlusX = 0;
constexpr std::uint32_t kMinusX = 1;
constexpr std::uint32_t kPlusY = 2;
constexpr std::uint32_t kMinusZ = 5;

interop::BvhTriangle small_triangle_at(const glm::vec3& place) {
    return {place, place + glm::vec3(0.01f, 0, 0), place + glm::vec3(0, 0.01f, 0.01f)};
}

TEST(ViewPyramid, HoldsWhatProjectsIntoItsPicture) {
    const interop::CameraInfo camera{{1, 2, 3}, {0.5f, 0, 0}, {0, 0.25f, 0}, {0, 0, -1}};
    const ViewPyramid view(camera);
    const auto shows = [&](const glm::vec3& from_eye) {
        return view.may_show(small_triangle_at(glm::vec3(1, 2, 3) + from_eye));
    };
    EXPECT_TRUE(shows({0, 0, -4}));
    EXPECT_FALSE(shows({0, 0, 4}));
    EXPECT_TRUE(shows({1.95f, 0, -4}));
    EXPECT_FALSE(shows({2.05f, 0, -4}));
    EXPECT_FALSE(shows({-2.05f, 0, -4}));
    EXPECT_TRUE(shows({0, 0.95f, -4}));
    EXPECT_FALSE(shows({0, 1.05f, -4}));
    EXPECT_FALSE(shows({0, -1.05f, -4}));
}

TEST(ViewPyramid, HoldsWhatReachesAcrossIt) {
    const ViewPyramid view(glm::dvec3(0.0), kMinusZ, 0.0);
    EXPECT_TRUE(view.may_show({{-9, 0, -1}, {9, 0, -1}, {0, 9, -1}})) << "all corners outside";
    EXPECT_TRUE(view.may_show({{-9, -9, 1}, {9, -9, 1}, {0, 9, -9}})) << "around the apex";
    EXPECT_FALSE(view.may_show({{2, -9, -1}, {2, 9, -1}, {9, 0, -1}})) << "all beyond one side";
}

TEST(ViewPyramid, OfAFaceIsThatOfTheCube) {
    const auto seen = [](const glm::vec3& place, double wider) {
        std::vector<std::uint32_t> faces;
        for (std::uint32_t face = 0; face < interop::CUBE_FACES; ++face) {
            if (ViewPyramid(glm::dvec3(0.0), face, wider).may_show(small_triangle_at(place)))
                faces.push_back(face);
        }
        return faces;
    };
    EXPECT_EQ(seen({5, 1, 1}, 0.0), std::vector{kPlusX});
    EXPECT_EQ(seen({-5, 1, 1}, 0.0), std::vector{kMinusX});
    EXPECT_EQ(seen({1, 5, 1}, 0.0), std::vector{kPlusY});
    EXPECT_EQ(seen({1, 1, -5}, 0.0), std::vector{kMinusZ});
    EXPECT_EQ(seen({5, 4.8f, 1}, 0.0), std::vector{kPlusX});
    EXPECT_EQ(seen({5, 4.8f, 1}, 0.1), (std::vector{kPlusX, kPlusY})) << "with borders";
}

TEST(ViewPyramid, HoldsThePicturesOfAllFacesOfPolyhedra) {
    for (const char* name : {"tetrahedron", "cube", "octahedron", "dodecahedron", "icosahedron"}) {
        const Polyhedron polyhedron = platonic_solid(name);
        for (std::size_t face = 0; face < polyhedron.planes.size(); ++face) {
            const FacePicture picture = face_picture(polyhedron, face);
            const ViewPyramid view(interop::CameraInfo{glm::vec3(0.0f), glm::vec3(picture.right),
                                                       glm::vec3(picture.up), glm::vec3(picture.centre)});
            const auto shows = [&](double x, double y) {
                const glm::vec3 place(20.0 * (picture.centre + x * picture.right + y * picture.up));
                return view.may_show(small_triangle_at(place));
            };
            for (const double x : {-0.98, 0.0, 0.98}) {
                for (const double y : {-0.98, 0.0, 0.98})
                    EXPECT_TRUE(shows(x, y)) << name << ' ' << face << ": " << x << ", " << y;
                for (const double beyond : {-1.02, 1.02}) {
                    EXPECT_FALSE(shows(x, beyond)) << name << ' ' << face;
                    EXPECT_FALSE(shows(beyond, x)) << name << ' ' << face;
                }
            }
        }
    }
}

// A rounding of float32 does not put a triangle beyond a side.
TEST(ViewPyramid, LeavesRoomForRounding) {
    const ViewPyramid view(glm::dvec3(0.0), kMinusZ, 0.0);
    const float beside = std::nextafter(7.0f, 8.0f);
    EXPECT_TRUE(view.may_show({{beside, 0, -7}, {9, 0, -7}, {9, 1, -7}}));
}

TEST(ViewPyramid, HoldsBoxesThatReachIntoIt) {
    const ViewPyramid view(glm::dvec3(0.0), kMinusZ, 0.0);
    EXPECT_TRUE(view.may_show(Bounds{{-9, -9, -9}, {9, 9, 9}})) << "about the apex";
    EXPECT_TRUE(view.may_show(Bounds{{-9, -9, -2}, {9, 9, -1}})) << "all corners outside";
    EXPECT_TRUE(view.may_show(Bounds{{0.9f, 0, -1}, {2, 1, 0}})) << "by a corner";
    EXPECT_FALSE(view.may_show(Bounds{{2, -9, -1}, {9, 9, 9}})) << "all beyond one side";
    EXPECT_FALSE(view.may_show(Bounds{{-0.9f, -0.9f, 1}, {0.9f, 0.9f, 9}})) << "behind the apex";
    EXPECT_FALSE(view.may_show(Bounds())) << "nothing in it";
}

/// A plate on +x and one on +y of the origin, of which a mirror or none is made.
class SeenChangesOf : public testing::Test {
  protected:
    void make(const Material& of_plate_on_y) {
        add(scene_, quad({5, 0, 0}, {0, 1, 0}, {0, 0, 1}), lambert(glm::vec3(0.5f)));
        add(scene_, quad({0, 5, 0}, {1, 0, 0}, {0, 0, 1}), of_plate_on_y);
        data_ = prepare_scene_data(scene_);
    }

    ViewPyramid face(std::uint32_t index) const { return {-data_.origin, index, 0.0}; }

    Scene scene_;
    SceneData data_;
};

TEST_F(SeenChangesOf, WhatMovedAreThoseOfItsPlaceBeforeAndAfter) {
    make(lambert(glm::vec3(0.5f)));
    scene_.instances[0].world_from_object = glm::translate(glm::dmat4(1.0), glm::dvec3(-10, 0, 0));
    const SceneChange change = update_scene_data(data_, scene_);
    const SeenChanges seen(data_, change, {});
    EXPECT_TRUE(seen.surfaces_may_change_in(face(kPlusX), kNone));
    EXPECT_TRUE(seen.surfaces_may_change_in(face(kMinusX), kNone));
    EXPECT_FALSE(seen.surfaces_may_change_in(face(kPlusY), kNone));
    EXPECT_FALSE(seen.surfaces_may_change_in(face(kPlusX), 0)) << "a view that leaves the instance out";
    EXPECT_FALSE(seen.appearance_may_change_in(face(kPlusY), kNone));
}

TEST_F(SeenChangesOf, LightAreThoseOfTheSurfacesItFallsOn) {
    make(lambert(glm::vec3(0.5f)));
    const SceneChange change = update_scene_data(data_, scene_);
    std::vector<std::uint32_t> lit;
    for (std::uint32_t t = 0; t < data_.triangle_infos.size(); ++t) {
        if (data_.triangle_infos[t].instance == 1) lit.push_back(t);
    }
    const SeenChanges seen(data_, change, lit);
    EXPECT_TRUE(seen.appearance_may_change_in(face(kPlusY), kNone));
    EXPECT_FALSE(seen.appearance_may_change_in(face(kPlusX), kNone));
    EXPECT_FALSE(seen.surfaces_may_change_in(face(kPlusY), kNone));
}

// Boxes only save tests of triangles: what they tell together is what the triangles tell.
TEST_F(SeenChangesOf, ManyInstancesAreThoseOfTheirTriangles) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> place(-4.0f, 4.0f);
    const auto somewhere = [&] { return glm::vec3(place(random), place(random), place(random)); };
    for (int i = 0; i < 40; ++i)
        add(scene_, icosphere(somewhere(), 0.4f, 1), i % 8 == 0 ? mirror() : lambert(glm::vec3(0.5f)));
    data_ = prepare_scene_data(scene_);
    for (std::size_t i = 0; i < 40; i += 3)
        scene_.instances[i].world_from_object = glm::translate(glm::dmat4(1.0), glm::dvec3(0.5, 0.25, 0));
    const SceneChange change = update_scene_data(data_, scene_);
    ASSERT_FALSE(change.rebuilt) << change.reason;
    std::vector<std::uint32_t> lit;
    for (std::uint32_t t = 0; t < data_.triangle_infos.size(); t += 97)
        lit.push_back(t);
    const SeenChanges seen(data_, change, lit);
    for (std::uint32_t i = 0; i < 40; ++i)
        EXPECT_EQ(seen.has_moved(i), i % 3 == 0) << i;

    int touched = 0;
    for (int i = 0; i < 300; ++i) {
        const ViewPyramid view(interop::CameraInfo{somewhere(), {0.1f, 0, 0}, {0, 0.1f, 0}, {0, 0, -1}});
        const std::uint32_t without = i % 2 == 0 ? kNone : static_cast<std::uint32_t>(i % 40);
        const auto shows = [&](std::uint32_t triangle, const interop::BvhTriangle& where) {
            return data_.triangle_infos[triangle].instance != without && view.may_show(where);
        };
        bool surfaces = false;
        for (std::size_t c = 0; c < change.triangles.size(); ++c) {
            const std::uint32_t triangle = change.triangles[c];
            surfaces |= shows(triangle, change.before[c]) || shows(triangle, data_.bvh.triangles[triangle]);
        }
        bool appearance = surfaces;
        for (const std::uint32_t triangle : lit)
            appearance |= shows(triangle, data_.bvh.triangles[triangle]);
        for (std::uint32_t t = 0; t < data_.triangle_infos.size(); ++t)
            appearance |= data_.triangle_infos[t].instance % 8 == 0 && shows(t, data_.bvh.triangles[t]);
        EXPECT_EQ(seen.surfaces_may_change_in(view, without), surfaces) << "view " << i;
        EXPECT_EQ(seen.appearance_may_change_in(view, without), appearance) << "view " << i;
        touched += surfaces ? 1 : 0;
    }
    EXPECT_GT(touched, 0);
    EXPECT_LT(touched, 300) << "views of both kinds";
}

TEST_F(SeenChangesOf, AnythingAreThoseOfMirrors) {
    make(mirror());
    scene_.materials[0].base_colour = {1, 0, 0};
    const SceneChange change = update_scene_data(data_, scene_);
    const SeenChanges seen(data_, change, {});
    EXPECT_TRUE(seen.appearance_may_change_in(face(kPlusX), kNone));
    EXPECT_TRUE(seen.appearance_may_change_in(face(kPlusY), kNone)) << "the mirror may show the plate";
    EXPECT_FALSE(seen.appearance_may_change_in(face(kPlusY), 1));
    EXPECT_FALSE(seen.surfaces_may_change_in(face(kPlusY), kNone)) << "but it is where it was";
}

}  // namespace
}  // namespace utsuri::test
