// SPDX-License-Identifier: Apache-2.0
// No seams where two faces of a polyhedron of maps meet: in surroundings without edges, what is seen jumps
// there by no more than what either face may be off by within a texel.
#include "support/coded_room.h"
#include "support/test_device.h"

#include "base/sampler.h"

#include "map_observer.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace utsuri::test {
namespace {

constexpr std::uint32_t kSize = 32;
constexpr std::uint32_t kPixels = 48;
/// Of a texel: its mean over 64 stratified samples is off by a few hundredths, and interpolating between
/// texels over which the surroundings change smoothly by as much again.
constexpr double kTexelError = 0.1;
/// Angle of the eye: some four texels of a cube across the picture.
constexpr double kAngle = 0.25;

/// Long and low, so that its own edges are not seen where faces meet.
const CodedRoom kRoom({-30, -9, -45}, {19, 40, 55});

struct Edge {
    std::array<std::size_t, 2> faces;
    glm::dvec3 middle;
};

/// Edges of the first face: one each where a neighbour follows.
std::vector<Edge> edges_of_first_face(const Polyhedron& solid) {
    std::vector<Edge> edges;
    const std::vector<glm::dvec3> corners = face_corners(solid, 0);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3 middle = 0.5 * (corners[i] + corners[(i + 1) % corners.size()]);
        for (std::size_t other = 1; other < solid.planes.size(); ++other) {
            const Polyhedron::Plane& plane = solid.planes[other];
            if (std::abs(glm::dot(plane.normal, middle) - plane.distance) < 1e-6)
                edges.push_back({{0, other}, middle});
        }
    }
    return edges;
}

glm::dvec3 code(const glm::dvec3& direction) {
    const glm::dvec3 point = kRoom.wall_point(glm::dvec3(0.0), direction);
    return (point - kRoom.decode({0, 0, 0})) / (kRoom.decode({1, 1, 1}) - kRoom.decode({0, 0, 0}));
}

double largest(const glm::dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

std::size_t face_of(const Polyhedron& solid, const glm::dvec3& direction) {
    const auto advance = [&](const Polyhedron::Plane& plane) {
        return glm::dot(plane.normal, direction) / plane.distance;
    };
    const auto found =
        std::max_element(solid.planes.begin(), solid.planes.end(),
                         [&](const auto& a, const auto& b) { return advance(a) < advance(b); });
    return static_cast<std::size_t>(found - solid.planes.begin());
}

/// How much the room's code changes from a direction to one a texel further on its face.
double change_over_a_texel(const Polyhedron& solid, std::size_t face, const glm::dvec3& direction) {
    const FacePicture picture = face_picture(solid, face);
    const Polyhedron::Plane& plane = solid.planes[face];
    const glm::dvec3 point = direction * (plane.distance / glm::dot(plane.normal, direction));
    double change = 0.0;
    for (const glm::dvec3& half : {picture.right, picture.up}) {
        const glm::dvec3 texel = 2.0 / kSize * half;
        change +=
            std::max(largest(code(point + texel) - code(point)), largest(code(point - texel) - code(point)));
    }
    return change;
}

class MapSeams : public DeviceTest, public testing::WithParamInterface<const char*> {};

// A mirror turned to the middle of an edge, with the eye before it: the picture shows both faces enlarged.
TEST_P(MapSeams, JumpsAreWithinATexel) {
    MapSettings settings = map_settings(kSize, glm::dvec3(0.0));
    settings.samples = 64;
    settings.polyhedron = platonic_solid(GetParam());
    RenderSettings picture;
    picture.width = picture.height = kPixels;
    const std::vector<Edge> edges = edges_of_first_face(settings.polyhedron);
    ASSERT_GE(edges.size(), 3u);
    for (std::size_t n = 0; n < edges.size(); n += 2) {
        const glm::dvec3 normal = glm::normalize(edges[n].middle);
        const Camera camera = look_at(3.0 * normal, glm::dvec3(0.0), kAngle);
        Scene scene;
        kRoom.add_to(scene);
        add(scene,
            quad(glm::vec3(-camera.right - camera.up), glm::vec3(2.0 * camera.right),
                 glm::vec3(2.0 * camera.up)),
            mirror());
        const Image image = MapObserver(device(), scene, MapKind::cube, settings).picture(camera, picture, 1);

        // One sample, which lies at the same place in all pixels.
        const glm::dvec2 jitter(sample_2d(sampler_key({0, 0}, picture.seed, 0), 0, 0));
        const double half = std::tan(0.5 * kAngle);
        const auto direction = [&](std::uint32_t x, std::uint32_t y) {
            const glm::dvec2 p = half * (2.0 * (glm::dvec2(x, y) + jitter) / double(kPixels) - 1.0);
            return glm::reflect(camera.forward + p.x * camera.right - p.y * camera.up, normal);
        };
        const auto error = [&](std::uint32_t x, std::uint32_t y) {
            return glm::dvec3(image.at(x, y)) - code(direction(x, y));
        };
        int crossings = 0;
        for (std::uint32_t y = 1; y < kPixels; ++y) {
            for (std::uint32_t x = 1; x < kPixels; ++x) {
                const std::size_t face = face_of(settings.polyhedron, direction(x, y));
                for (const auto& [u, v] : {std::pair(x - 1, y), std::pair(x, y - 1)}) {
                    const std::size_t other = face_of(settings.polyhedron, direction(u, v));
                    if (face == other) continue;
                    ++crossings;
                    const double bound =
                        kTexelError * (change_over_a_texel(settings.polyhedron, face, direction(x, y)) +
                                       change_over_a_texel(settings.polyhedron, other, direction(u, v)));
                    EXPECT_LE(largest(error(x, y) - error(u, v)), bound)
                        << "faces " << face << " and " << other << ", pixel " << x << ' ' << y;
                }
            }
        }
        EXPECT_GE(crossings, static_cast<int>(kPixels) / 2);
    }
}

INSTANTIATE_TEST_SUITE_P(Solids, MapSeams,
                         testing::Values("tetrahedron", "cube", "octahedron", "dodecahedron", "icosahedron"),
                         [](const auto& solid) { return std::string(solid.param); });

}  // namespace
}  // namespace utsuri::test
