// SPDX-License-Identifier: Apache-2.0
// Maps are captured when something looks them up, and no others; pictures do not tell.
#include "renderers/methods/raster_renderer.h"
#include "support/methods.h"
#include "support/test_device.h"

namespace utsuri::test {
namespace {

constexpr RenderSettings kPicture{24, 18, 3, 4};
constexpr std::uint32_t kCubeFaces = 6;

Scene mirror_in_room() {
    Scene scene;
    add(scene, quad({-1, -1, -2.9f}, {2, 0, 0}, {0, 2, 0}), mirror());
    add(scene, room({-3, -3, -3}, {3, 3, 3}), emitter({0.3f, 0.5f, 0.2f}));
    add(scene, quad({-1, 0, 1}, {0.5f, 0, 0}, {0, 1, 0}), emitter({2, 0, 1}));
    return scene;
}

class CapturedMaps : public DeviceTest {
  protected:
    explicit CapturedMaps(const Scene& scene = mirror_in_room())
        : data_(prepare_scene_data(scene)),
          scene_(device(), data_),
          light_(kept_light(device(), data_, scene_, kCoarse)) {
        settings_.size = 16;
        settings_.samples = 1;
    }

    RasterRenderer renderer(MapKind kind, const Camera& camera) {
        return make_raster(device(), data_, scene_, light_, camera, kind, kPicture, settings_);
    }

    Image picture(Renderer& renderer, std::initializer_list<std::uint32_t> samples = {4}) {
        Film film(device(), kPicture.width, kPicture.height, "film");
        for (const std::uint32_t count : samples)
            renderer.add_samples(film, count, silent_);
        EXPECT_EQ(film.samples(), 4u);
        return film.resolve();
    }

    static constexpr LightSettings kCoarse = evenly_kept(1.0 / 20.0, 1, 0);

    Progress silent_;
    SceneData data_;
    GpuScene scene_;
    KeptLight light_;
    MapSettings settings_;
};

// The eye is on the mirror's axis and sees nothing else: all mirrored rays point at the face +z of the cube,
// which is 90 degrees wide.
TEST_F(CapturedMaps, AreThoseThatReflectionsReach) {
    for (const MapKind kind : {MapKind::polygon, MapKind::cube}) {
        RasterRenderer narrow = renderer(kind, look_at({0, 0, 2}, {0, 0, -3}, 0.1));
        narrow.prepare(silent_);
        EXPECT_EQ(narrow.statistics().maps, kCubeFaces);
        EXPECT_EQ(narrow.statistics().captured_maps, 1u);
        const std::uint64_t texels = (settings_.size + 2) * (settings_.size + 2);
        EXPECT_EQ(narrow.statistics().prepare_counts.rays - light_.get()->cost().counts.rays, texels)
            << "one ray a texel, from which surfaces that shine are seen";
    }
}

TEST_F(CapturedMaps, AreNoneWhereNoReflectorIsSeen) {
    for (const MapKind kind : kMapKinds) {
        RasterRenderer away = renderer(kind, look_at({0, 0, 2}, {0, 0, 3}));
        away.prepare(silent_);
        EXPECT_EQ(away.statistics().captured_maps, 0u);
    }
}

TEST_F(CapturedMaps, ShowWhatAllMapsWouldShow) {
    for (const MapKind kind : kMapKinds) {
        const Camera camera = look_at({0.5, 0.7, 1}, {0, 0, -3});
        RasterRenderer some = renderer(kind, camera);
        some.prepare(silent_);
        settings_.captures_all = true;
        RasterRenderer all = renderer(kind, camera);
        all.prepare(silent_);
        settings_.captures_all = false;
        EXPECT_EQ(all.statistics().captured_maps, all.statistics().maps);
        if (kind != MapKind::sphere) {
            EXPECT_LT(some.statistics().captured_maps, some.statistics().maps);
        }
        EXPECT_EQ(picture(some).pixels, picture(all).pixels) << "kind of map " << static_cast<int>(kind);
        EXPECT_EQ(picture(some, {1, 3}).pixels, picture(all).pixels);
    }
}

// From prepare() on, a frame that lacks a map captures it and is drawn again.
TEST_F(CapturedMaps, FollowTheEye) {
    const Camera straight = look_at({0, 0, 2}, {0, 0, -3}, 0.1);
    const Camera aslant = look_at({2.5, 0, -2.5}, {0, 0, -2.9}, 0.3);
    for (const MapKind kind : kMapKinds) {
        RasterRenderer moving = renderer(kind, straight);
        moving.prepare(silent_);
        moving.set_camera(aslant);
        const Image later = picture(moving);
        settings_.captures_all = true;
        RasterRenderer all = renderer(kind, straight);
        all.prepare(silent_);
        settings_.captures_all = false;
        all.set_camera(aslant);
        EXPECT_EQ(later.pixels, picture(all).pixels) << "kind of map " << static_cast<int>(kind);
        if (kind == MapKind::polygon || kind == MapKind::cube) {
            EXPECT_EQ(moving.statistics().captured_maps, 2u) << "straight ahead and to the left";
        }

        RasterRenderer framed = renderer(kind, straight);
        framed.prepare(silent_);
        for (RasterRenderer* renderer : {&framed, &all}) {
            renderer->set_camera(aslant);
            renderer->draw_frame();
        }
        EXPECT_EQ(framed.frame().pixels, all.frame().pixels);
    }
}

class Cancelled : public Progress {
  public:
    [[nodiscard]] bool cancelled() const override { return true; }
};

TEST_F(CapturedMaps, AreNotCapturedOnceCancelled) {
    RasterRenderer stopped = renderer(MapKind::cube, look_at({0, 0, 2}, {0, 0, 3}));
    stopped.prepare(silent_);
    stopped.set_camera(look_at({0, 0, 2}, {0, 0, -3}));
    Film film(device(), kPicture.width, kPicture.height, "film");
    Cancelled cancelled;
    stopped.add_samples(film, 2, cancelled);
    EXPECT_EQ(film.samples(), 0u);
    EXPECT_EQ(stopped.statistics().captured_maps, 0u);
    EXPECT_THROW(renderer(MapKind::cube, look_at({0, 0, 2}, {0, 0, -3})).prepare(cancelled), Interrupted);
}

// Of the planar method, what is curved.
TEST_F(CapturedMaps, OfCurvedReflectorsBesidePlaneOnes) {
    Scene scene = mirror_in_room();
    add(scene, icosphere({0, 0, 0}, 0.4f, 2), mirror());
    const SceneData data = prepare_scene_data(scene);
    const GpuScene gpu_scene(device(), data);
    KeptLight light = kept_light(device(), data, gpu_scene, kCoarse);
    for (const bool is_seen : {false, true}) {
        const Camera camera = look_at({0, 0, 2}, {0, is_seen ? 0.0 : 10.0, 0});
        RasterRenderer planar = make_raster(device(), data, gpu_scene, light, camera, {MapKind::proxy, true},
                                            kPicture, settings_);
        planar.prepare(silent_);
        EXPECT_EQ(planar.statistics().maps, kCubeFaces);
        EXPECT_EQ(planar.statistics().captured_maps > 0, is_seen);
    }
}

}  // namespace
}  // namespace utsuri::test
