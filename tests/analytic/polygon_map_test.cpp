// SPDX-License-Identifier: Apache-2.0
// direct/polygon-map. On a plane mirror it must show exactly what a map at infinity shows: the point that a
// ray from the capture point along the reflected direction meets. Rooms that shine with their own position
// tell which it is.
#include "support/light_scenes.h"
#include "support/test_device.h"
#include "support/worked_room.h"

#include "map_observer.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <array>
#include <cmath>
#include <set>

namespace utsuri::test {
namespace {

/// A texel's mean over 16 jittered samples lies within about a tenth of a texel of its centre, and where two
/// walls meet within a texel the mean cuts the corner by up to an eighth of it.
constexpr double kTexelError = 0.25;

class PolygonMap : public DeviceTest {};

/// Edge of a texel in radians where it is widest, at the centre of a face.
double texel_angle(std::uint32_t size) {
    return 2.0 / size;
}

TEST_F(PolygonMap, TracingShowsTheWorkedHits) {
    Observer observer(device(), worked_room());
    for (const WorkedPoint& point : kWorkedPoints) {
        const glm::dvec3 seen = kWorkedRoom.decode(observer.look(kWorkedEye, point.mirror, 4).mean);
        // A close-up is 1e-4 wide at distances of up to 10 m, at angles of up to 60 degrees.
        EXPECT_LE(glm::length(seen - point.hit), 2.0 * kCloseUpAngle * 10.0);
    }
}

TEST_F(PolygonMap, ShowsTheInfiniteMapInTheWorkedRoom) {
    constexpr std::uint32_t kSize = 128;
    MapObserver observer(device(), worked_room(), MapKind::polygon, map_settings(kSize, kWorkedCapturePoint));
    for (const WorkedPoint& point : kWorkedPoints) {
        const glm::dvec3 seen = kWorkedRoom.decode(observer.look(kWorkedEye, point.mirror, 4).mean);
        const double error = angle_between(seen - kWorkedCapturePoint, point.infinite - kWorkedCapturePoint);
        EXPECT_LE(error, kTexelError * texel_angle(kSize))
            << "seen " << seen.x << ' ' << seen.y << ' ' << seen.z;
    }
    EXPECT_EQ(observer.statistics().counts.rays, 0u);
}

/// A mirror of two triangles that fills [-4,4]^2 at z = 0, in a large room.
const CodedRoom kHall({-20, -20, -10}, {20, 20, 30});
Scene hall_with_mirror_floor() {
    Scene scene;
    kHall.add_to(scene);
    add(scene, quad({-4, -4, 0}, {8, 0, 0}, {0, 8, 0}), mirror());
    return scene;
}

// Seen at grazing angles a triangle's corners are at very different distances. Interpolating unit vectors
// would be wrong by degrees; unnormalised ones are exact.
TEST_F(PolygonMap, InterpolatesUnnormalisedVectors) {
    constexpr std::uint32_t kSize = 128;
    const glm::dvec3 capture_point(0, 0, 3);
    const glm::dvec3 eye(0.5, -3.8, 0.6);
    const std::array<glm::dvec3, 3> corners = {{{-4, -4, 0}, {4, -4, 0}, {4, 4, 0}}};
    MapObserver observer(device(), hall_with_mirror_floor(), MapKind::polygon,
                         map_settings(kSize, capture_point));
    double largest_avoided = 0.0;
    for (const glm::dvec3 weights :
         {glm::dvec3(0.2, 0.5, 0.3), glm::dvec3(0.3, 0.1, 0.6), glm::dvec3(0.1, 0.2, 0.7)}) {
        glm::dvec3 point(0.0);
        glm::dvec3 normalised(0.0);
        for (int i = 0; i < 3; ++i) {
            point += weights[i] * corners[static_cast<std::size_t>(i)];
            const glm::dvec3 to_corner = corners[static_cast<std::size_t>(i)] - eye;
            normalised += weights[i] * glm::normalize(glm::reflect(to_corner, glm::dvec3(0, 0, 1)));
        }
        const glm::dvec3 reflected = glm::reflect(point - eye, glm::dvec3(0, 0, 1));
        largest_avoided = std::max(largest_avoided, angle_between(normalised, reflected));
        const glm::dvec3 seen = kHall.decode(observer.look(eye, point, 4).mean);
        EXPECT_LE(angle_between(seen - capture_point, reflected), kTexelError * texel_angle(kSize));
    }
    EXPECT_GT(largest_avoided, 10.0 * kTexelError * texel_angle(kSize));
}

// Both triangles straddle several faces of the cube of maps: every pixel must show what its own direction
// points at.
TEST_F(PolygonMap, StraddlingPolygonsHaveNoSeams) {
    constexpr std::uint32_t kSize = 64;
    const glm::dvec3 capture_point(0.3, -0.2, 2);
    MapObserver observer(device(), hall_with_mirror_floor(), MapKind::polygon,
                         map_settings(kSize, capture_point));
    RenderSettings settings;
    settings.width = settings.height = 64;
    const Camera camera = look_at({0.1, 0.2, 1.5}, {0.1, 0.2, 0}, 2.2);
    const Image image = observer.picture(camera, settings, 16);
    const double half = std::tan(0.5 * camera.vertical_fov);
    std::set<int> faces;
    for (std::uint32_t y = 0; y < 64; ++y) {
        for (std::uint32_t x = 0; x < 64; ++x) {
            const glm::dvec2 p = half * (glm::dvec2(x + 0.5, -(y + 0.5)) / 32.0 + glm::dvec2(-1, 1));
            const glm::dvec3 along = camera.forward + p.x * camera.right + p.y * camera.up;
            const glm::dvec3 reflected(along.x, along.y, -along.z);
            const glm::dvec3 size = glm::abs(reflected);
            faces.insert(size.z >= std::max(size.x, size.y)
                             ? 2
                             : (size.x >= size.y ? 0 : 1) + (reflected.x + reflected.y > 0 ? 3 : 0));
            const glm::dvec3 seen = kHall.decode(glm::dvec3(image.at(x, y)));
            // A pixel is about as wide as a texel here, and cuts corners like one.
            ASSERT_LE(angle_between(seen - capture_point, reflected), 2.0 * kTexelError * texel_angle(kSize))
                << "pixel " << x << ' ' << y;
        }
    }
    EXPECT_EQ(faces.size(), 5u);
}

// With the surroundings 200 radii away a map is as good as a traced ray, to a texel and the parallax: on a
// ball, whose reflections use all faces of the cube and all its corners.
TEST_F(PolygonMap, ABallInADistantRoomShowsWhatTracingShows) {
    constexpr std::uint32_t kSize = 64;
    constexpr double kHalf = 200.0;
    const CodedRoom coded(glm::dvec3(-kHalf), glm::dvec3(kHalf));
    Scene scene;
    coded.add_to(scene);
    add(scene, icosphere(glm::vec3(0.0f), 1.0f, 4), mirror());
    MapObserver mapped(device(), scene, MapKind::polygon, map_settings(kSize));
    Observer traced(device(), scene);
    RenderSettings settings;
    settings.width = settings.height = 64;
    // Parallax asin(1 / 200); interpolation, from a float64 study of such balls, under beta^2 for an edge of
    // beta rad seen from 4 radii. A wrong direction moves the point on the wall by up to 3 times as much at a
    // corner. In the map half a texel of 2 / N of the wall.
    constexpr double kEdge = 1.05146222 / 16.0;
    const double bound = 3.0 * (1.0 / kHalf + kEdge * kEdge) + 2.0 * kTexelError * texel_angle(kSize);
    std::array<double, 8> nearest_corner{};
    std::set<int> faces;
    for (const glm::dvec3 eye : {glm::dvec3(3, 2, 2.5), glm::dvec3(-3, -2, -2.5)}) {
        const Camera camera = look_at(eye, {0, 0, 0}, 0.36);
        const Image map = mapped.picture(camera, settings, 16);
        const Image ray = traced.picture(camera, settings, 16);
        for (std::size_t i = 0; i < map.pixels.size(); ++i) {
            const glm::dvec3 a = coded.decode(glm::dvec3(map.pixels[i])) / kHalf;
            const glm::dvec3 b = coded.decode(glm::dvec3(ray.pixels[i])) / kHalf;
            const glm::dvec3 difference = glm::abs(a - b);
            ASSERT_LE(std::max({difference.x, difference.y, difference.z}), bound) << "pixel " << i;
            for (int axis = 0; axis < 3; ++axis) {
                if (std::abs(b[axis]) > 0.99) faces.insert(2 * axis + (b[axis] < 0.0 ? 1 : 0));
            }
            for (std::size_t corner = 0; corner < 8; ++corner) {
                const glm::dvec3 direction(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
                nearest_corner[corner] =
                    std::max(nearest_corner[corner], glm::dot(glm::normalize(b), direction));
            }
        }
    }
    EXPECT_EQ(faces.size(), 6u);
    for (const double cosine : nearest_corner)
        EXPECT_GE(cosine, std::sqrt(3.0) * std::cos(0.1));
}

/// A small mirror ball at a point, which is what the maps are captured for.
void add_ball(Scene& scene, glm::vec3 centre) {
    add(scene, icosphere(centre, 0.05f, 0), mirror());
}

// Texel (column, row) of the face along axis a looks along a + x e(a+1) + y e(a+2), border texels too.
TEST_F(PolygonMap, TexelsLookWhereTheyShould) {
    constexpr std::uint32_t kSize = 32;
    const glm::dvec3 centre(1.5, 1.0, 2.0);
    Scene scene;
    kWorkedRoom.add_to(scene);
    add_ball(scene, glm::vec3(centre));
    MapObserver observer(device(), scene, MapKind::polygon, map_settings(kSize));
    const std::vector<Image> maps = observer.maps(look_at({3, 2, 4}, centre));
    ASSERT_EQ(maps.size(), 6u);
    for (int face = 0; face < 6; ++face) {
        const Image& map = maps[static_cast<std::size_t>(face)];
        ASSERT_EQ(map.width, kSize + 2 * interop::MAP_BORDER);
        const int axis = face / 2;
        for (std::uint32_t row = 0; row < map.height; ++row) {
            for (std::uint32_t column = 0; column < map.width; ++column) {
                const glm::dvec2 p = texel_centre(column, row, kSize);
                const glm::dvec3 seen = kWorkedRoom.decode(glm::dvec3(map.at(column, row))) - centre;
                const double depth = face % 2 == 0 ? seen[axis] : -seen[axis];
                ASSERT_GT(depth, 0.0);
                const glm::dvec2 q(seen[(axis + 1) % 3] / depth, seen[(axis + 2) % 3] / depth);
                ASSERT_LE(glm::length(q - p), kTexelError * 2.0 / kSize)
                    << "face " << face << ' ' << column << ' ' << row;
            }
        }
    }
}

/// Solid angle of a texel of a cube face of edge 2 at distance 1, float64.
double texel_solid_angle(glm::dvec2 centre, std::uint32_t size) {
    const auto corner = [](double x, double y) { return std::atan2(x * y, std::sqrt(x * x + y * y + 1.0)); };
    const double h = 1.0 / size;
    return corner(centre.x - h, centre.y - h) - corner(centre.x - h, centre.y + h) -
           corner(centre.x + h, centre.y - h) + corner(centre.x + h, centre.y + h);
}

// A square of edge 1 at distance 1 fills 0.805431683 sr, whichever way it is turned about the capture point.
TEST_F(PolygonMap, SumOverTexelsIsTheSolidAngle) {
    constexpr std::uint32_t kSize = 64;
    // Only texels that the square's outline crosses are uncertain: at most 1.5 times 4 edges of 32 texels,
    // each with a binomial share of its 2^2 / 64^2 sr from 16 samples.
    const double bound = kSigmas * std::sqrt(1.5 * 4 * 32) * 0.5 / std::sqrt(16.0) * 4.0 / (kSize * kSize);
    for (const double angle : {0.0, 0.9, 2.3}) {
        Scene scene;
        add(scene, ceiling({0, 1, 0}, 0.5f), emitter(glm::vec3(1.0f)));
        scene.instances.back().world_from_object =
            glm::rotate(glm::dmat4(1.0), angle, glm::normalize(glm::dvec3(1, 0.3, -0.5)));
        add_ball(scene, glm::vec3(0.0f));
        MapObserver observer(device(), scene, MapKind::polygon, map_settings(kSize));
        double sum = 0.0;
        double sphere = 0.0;
        for (const Image& map : observer.maps(look_at({0, 0, 3}, {0, 0, 0}))) {
            for (std::uint32_t row = 1; row <= kSize; ++row) {
                for (std::uint32_t column = 1; column <= kSize; ++column) {
                    const double texel = texel_solid_angle(texel_centre(column, row, kSize), kSize);
                    sphere += texel;
                    sum += texel * static_cast<double>(map.at(column, row).x);
                }
            }
        }
        EXPECT_NEAR(sphere, 4.0 * 3.14159265358979, 1e-9);
        EXPECT_NEAR(sum, 0.805431683, bound) << "turned by " << angle;
    }
}

}  // namespace
}  // namespace utsuri::test
