// SPDX-License-Identifier: Apache-2.0
#include "session/session.h"

#include "support/methods.h"
#include "support/scenes.h"

#include "base/error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

namespace utsuri::test {
namespace {

using testing::Each;
using testing::HasSubstr;
using testing::IsEmpty;
using Kind = SceneUpdate::Kind;

std::string environment(const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr ? value : "";
}

SessionSettings session_settings() {
    SessionSettings settings;
    settings.device = environment("UTSURI_DEVICE");
    if (environment("UTSURI_VALIDATION") == "1") settings.validation = Validation::on;
    settings.light = evenly_kept(1.0 / 30.0, 1, 0);
    return settings;
}

/// A matt floor and a point light above it.
Scene lit_floor() {
    Scene scene;
    add(scene, quad({-2, 0, 2}, {4, 0, 0}, {0, 0, -4}), lambert(glm::vec3(0.5f)));
    Light light;
    light.position = {0, 2, 0};
    light.intensity = glm::vec3(4.0f);
    scene.lights.push_back(light);
    return scene;
}

Camera camera() {
    return look_at({0, 2, 3}, {0, 0, 0});
}

/// Asks to stop from the start, or never, and takes down what it is told.
class Listener : public Progress {
  public:
    explicit Listener(bool stops) : stops_(stops) {}
    void begin(const std::string& /*stage*/) override { ++begun; }
    void update(double /*done*/, double total) override { totals.push_back(total); }
    [[nodiscard]] bool cancelled() const override { return stops_; }

    int begun = 0;
    std::vector<double> totals;

  private:
    bool stops_;
};

class SessionTest : public testing::Test {
  protected:
    void TearDown() override { EXPECT_THAT(session_.take_validation_messages(), IsEmpty()); }

    /// @param kept_light whether the picture reads the light kept on surfaces
    Picture traced(bool kept_light) {
        PictureSettings settings;
        settings.method = find_method("direct", "trace");
        settings.camera = camera();
        settings.render.width = 16;
        settings.render.height = 12;
        settings.render.kept_light = kept_light;
        return session_.make_picture(settings);
    }

    template <typename Call>
    static std::string usage_error(const Call& call) {
        try {
            call();
        } catch (const UsageError& error) {
            return error.what();
        }
        return {};
    }

