// SPDX-License-Identifier: Apache-2.0
// Renderers follow a scene whose things move and whose lights change: pictures are those of renderers made
// for it as it is, and what the change cannot have touched is not made anew.
#include "renderers/methods/ray_tracer.h"
#include "support/light_scenes.h"
#include "support/methods.h"
#include "support/test_device.h"

#include <glm/ext/matrix_transform.hpp>

#include <functional>

namespace utsuri::test {
namespace {

constexpr RenderSettings kPicture{24, 18, 3, 4};
constexpr std::uint32_t kSamples = 2;

void move(Scene& scene, std::uint32_t instance, const glm::dvec3& by) {
    glm::dmat4& place = scene.instances[instance].world_from_object;
    place = glm::translate(glm::dmat4(1.0), by) * place;
}

/// About the upward axis through its origin, in radians.
void turn(Scene& scene, std::uint32_t instance, double angle) {
    glm::dmat4& place = scene.instances[instance].world_from_object;
    place = place * glm::rotate(glm::dmat4(1.0), angle, glm::dvec3(0, 1, 0));
}

Material& material_of(Scene& scene, std::uint32_t instance) {
    return scene.materials[scene.instances[instance].material];
}

/// A scene on the device that changes, with renderers that follow and others that do not know what was.
class ChangedScene : public DeviceTest {
  protected:
    ChangedScene() {
        maps_.size = 16;
        maps_.samples = 1;
    }

    void prepare(const Scene& scene) {
        light_.reset();
        data_ = prepare_scene_data(scene);
        gpu_scene_ = std::make_unique<GpuScene>(device(), data_);
        light_ = std::make_unique<KeptLight>(kept_light(device(), data_, *gpu_scene_, kCoarse));
    }

    SceneChange change(const Scene& scene) {
        const SceneChange change = update_scene_data(data_, scene);
        gpu_scene_->update(data_);
        return change;
    }

    std::unique_ptr<Renderer> renderer(const DrawnMethod& method, const Camera& camera, KeptLight& light) {
        return std::make_unique<RasterRenderer>(
            RendererInput{device(), data_, *gpu_scene_, light_methods().front(), light, camera}, method,
            kPicture, maps_);
    }

    std::unique_ptr<Renderer> prepared(const DrawnMethod& method, const Camera& camera) {
        std::unique_ptr<Renderer> made = renderer(method, camera, *light_);
        made->prepare(silent_);
        return made;
    }

    std::vector<glm::vec3> picture(Renderer& renderer) {
        Film film(device(), kPicture.width, kPicture.height, "film");
        renderer.add_samples(film, kSamples, silent_);
        return film.resolve().pixels;
    }

    /// What a renderer shows that was made for the scene as it is.
    std::vector<glm::vec3> made_anew(const DrawnMethod& method, const Camera& camera) {
        KeptLight light = kept_light(device(), data_, *gpu_scene_, kCoarse);
        const std::unique_ptr<Renderer> made = renderer(method, camera, light);
        made->prepare(silent_);
        return picture(*made);
    }

    static constexpr LightSettings kCoarse = evenly_kept(1.0 / 30.0, 2, 0);

    Progress silent_;
    SceneData data_;
    std::unique_ptr<GpuScene> gpu_scene_;
    std::unique_ptr<KeptLight> light_;
    MapSettings maps_;
};

/// everything_scene() a little later: 0 the walls, 1 the panel, 2 a mirror ball, 3 a rough one, 4 a plane
/// mirror.
Scene later(int step) {
    Scene scene = everything_scene();
    if (step >= 1) move(scene, 3, {0.25, 0.125, -0.5});
    if (step >= 2) scene.lights[0].intensity *= 0.5f;
    if (step >= 3) {
        move(scene, 2, {0.125, 0.0, 0.25});
        turn(scene, 4, 0.1);
    }
    if (step >= 4) material_of(scene, 0).base_colour = {0.2f, 0.7f, 0.4f};
    if (step >= 5) move(scene, 1, {0.25, 0.0, 0.25});
    if (step >= 6) material_of(scene, 0).base_colour = glm::vec3(0.0f);  // keeps no light any more
    return scene;
}
constexpr int kSteps = 6;

/// All methods follow all steps, in three suites that run side by side.
class ChangedSceneOfMethods : public ChangedScene {
  protected:
    void expect_as_if_it_had_always_been_so(const std::function<bool(const DrawnMethod&)>& is_meant);

