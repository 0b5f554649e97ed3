// SPDX-License-Identifier: Apache-2.0
// Each sampling function against its density: chi-square tests of where samples fall, and the density it
// tells against the formula in float64.
#include "support/light_scenes.h"
#include "support/test_device.h"

#include "chi_square.h"
#include "probe.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace utsuri::test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr std::size_t kSamples = 100000;
/// Relative error of a density computed in float32 from directions that are not near-singular: class D and a
/// few of the polynomial sine's 2e-7.
constexpr double kPdfError = 1e-5;

class Sampling : public DeviceTest {};

/// An orthonormal basis about n with x towards the projection of `towards`.
struct Basis {
    glm::dvec3 x, y, z;
    Basis(const glm::dvec3& n, const glm::dvec3& towards) : z(n) {
        const glm::dvec3 flat = towards - glm::dot(towards, n) * n;
        const glm::dvec3 any = std::abs(n.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
        x = glm::length(flat) > 1e-6 ? glm::normalize(flat) : glm::normalize(glm::cross(any, n));
        y = glm::cross(z, x);
    }
    [[nodiscard]] glm::dvec3 local(const glm::dvec3& v) const {
        return {glm::dot(v, x), glm::dot(v, y), glm::dot(v, z)};
    }
};

std::size_t bin_of(double fraction, std::size_t bins) {
    return std::min(static_cast<std::size_t>(std::max(fraction, 0.0) * static_cast<double>(bins)), bins - 1);
}

double turn_of(double y, double x) {
    const double turn = std::atan2(y, x) / (2.0 * kPi);
    return turn < 0.0 ? turn + 1.0 : turn;
}

constexpr std::size_t kRings = 8;
constexpr std::size_t kSectors = 16;

double smith_g1(double cosine, double alpha) {
    return 2.0 * cosine / (cosine + std::sqrt(cosine * cosine + alpha * alpha * (1.0 - cosine * cosine)));
}

/// Mass of the visible normals of GGX in rings of equal q = tan^2 / (tan^2 + alpha^2) and sectors of azimuth,
/// wo at azimuth 0. There D(h) cos(h) dw is dq dphi / 2 pi, so the density is G1 (wo.h)+ / (cos_o cos_h).
/// Midpoint rule in s = sqrt(1 - q), in which the tangent's pole at q = 1 cancels.
std::vector<double> visible_normal_mass(double cos_o, double alpha) {
    constexpr int kSteps = 48;
    const double sin_o = std::sqrt(1.0 - cos_o * cos_o);
    std::vector<double> mass(kRings * kSectors, 0.0);
    for (std::size_t ring = 0; ring < kRings; ++ring) {
        const double outer = std::sqrt(1.0 - static_cast<double>(ring + 1) / kRings);
        const double inner = std::sqrt(1.0 - static_cast<double>(ring) / kRings);
        const double ds = (inner - outer) / kSteps;
        for (std::size_t sector = 0; sector < kSectors; ++sector) {
            for (int i = 0; i < kSteps * kSteps; ++i) {
                const double s = outer + (i / kSteps + 0.5) * ds;
                const double phi =
                    2.0 * kPi * (static_cast<double>(sector) + (i % kSteps + 0.5) / kSteps) / kSectors;
                const double tangent = alpha * std::sqrt(1.0 - s * s) / s;
                const double visible = std::max(cos_o + sin_o * tangent * std::cos(phi), 0.0) / cos_o;
                mass[ring * kSectors + sector] += visible * 2.0 * s * ds / (kSteps * kSectors);
            }
        }
    }
    for (double& cell : mass)
        cell *= smith_g1(cos_o, alpha);
    return mass;
}

struct GlossyCase {
    double alpha;
    double cos_o;
    glm::dvec3 normal;
};

void expect_visible_normals(Device& device, const SceneData& data, const GlossyCase& c, std::uint32_t seed) {
    const Basis basis(c.normal, {0.3, -0.2, 0.9});
    const glm::dvec3 wo = std::sqrt(1.0 - c.cos_o * c.cos_o) * basis.x + c.cos_o * basis.z;
    interop::ProbePush push{};
    push.normal = glm::vec3(c.normal);
    push.wo = glm::vec3(wo);
    push.alpha = static_cast<float>(c.alpha);
    const auto outputs = probe(device, data, interop::PROBE_GLOSSY, push, random_pairs(kSamples, seed));
    std::vector<double> observed(kRings * kSectors, 0.0);
    double largest_error = 0.0;
    for (const interop::ProbeOutput& output : outputs) {
        const glm::dvec3 h = basis.local(glm::normalize(wo + glm::dvec3(output.direction)));
        const double tangent2 = (h.x * h.x + h.y * h.y) / (h.z * h.z);
        const double q = tangent2 / (tangent2 + c.alpha * c.alpha);
        observed[bin_of(q, kRings) * kSectors + bin_of(turn_of(h.y, h.x), kSectors)] += 1.0;
        const double d =
            c.alpha * c.alpha / (kPi * std::pow(c.alpha * c.alpha * h.z * h.z + h.x * h.x + h.y * h.y, 2.0));
        const double pdf = smith_g1(c.cos_o, c.alpha) * d / (4.0 * c.cos_o);
        // D changes by at most 2 / alpha a radian. Directions of float32 are uncertain by some units of
        // 2^-24, and h is by as much over the length of wo + wi.
        const double length = glm::length(wo + glm::dvec3(output.direction));
        const double allowed = kPdfError + 16.0 * 0x1p-24 / length * 2.0 / c.alpha;
        largest_error =
            std::max(largest_error, std::abs(static_cast<double>(output.pdf) / pdf - 1.0) / allowed);
    }
    std::vector<double> expected = visible_normal_mass(c.cos_o, c.alpha);
    double sum = 0.0;
    for (double& cell : expected) {
        sum += cell;
        cell *= static_cast<double>(kSamples);
    }
    EXPECT_NEAR(sum, 1.0, 1e-3) << "the density's own integral";
    EXPECT_GE(chi_square_p_value(observed, expected), kRejection);
    EXPECT_LE(largest_error, 1.0) << "of the density, in units of what is allowed";
}

TEST_F(Sampling, GlossyDirectionsFollowTheVisibleNormals) {
    Scene scene;
    add(scene, ground(1.0f), glossy_metal(0.5f));
    const SceneData data = prepare_scene_data(scene);
    const glm::dvec3 tilted = glm::normalize(glm::dvec3(0.4, -0.7, -0.3));
    std::uint32_t seed = 1;
    for (const double alpha : {0.01, 0.1, 0.5, 1.0}) {
        for (const double cos_o : {1.0, 0.6, 0.1}) {
            SCOPED_TRACE(testing::Message() << "alpha " << alpha << ", cosine " << cos_o);
            expect_visible_normals(device(), data,
                                   {alpha, cos_o, seed % 2 == 0 ? tilted : glm::dvec3(0, 0, 1)}, seed);
            ++seed;
        }
    }
}

/// Directions above a surface, and the densities that they come with: cosine over pi.
void expect_cosine_density(const std::vector<interop::ProbeOutput>& outputs, const Basis& basis) {
    std::vector<double> observed(kRings * kSectors, 0.0);
    const std::vector<double> expected(kRings * kSectors,
                                       static_cast<double>(kSamples) / (kRings * kSectors));
    for (const interop::ProbeOutput& output : outputs) {
        const glm::dvec3 w = basis.local(glm::dvec3(output.direction));
        observed[bin_of(1.0 - w.z * w.z, kRings) * kSectors + bin_of(turn_of(w.y, w.x), kSectors)] += 1.0;
        // Near the horizon the cosine, of some 2^-23 absolute error, has few digits.
        ASSERT_NEAR(static_cast<double>(output.pdf), w.z / kPi, kPdfError * w.z / kPi + 0x1p-22);
    }
    EXPECT_GE(chi_square_p_value(observed, expected), kRejection);
}

TEST_F(Sampling, EnvironmentDirectionsFollowTheCosine) {
    Scene scene;
    scene.environment = glm::vec3(1.0f);
    add(scene, ground(1.0f), lambert(glm::vec3(0.5f)));
    const SceneData data = prepare_scene_data(scene);
    std::uint32_t seed = 100;
    for (const glm::dvec3 normal :
         {glm::dvec3(0, 0, 1), glm::dvec3(0, 0, -1), glm::normalize(glm::dvec3(1, 2, -0.5))}) {
        const Basis basis(normal, {0.2, 0.5, 0.7});
        interop::ProbePush push{};
        push.normal = glm::vec3(normal);
        push.wo = push.normal;
        const auto outputs =
            probe(device(), data, interop::PROBE_LIGHT, push, random_pairs(kSamples, seed++));
        expect_cosine_density(outputs, basis);
    }
}

/// Numbers of lib/lobes/lobes.glsl.
constexpr std::uint32_t kDiffuseLobe = 0;
constexpr std::uint32_t kGlossyLobe = 1;

TEST_F(Sampling, DiffuseDirectionsFollowTheCosine) {
    Scene scene;
    add(scene, ground(1.0f), glossy_metal(0.5f));
    const SceneData data = prepare_scene_data(scene);
    const glm::dvec3 normal = glm::normalize(glm::dvec3(1, 2, -0.5));
    const Basis basis(normal, {0.2, 0.5, 0.7});
    interop::ProbePush push{};
    push.normal = glm::vec3(normal);
    push.wo = glm::vec3(glm::normalize(normal + 0.5 * basis.x));
    push.alpha = 0.3f;
    push.lobe = kDiffuseLobe;
    const auto outputs = probe(device(), data, interop::PROBE_LOBE, push, random_pairs(kSamples, 300));
    expect_cosine_density(outputs, basis);
}

// A sample's throughput is value times cosine over density, whatever cancels on the way. D(h) is taken from h
// twice; it changes by at most 2 / alpha a radian, and h is known to some units of 2^-24.
TEST_F(Sampling, ThroughputsOfLobesAreTheirValuesOverTheirDensities) {
    Scene scene;
    add(scene, ground(1.0f), glossy_metal(0.5f));
    const SceneData data = prepare_scene_data(scene);
    for (const std::uint32_t lobe : {kDiffuseLobe, kGlossyLobe}) {
        for (const float alpha : {0.05f, 0.3f, 1.0f}) {
            interop::ProbePush push{};
            push.normal = {0, 0, 1};
            push.wo = glm::normalize(glm::vec3(0.6f, -0.3f, 0.5f));
            push.alpha = alpha;
            push.lobe = lobe;
            const double allowed = kPdfError + 64.0 * 0x1p-24 / static_cast<double>(alpha);
            int above = 0;
            for (const interop::ProbeOutput& output :
                 probe(device(), data, interop::PROBE_LOBE, push, random_pairs(1000, 400 + lobe))) {
                if (output.pdf == 0.0f) continue;
                ++above;
                for (int c = 0; c < 3; ++c) {
                    const auto value = static_cast<double>(output.target[c]);
                    ASSERT_NEAR(static_cast<double>(output.weight[c]), value, allowed * value)
                        << "lobe " << lobe << ", alpha " << alpha;
                }
            }
            EXPECT_GT(above, 500);
        }
    }
}

// Seen from its front, what is behind a surface has its index of refraction; from behind, the other way
// round.
TEST_F(Sampling, SurfacesKnowTheirSideAndTheirRatioOfIndices) {
    Scene scene;
    Material glass = glossy_metal(0.5f);
    glass.ior = 1.5f;
    add(scene, ground(1.0f), glass);
    const SceneData data = prepare_scene_data(scene);
    for (const bool from_front : {true, false}) {
        interop::ProbePush push{};
        push.wo = glm::normalize(glm::vec3(0.2f, from_front ? 1.0f : -1.0f, 0.3f));
        const auto found = probe(device(), data, interop::PROBE_SURFACE, push, random_pairs(1, 1)).front();
        EXPECT_EQ(found.light, from_front ? 1u : 0u);
        EXPECT_NEAR(static_cast<double>(found.pdf), from_front ? 1.5 : 1.0 / 1.5, 1e-7);
        EXPECT_GT(glm::dot(found.direction, push.wo), 0.0f) << "the normal is on the viewer's side";
    }
}

}  // namespace
}  // namespace utsuri::test