    Session session_{session_settings()};
};

TEST_F(SessionTest, TellsWhatItDidWithAScene) {
    Scene scene = lit_floor();
    SceneUpdate update = session_.set_scene(scene);
    EXPECT_EQ(update.kind, Kind::rebuilt);
    EXPECT_EQ(update.reason, "there was no scene before it");
    update = session_.set_scene(scene);
    EXPECT_EQ(update.kind, Kind::unchanged);
    EXPECT_THAT(update.reason, IsEmpty());
    scene.materials[0].base_colour = glm::vec3(0.25f);
    update = session_.set_scene(scene);
    EXPECT_EQ(update.kind, Kind::updated);
    EXPECT_THAT(update.reason, IsEmpty());
    scene.lights.push_back(scene.lights[0]);
    update = session_.set_scene(scene);
    EXPECT_EQ(update.kind, Kind::rebuilt);
    EXPECT_EQ(update.reason, "it now has 2 lights that shine where it had 1");
    scene.lights.pop_back();
    EXPECT_EQ(session_.set_scene(scene).reason, "it now has 1 light that shines where it had 2");
}

TEST_F(SessionTest, KeepsItsSceneWhereTheNextIsNotValid) {
    const Scene good = lit_floor();
    session_.set_scene(good);
    Picture picture = traced(false);
    picture.add_samples(2);
    const std::vector<glm::vec3> before = picture.image().pixels;
    Scene bad = good;
    bad.materials[0].base_colour = glm::vec3(0.25f);
    bad.meshes[0].normals.clear();
    try {
        session_.set_scene(bad);
        ADD_FAILURE() << "took a mesh without normals";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("use scene meshes[0].normals"));
    }
    EXPECT_EQ(picture.samples(), 2u);
    EXPECT_EQ(picture.image().pixels, before);
    EXPECT_EQ(session_.scene().materials[0].base_colour, glm::vec3(0.5f));
    EXPECT_EQ(session_.set_scene(good).kind, Kind::unchanged);
    picture.add_samples(2);
    EXPECT_EQ(picture.samples(), 4u);
}

TEST_F(SessionTest, HasNoSceneBeforeItIsGivenAValidOne) {
    Scene bad = lit_floor();
    bad.instances[0].mesh = 1;
    EXPECT_THROW(session_.set_scene(bad), InputError);
    EXPECT_THAT(usage_error([&] { static_cast<void>(session_.scene()); }), HasSubstr("without a scene"));
    EXPECT_THAT(usage_error([&] { static_cast<void>(traced(false)); }), HasSubstr("without a scene"));
    EXPECT_EQ(session_.set_scene(lit_floor()).kind, Kind::rebuilt);
}

TEST_F(SessionTest, RefusesSettingsOutOfRange) {
    session_.set_scene(lit_floor());
    PictureSettings settings;
    settings.maps.samples = 0;
    EXPECT_THAT(usage_error([&] { static_cast<void>(session_.make_picture(settings)); }),
                HasSubstr("use map settings samples: is 0"));
    EXPECT_THAT(usage_error([&] { static_cast<void>(session_.first_hits(camera(), 0, 4)); }),
                HasSubstr("of 0 x 4 pixels"));
    Camera flat = camera();
    flat.vertical_fov = 0.0;
    EXPECT_THAT(usage_error([&] { static_cast<void>(session_.first_hits(flat, 4, 4)); }),
                HasSubstr("use camera vertical_fov"));
    EXPECT_EQ(session_.first_hits(camera(), 4, 3).size(), 12u);

    Picture picture = traced(false);
    picture.add_samples(2);
    const std::vector<glm::vec3> before = picture.image().pixels;
    EXPECT_THAT(usage_error([&] { picture.set_camera(flat); }), HasSubstr("use camera vertical_fov"));
    EXPECT_EQ(picture.samples(), 2u) << "the picture stays as it was";
    EXPECT_THAT(usage_error([&] { static_cast<void>(picture.half_image(2)); }), HasSubstr("must be 0 or 1"));
    picture.clear();
    picture.add_samples(2);
    EXPECT_EQ(picture.image().pixels, before) << "and so does its eye";
}

// Light is what takes minutes before the first sample.
TEST_F(SessionTest, PreparationForSamplesCanBeCancelled) {
    session_.set_scene(lit_floor());
    Picture picture = traced(true);
    Listener stopping(true);
    EXPECT_THROW(picture.add_samples(1, stopping), Interrupted);
    EXPECT_EQ(picture.samples(), 0u);
    EXPECT_THAT(picture.image().pixels, Each(glm::vec3(0.0f)));

    Listener listening(false);
    picture.add_samples(3, listening);
    EXPECT_EQ(picture.samples(), 3u);
    EXPECT_EQ(listening.begun, 0);
    EXPECT_THAT(listening.totals, testing::AllOf(testing::Not(IsEmpty()), Each(3.0)))
        << "it is told of samples alone";
    picture.add_samples(1, stopping);
    EXPECT_EQ(picture.samples(), 3u) << "what is prepared adds no sample, without an error";
}

TEST_F(SessionTest, MakesRoomBeforeASceneIsRebuilt) {
    Scene scene = lit_floor();
    session_.set_scene(scene);
    const std::uint64_t of_scene = session_.memory().current;
    Picture picture = traced(true);
    picture.add_samples(1);
    const std::uint64_t all = session_.memory().current;
    add(scene, icosphere({0, 0.5f, 0}, 0.25f, 1), lambert(glm::vec3(0.5f)));
    session_.reset_peak_memory();
    EXPECT_EQ(session_.set_scene(scene).kind, Kind::rebuilt);
    const std::uint64_t growth = session_.memory().current - of_scene;
    ASSERT_GT(growth, 0u);
    ASSERT_LT(growth, all - of_scene) << "else it would not fit into the room that is made";
    EXPECT_EQ(session_.memory().peak, all);
    picture.add_samples(1);
    EXPECT_EQ(picture.samples(), 1u);
}

TEST_F(SessionTest, UpdatesTheLightThatPicturesRead) {
    Scene scene = lit_floor();
    session_.set_scene(scene);
    Picture picture = traced(true);
    picture.add_samples(1);
    const std::uint64_t with_light = session_.memory().current;
    scene.materials[0].base_colour = glm::vec3(0.25f);  // changes no light
    EXPECT_EQ(session_.set_scene(scene).kind, Kind::updated);
    EXPECT_EQ(session_.memory().current, with_light);
    picture.add_samples(1);
    EXPECT_EQ(picture.statistics().prepare_counts.rays, 0u) << "its light was not simulated again";
}

TEST_F(SessionTest, DropsTheLightThatNoPictureReads) {
    Scene scene = lit_floor();
    session_.set_scene(scene);
    const std::uint64_t of_scene = session_.memory().current;
    std::vector<glm::vec3> pixels;
    {
        Picture picture = traced(true);
        picture.add_samples(1);
        pixels = picture.image().pixels;
    }
    EXPECT_GT(session_.memory().current, of_scene) << "light is kept for the next picture";
    Picture unlit = traced(false);
    scene.lights[0].intensity *= 2.0f;
    EXPECT_EQ(session_.set_scene(scene).kind, Kind::updated);
    EXPECT_EQ(session_.memory().current, of_scene);

    Picture picture = traced(true);
    picture.add_samples(1);
    std::vector<glm::vec3> doubled = pixels;
    for (glm::vec3& pixel : doubled)
        pixel *= 2.0f;
    EXPECT_EQ(picture.image().pixels, doubled) << "made anew, of the scene as it is";
}

}  // namespace
}  // namespace utsuri::test