    /// As opposed to methods that ask where what is reflected is.
    static bool looks_up_directions(const DrawnMethod& method) {
        return method.kind == MapKind::polygon || method.kind == MapKind::sphere ||
               method.kind == MapKind::cube;
    }
};

void ChangedSceneOfMethods::expect_as_if_it_had_always_been_so(
    const std::function<bool(const DrawnMethod&)>& is_meant) {
    const Camera camera = everything_camera();
    for (const DrawnMethod& method : drawn_methods()) {
        if (!is_meant(method)) continue;
        SCOPED_TRACE(testing::Message() << method);
        prepare(everything_scene());
        const std::unique_ptr<Renderer> following = prepared(method, camera);
        std::vector<glm::vec3> before = picture(*following);
        for (int step = 1; step <= kSteps; ++step) {
            SCOPED_TRACE(step);
            following->update(change(later(step)), silent_);
            const std::vector<glm::vec3> now = picture(*following);
            EXPECT_NE(now, before);
            EXPECT_EQ(now, made_anew(method, camera));
            before = now;
        }
    }
}

class ChangedSceneByDirections : public ChangedSceneOfMethods {};
TEST_F(ChangedSceneByDirections, LooksAsIfItHadAlwaysBeenSo) {
    expect_as_if_it_had_always_been_so([](const DrawnMethod& method) {
        return !method.draws_mirrored_views && looks_up_directions(method);
    });
}

class ChangedSceneByPlaces : public ChangedSceneOfMethods {};
TEST_F(ChangedSceneByPlaces, LooksAsIfItHadAlwaysBeenSo) {
    expect_as_if_it_had_always_been_so([](const DrawnMethod& method) {
        return !method.draws_mirrored_views && !looks_up_directions(method);
    });
}

class ChangedSceneInImages : public ChangedSceneOfMethods {};
TEST_F(ChangedSceneInImages, LooksAsIfItHadAlwaysBeenSo) {
    expect_as_if_it_had_always_been_so([](const DrawnMethod& method) { return method.draws_mirrored_views; });
}

TEST_F(ChangedScene, LooksAsIfItHadAlwaysBeenSoInMapsOnAnyPolyhedron) {
    const Camera camera = everything_camera();
    for (const char* name : {"tetrahedron", "octahedron"}) {
        maps_.polyhedron = platonic_solid(name);
        prepare(everything_scene());
        const std::unique_ptr<Renderer> following = prepared(MapKind::polygon, camera);
        following->update(change(later(1)), silent_);
        EXPECT_EQ(picture(*following), made_anew(MapKind::polygon, camera)) << name;
    }
}

TEST_F(ChangedScene, IsFollowedFromAnotherEye) {
    Camera elsewhere = everything_camera();
    elsewhere.position += 0.25 * elsewhere.right;
    elsewhere.position -= 0.125 * elsewhere.up;
    for (const MapKind kind : kMapKinds) {
        prepare(everything_scene());
        const std::unique_ptr<Renderer> following = prepared(kind, everything_camera());
        following->set_camera(elsewhere);
        following->update(change(later(1)), silent_);
        EXPECT_EQ(picture(*following), made_anew(kind, elsewhere))
            << "kind of map " << static_cast<int>(kind);
    }
}

TEST_F(ChangedScene, IsTracedAsIfItHadAlwaysBeenSo) {
    prepare(everything_scene());
    const Camera camera = everything_camera();
    const std::unique_ptr<RayTracer> following = make_tracer(device(), data_, *gpu_scene_, camera, kPicture);
    following->prepare(silent_);
    static_cast<void>(picture(*following));
    following->update(change(later(kSteps)), silent_);
    const std::unique_ptr<RayTracer> anew = make_tracer(device(), data_, *gpu_scene_, camera, kPicture);
    anew->prepare(silent_);
    EXPECT_EQ(picture(*following), picture(*anew));
}

/// Renderers of one scene share its light: whoever follows first simulates it.
TEST_F(ChangedScene, IsFollowedByRenderersThatShareLight) {
    const Camera camera = everything_camera();
    prepare(everything_scene());
    const std::unique_ptr<Renderer> first = prepared(MapKind::cube, camera);
    const std::unique_ptr<Renderer> second = prepared(MapKind::cube, camera);
    const SceneChange change = this->change(later(2));
    first->update(change, silent_);
    second->update(change, silent_);
    EXPECT_EQ(picture(*first), picture(*second));
    EXPECT_EQ(first->statistics().prepare_counts.rays, second->statistics().prepare_counts.rays);
}

// A mirror in the middle of a room of walls that shine, and a plate before one of them.
class ChangedRoom : public ChangedScene {
  protected:
    static constexpr std::uint32_t kFaces = 6;

