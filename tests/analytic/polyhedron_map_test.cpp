// SPDX-License-Identifier: Apache-2.0
// direct/polygon-map with other polyhedra than the cube, and the pieces that polygons are cut into along
// their faces.
#include "support/coded_room.h"
#include "support/light_scenes.h"
#include "support/methods.h"
#include "support/test_device.h"

#include "map_observer.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace utsuri::test {
namespace {

const CodedRoom kRoom({-20, -20, -20}, {20, 20, 20});

/// Two mirrors of which every polygon reflects to all sides: a coarse ball and a square under the eye.
Scene mirrors() {
    Scene scene;
    kRoom.add_to(scene);
    add(scene, icosphere({0, 0, 0}, 1.0f, 1), mirror());
    add(scene, quad({-6, -2, -6}, {0, 0, 12}, {12, 0, 0}), mirror());
    return scene;
}

Camera camera() {
    return look_at({0.7, 1.9, 3.1}, {0, -0.6, 0}, 1.1);
}

Polyhedron from_planes(const std::vector<glm::dvec4>& planes) {
    Polyhedron solid;
    for (const glm::dvec4& plane : planes) {
        const glm::dvec3 normal(plane);
        solid.planes.push_back({glm::normalize(normal), plane.w / glm::length(normal)});
    }
    return solid;
}

/// The box |x| <= x, |y| <= y, |z| <= z.
std::vector<glm::dvec4> box_planes(double x, double y, double z) {
    return {{1, 0, 0, x}, {-1, 0, 0, x}, {0, 1, 0, y}, {0, -1, 0, y}, {0, 0, 1, z}, {0, 0, -1, z}};
}

/// Nearly degenerate ones, the one with the most faces, and the Platonic solids.
Polyhedron polyhedron(std::string_view name) {
    if (name == "flat") return from_planes(box_planes(1, 1e-3, 1));
    if (name == "long") return from_planes(box_planes(1e-3, 1e-3, 1));
    if (name == "twins") {
        // Two planes for +x, 1e-5 rad apart, that share an edge in the middle.
        std::vector<glm::dvec4> planes = box_planes(1, 1, 1);
        planes.emplace_back(1, 1e-5, 0, 1);
        return from_planes(planes);
    }
    if (name != "most") return platonic_solid(name);
    // An icosahedron whose 12 corners, 1.258 times as far as its faces, are cut off: 32 faces.
    Polyhedron solid = platonic_solid("icosahedron");
    for (Polyhedron::Plane plane : platonic_solid("dodecahedron").planes) {
        plane.distance = 1.1;
        solid.planes.push_back(plane);
    }
    return solid;
}

MapSettings settings_for(const char* solid) {
    MapSettings settings;
    settings.size = 64;
    settings.samples = 16;
    settings.capture_point = glm::dvec3(0.0, 1.5, 0.0);
    settings.polyhedron = polyhedron(solid);
    return settings;
}

RenderSettings picture_settings() {
    RenderSettings settings;
    settings.width = settings.height = 96;
    return settings;
}

class PolyhedronPieces : public DeviceTest, public testing::WithParamInterface<const char*> {
  protected:
    struct Cut {
        ReflectorDrawer::Pieces pieces;
        Reflectors reflectors;
        std::vector<interop::MapFace> faces;
    };