    Scene scene() const {
        Scene scene;
        add(scene, quad({-0.5f, -0.5f, 0}, {1, 0, 0}, {0, 1, 0}), mirror());
        add(scene, room({-3, -3, -3}, {3, 3, 3}), emitter({0.3f, 0.5f, 0.2f}));
        add(scene, quad({2.5f, -0.5f, 0.5f}, {0, 0, -1}, {0, 1, 0}), emitter({2, 0, 1}));
        return scene;
    }
    static constexpr std::uint32_t kPlate = 2;

    std::uint64_t texels_of(std::uint32_t faces) const {
        const std::uint64_t stride = maps_.size + 2;
        return faces * stride * stride;
    }
};

TEST_F(ChangedRoom, CapturesOnlyMapsThatSeeTheChange) {
    maps_.captures_all = true;
    prepare(scene());
    const Camera camera = look_at({1, 0, 2}, {0, 0, 0});
    const std::unique_ptr<Renderer> following = prepared(MapKind::cube, camera);
    EXPECT_EQ(following->statistics().captured_maps, kFaces);

    Scene changed = scene();
    material_of(changed, kPlate).emissive = {1, 1, 0};
    following->update(change(changed), silent_);
    EXPECT_EQ(following->statistics().prepare_counts.rays, texels_of(1))
        << "the face +x alone sees the plate";
    EXPECT_EQ(picture(*following), made_anew(MapKind::cube, camera));

    move(changed, kPlate, {-5, 0, 0});
    following->update(change(changed), silent_);
    EXPECT_EQ(following->statistics().prepare_counts.rays, texels_of(2)) << "from +x to -x";
    EXPECT_EQ(picture(*following), made_anew(MapKind::cube, camera));

    move(changed, kPlate, {0, 0, 2.5});
    following->update(change(changed), silent_);
    EXPECT_EQ(following->statistics().prepare_counts.rays, texels_of(2)) << "across the edge of -x and +z";
    EXPECT_EQ(picture(*following), made_anew(MapKind::cube, camera));
}

TEST_F(ChangedRoom, MeasuresOnlyDistancesThatChanged) {
    maps_.captures_all = true;
    maps_.size = 64;
    prepare(scene());
    const std::unique_ptr<Renderer> following = prepared(MapKind::distance, look_at({0, 0, 2}, {0, 0, 0}));
    const std::uint64_t all = following->statistics().prepare_counts.rays;
    Scene changed = scene();
    move(changed, kPlate, {0.125, 0, 0});
    following->update(change(changed), silent_);
    const std::uint64_t rays = following->statistics().prepare_counts.rays;
    EXPECT_LE(rays, all / 2) << "of the face +x and of those whose borders reach into it";
    EXPECT_GE(rays, all / kFaces);
}

// A plate before the wall as bright as the wall: nothing that a ray could meet about its outline differs.
TEST_F(ChangedRoom, BoundsRadianceAnewWhereItChanged) {
    maps_.size = 64;
    maps_.tolerance = {Tolerance::Of::radiance, 0.05};
    Scene changed;
    add(changed, icosphere({0, 0, 0}, 0.5f, 3), mirror());
    add(changed, room({-3, -3, -3}, {3, 3, 3}), emitter({0.3f, 0.5f, 0.2f}));
    add(changed, quad({-0.5f, -0.5f, 2.5f}, {0, 1, 0}, {1, 0, 0}), emitter({1, 1, 1}));
    prepare(changed);
    const Camera camera = look_at({0.125, 0, 2}, {0, 0, 0});
    const std::unique_ptr<Renderer> following = prepared(MapKind::hybrid, camera);
    const auto traced = [](Renderer& renderer) {
        const std::vector<float> pixels = renderer.traced_pixels();
        return std::count(pixels.begin(), pixels.end(), 1.0f);
    };
    const std::ptrdiff_t before = traced(*following);
    EXPECT_GT(before, 0);
    material_of(changed, kPlate).emissive = material_of(changed, 1).emissive;
    following->update(change(changed), silent_);
    const std::unique_ptr<Renderer> anew = prepared(MapKind::hybrid, camera);
    EXPECT_LT(traced(*anew), before);
    EXPECT_EQ(following->traced_pixels(), anew->traced_pixels());
    EXPECT_EQ(picture(*following), picture(*anew));
}

// An open book, whose pages see each other only at less than 44 degrees; then steeper, where they face.
TEST_F(ChangedRoom, FindsAnewWhichRaysMissAMirrorThatWasBent) {
    Mesh book;
    book.positions = {{0, 0, -1}, {0, 0, 1}, {-1, 0.4f, 1}, {-1, 0.4f, -1}, {1, 0.4f, -1}, {1, 0.4f, 1}};
    book.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 5}, {0, 5, 4}};
    Scene changed;
    add(changed, faceted(book), mirror());
    add(changed, room({-3, -3, -3}, {3, 3, 3}), emitter({0.3f, 0.5f, 0.2f}));
    maps_.size = 64;
    maps_.tolerance = {Tolerance::Of::place, 4.0};
    prepare(changed);
    const Camera camera = look_at({0.125, 2.5, 0.25}, {0, 0, 0});
    const std::unique_ptr<Renderer> following = prepared(MapKind::hybrid, camera);
    const auto traced = [](Renderer& renderer) {
        const std::vector<float> pixels = renderer.traced_pixels();
        return std::count(pixels.begin(), pixels.end(), 1.0f);
    };
    const std::ptrdiff_t before = traced(*following);
    glm::dmat4& place = changed.instances[0].world_from_object;
    place = glm::scale(glm::dmat4(1.0), {1.0, 2.5, 1.0}) * place;
    following->update(change(changed), silent_);
    const std::unique_ptr<Renderer> anew = prepared(MapKind::hybrid, camera);
    EXPECT_GT(traced(*anew), before);
    EXPECT_EQ(following->traced_pixels(), anew->traced_pixels());
    EXPECT_EQ(picture(*following), picture(*anew));
}

TEST_F(ChangedRoom, CostsNothingWhereNothingChanged) {
    prepare(scene());
    const std::unique_ptr<Renderer> following = prepared(MapKind::hybrid, look_at({0, 0, 2}, {0, 0, 0}));
    const SceneChange none = change(scene());
    EXPECT_TRUE(none.empty());
    following->update(none, silent_);
    EXPECT_EQ(following->statistics().prepare_counts.rays, 0u);
    EXPECT_EQ(picture(*following), made_anew(MapKind::hybrid, look_at({0, 0, 2}, {0, 0, 0})));
}

// All maps of a mirror that moves are seen from elsewhere.
TEST_F(ChangedRoom, CapturesAllMapsOfAMirrorThatMoved) {
    maps_.captures_all = true;
    prepare(scene());
    const std::unique_ptr<Renderer> following = prepared(MapKind::cube, look_at({0, 0, 2}, {0, 0, 0}));
    Scene changed = scene();
    move(changed, 0, {0, 0.25, 0});
    following->update(change(changed), silent_);
    EXPECT_EQ(following->statistics().prepare_counts.rays, texels_of(kFaces));
}

}  // namespace
}  // namespace utsuri::test