    static Cut cut(const Scene& scene, const Camera& eye, const char* solid) {
        const SceneData data = prepare_scene_data(scene);
        const GpuScene gpu_scene(device(), data);
        KeptLight light = kept_light(device(), data, gpu_scene, evenly_kept(1.0 / 60.0, 4, 0));
        MapSettings settings = settings_for(solid);
        settings.size = 1;
        settings.samples = 1;
        RasterRenderer renderer = make_raster(device(), data, gpu_scene, light, eye, MapKind::polygon,
                                              picture_settings(), settings);
        Progress progress;
        renderer.prepare(progress);
        return {reflectors_of(renderer)->pieces(), renderer.maps().maps().reflectors(),
                renderer.maps().maps().faces()};
    }
};

double twice_area(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// How much farther than its own face a vector gets on another, relative to what rounding may do.
double excess(const std::vector<interop::MapFace>& faces, std::uint32_t face, const glm::dvec3& reflection) {
    double most = 0.0;
    double nearest = 0.0;  // one over the least distance of a face
    const double own = glm::dot(glm::dvec3(faces[face].outward), reflection);
    for (const interop::MapFace& other : faces) {
        most = std::max(most, glm::dot(glm::dvec3(other.outward), reflection) - own);
        nearest = std::max(nearest, glm::length(glm::dvec3(other.outward)));
    }
    return most / (nearest * glm::length(reflection));
}

// No part of a polygon is lost or drawn twice, and each piece keeps to its face.
TEST_P(PolyhedronPieces, PiecesOfAPolygonMakeItUp) {
    const Cut found = cut(mirrors(), camera(), GetParam());
    ASSERT_EQ(found.pieces.cut_corners.size(), 3 * found.pieces.cut.size());
    EXPECT_GT(found.pieces.cut.size(), 100u);
    std::vector<double> area(found.reflectors.triangles.size(), 0.0);
    for (const interop::Piece& piece : found.pieces.whole)
        area.at(piece.polygon) += 1.0;
    for (std::size_t i = 0; i < found.pieces.cut.size(); ++i) {
        const interop::Piece& piece = found.pieces.cut[i];
        const interop::PieceCorner* corners = &found.pieces.cut_corners[3 * i];
        const double share = twice_area(corners[0].place, corners[1].place, corners[2].place);
        // Some twenty roundings of coordinates of at most 1.
        EXPECT_GE(share, -2e-6);
        area.at(piece.polygon) += share;
        for (int k = 0; k < 3; ++k) {
            EXPECT_LE(excess(found.faces, piece.face, corners[k].reflection), 1e-5)
                << "face " << piece.face << ", polygon " << piece.polygon;
        }
    }
    for (const double share : area)
        EXPECT_NEAR(share, 1.0, 2e-5);
}

// Where an edge is cut, both its polygons have a corner, with the same bits.
TEST_P(PolyhedronPieces, NeighboursAreCutAtTheSamePoints) {
    Scene scene;
    kRoom.add_to(scene);
    add(scene, icosphere({0.3f, 0.1f, -0.2f}, 1.0f, 2), mirror());
    const Cut found = cut(scene, look_at({2.1, 0.7, 1.3}, {0, 0, 0}), GetParam());
    using Key = std::tuple<float, float, float>;
    std::map<Key, std::set<std::uint32_t>> polygons_at;
    const auto visit = [&](const glm::vec3& position, std::uint32_t polygon) {
        polygons_at[Key(position.x, position.y, position.z)].insert(polygon);
    };
    int on_edges = 0;
    for (std::size_t i = 0; i < found.pieces.cut_corners.size(); ++i) {
        const interop::PieceCorner& corner = found.pieces.cut_corners[i];
        visit(corner.position, found.pieces.cut[i / 3].polygon);
    }
    for (std::size_t i = 0; i < found.pieces.cut_corners.size(); ++i) {
        const glm::vec2& b = found.pieces.cut_corners[i].place;
        const int zeros = (b.x == 0.0f) + (b.y == 0.0f) + (b.x + b.y == 1.0f);
        if (zeros != 1) continue;  // a corner of the polygon, or inside it
        ++on_edges;
        const glm::vec3& p = found.pieces.cut_corners[i].position;
        EXPECT_EQ(polygons_at.at(Key(p.x, p.y, p.z)).size(), 2u) << b.x << ' ' << b.y;
    }
    EXPECT_GT(on_edges, 50);
}

// What pieces show is what the same interpolation shows evaluated pixel by pixel: polygons whose pieces find
// no room are drawn whole, with the face found per pixel. Map texels differ by up to a quarter of the room's
// 0..1 codes from their neighbours at its corners; coordinates of 64 texels have some 20 roundings.
TEST_P(PolyhedronPieces, PiecesShowWhatEachPixelWouldFind) {
    MapSettings settings = settings_for(GetParam());
    MapObserver pieces(device(), mirrors(), MapKind::polygon, settings);
    settings.most_cut_pieces = 1;
    MapObserver whole(device(), mirrors(), MapKind::polygon, settings);
    const Image a = pieces.picture(camera(), picture_settings(), 4);
    const Image b = whole.picture(camera(), picture_settings(), 4);
    constexpr float kRoundings = 64.0f * 20.0f * 6e-8f;
    int edges = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const glm::vec3 difference = glm::abs(a.pixels[i] - b.pixels[i]);
        // On a boundary itself the two may choose different faces, which see the same to a texel's width.
        if (std::max({difference.x, difference.y, difference.z}) > kRoundings) ++edges;
    }
    EXPECT_LE(edges, 96 * 96 / 1000);
}

class PolyhedronMap : public PolyhedronPieces {};

// All polyhedra show the same reflections, to the texels of the coarser of the two; a tetrahedron's texels
// are up to 2 sqrt(6) / 64 wide and stretched ninefold towards its corners.
TEST_P(PolyhedronMap, ShowsWhatTheCubeShows) {
    MapObserver cube_observer(device(), mirrors(), MapKind::polygon, settings_for("cube"));
    MapObserver observer(device(), mirrors(), MapKind::polygon, settings_for(GetParam()));
    const Image expected = cube_observer.picture(camera(), picture_settings(), 4);
    const Image image = observer.picture(camera(), picture_settings(), 4);
    double sum = 0.0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const glm::dvec3 difference = glm::dvec3(image.pixels[i]) - glm::dvec3(expected.pixels[i]);
        sum += glm::length(difference);
        const glm::dvec3 seen = kRoom.decode(glm::dvec3(image.pixels[i]));
        const glm::dvec3 should = kRoom.decode(glm::dvec3(expected.pixels[i]));
        ASSERT_LE(angle_between(seen, should), 0.5) << "pixel " << i;
    }
    EXPECT_LE(sum / static_cast<double>(image.pixels.size()), 0.02);
}

INSTANTIATE_TEST_SUITE_P(Solids, PolyhedronPieces,
                         testing::Values("tetrahedron", "cube", "octahedron", "dodecahedron", "icosahedron",
                                         "flat", "long", "twins", "most"),
                         [](const auto& solid) { return std::string(solid.param); });
INSTANTIATE_TEST_SUITE_P(Solids, PolyhedronMap,
                         testing::Values("tetrahedron", "cube", "octahedron", "dodecahedron", "icosahedron"),
                         [](const auto& solid) { return std::string(solid.param); });

}  // namespace
}  // namespace utsuri::test
