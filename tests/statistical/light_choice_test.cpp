// SPDX-License-Identifier: Apache-2.0
// Choosing among lights: the probabilities, the noise, and that many lights at once give what each gives
// alone.
#include "support/estimate.h"
#include "support/light_scenes.h"
#include "support/test_device.h"

#include "chi_square.h"
#include "probe.h"

#include <cmath>
#include <functional>
#include <random>

namespace utsuri::test {
namespace {

class LightChoice : public DeviceTest {};

/// Lamps and punctual lights of all kinds about a receiver.
Scene many_lights(std::size_t count) {
    Scene scene;
    std::mt19937 engine(3);
    const auto uniform = [&] { return static_cast<double>(engine()) * 0x1p-32; };
    scene.environment = {0.01f, 0.01f, 0.02f};
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3 place(6.0 * uniform() - 3.0, 6.0 * uniform() - 3.0, 6.0 * uniform() - 3.0);
        const auto bright = static_cast<float>(std::pow(10.0, 3.0 * uniform()));
        if (i % 3 == 0) {
            Light light;
            light.type = i % 2 == 0 ? LightType::point : LightType::spot;
            light.position = place;
            light.intensity = glm::vec3(bright);
            scene.lights.push_back(light);
        } else {
            add(scene, ceiling(glm::vec3(place), 0.1f), emitter(glm::vec3(bright)));
            scene.materials.back().double_sided = i % 2 == 0;
        }
    }
    Light sun;
    sun.type = LightType::directional;
    sun.intensity = glm::vec3(2.0f);
    scene.lights.push_back(sun);
    return scene;
}

// Every light with the probability that is told of it, which is the same whether one asks while choosing or
// afterwards.
TEST_F(LightChoice, TheDeviceChoosesByTheProbabilitiesThatItTells) {
    constexpr std::size_t kSamples = 400000;
    for (const std::size_t count : {1u, 2u, 60u}) {
        SCOPED_TRACE(count);
        const SceneData data = prepare_scene_data(many_lights(count));
        interop::ProbePush push{};
        push.position = {0.3f, -0.2f, 0.1f};
        push.normal = glm::normalize(glm::vec3(0.2f, 1.0f, 0.4f));
        std::vector<double> observed(data.lights.size() + 1, 0.0);
        std::vector<double> expected(data.lights.size() + 1, 0.0);
        for (const auto& output :
             probe(device(), data, interop::PROBE_LIGHT_CHOICE, push, random_pairs(kSamples, 300))) {
            if (output.light == interop::NONE) {
                observed.back() += 1.0;
                continue;
            }
            ASSERT_LT(output.light, data.lights.size());
            observed[output.light] += 1.0;
            // Products of at most 32 factors, each of some roundings.
            ASSERT_NEAR(output.weight.x, output.pdf, 1e-5f * output.pdf);
            expected[output.light] = kSamples * static_cast<double>(output.pdf);
        }
        // What is left: that the walk ends where no light reaches the point, and lights too improbable to
        // have been chosen.
        double rest = kSamples;
        for (const double value : expected)
            rest -= value;
        EXPECT_GT(rest, -1e-5 * kSamples);
        expected.back() = std::max(rest, 0.0);
        EXPECT_GE(chi_square_p_value(observed, expected), kRejection);
    }
}

/// A unit square of radiance 1 over the ground, of so many squares along an edge.
Scene tiled_ceiling(int tiles, double height) {
    Scene scene;
    add(scene, ground(2.0f), lambert(glm::vec3(0.8f)));
    const float half = 0.5f / static_cast<float>(tiles);
    for (int i = 0; i < tiles * tiles; ++i) {
        const auto x = static_cast<float>(i % tiles);
        const auto z = static_cast<float>(i / tiles);
        add(scene,
            ceiling({(2.0f * x + 1.0f) * half - 0.5f, static_cast<float>(height),
                     (2.0f * z + 1.0f) * half - 0.5f},
                    half),
            emitter(glm::vec3(1.0f)));
    }
    return scene;
}

// Lights are chosen by about what they bring. Were all of a square's directions equally probable, a sample's
// variance would be a third of its mean's square at most (see area_lights_test.cpp); chosen by power alone it
// is tens of times as large next to many.
TEST_F(LightChoice, NoiseUnderManyLightsIsThatUnderFew) {
    constexpr std::uint32_t kSamples = 256;
    // 256 pixels tell a variance to 2 sqrt(2 / 255), at 4.5 standard errors to 1.4 times of it.
    constexpr double kMostVariance = 1.4 / 3.0;
    for (const int tiles : {1, 4, 32}) {
        for (const double height : {1.0, 0.1, 0.01}) {
            SCOPED_TRACE(testing::Message() << tiles << " tiles along an edge, height " << height);
            Observer observer(device(), tiled_ceiling(tiles, height));
            const Estimate estimate =
                observer.look({2.0 * height, 0.5 * height, 0.0}, {0.0, 0.0, 0.0}, kSamples);
            const double sine = 0.5 / std::hypot(0.5, height);
            const double expected = 4.0 * sine * std::atan(sine) * 0.8 / 3.14159265358979;
            expect_radiance(estimate, expected, 5e-3);
            const double relative = estimate.standard_error.x / expected;
            EXPECT_LE(relative * relative * kSamples * kCloseUpSize * kCloseUpSize, kMostVariance);
        }
    }
}

/// A ground with some blocks on it under lights of every kind. A light that is off keeps its surface.
Scene lit_scene(const std::function<bool(int)>& is_on, const Material& material) {
    Scene scene;
    int light = 0;
    if (is_on(light++)) scene.environment = {0.2f, 0.3f, 0.5f};
    add(scene, ground(4.0f), material);
    add(scene, block({-1, 0, -1}, {-0.5f, 0.8f, -0.5f}), lambert(glm::vec3(0.4f)));
    add(scene, block({0.6f, 0, 0.4f}, {0.9f, 0.5f, 1}), lambert(glm::vec3(0.4f)));
    for (const glm::vec3 centre :
         {glm::vec3(-1, 1.5f, 0), glm::vec3(2, 2, -1), glm::vec3(0, 0.8f, -1.2f), glm::vec3(1.2f, 1, 1)}) {
        const glm::vec3 radiance = is_on(light++) ? glm::vec3(1.0f, 2.0f, 0.5f) * centre.y : glm::vec3(0.0f);
        add(scene, ceiling(centre, 0.3f), emitter(radiance));
    }
    const auto punctual = [&](LightType type, glm::dvec3 position, float intensity) {
        Light result;
        result.type = type;
        result.position = position;
        result.direction = -position / std::sqrt(position.x * position.x + position.y * position.y +
                                                 position.z * position.z);
        result.intensity = glm::vec3(intensity, 0.5f * intensity, intensity);
        if (is_on(light++)) scene.lights.push_back(result);
    };
    punctual(LightType::point, {0.5, 1.2, 0.3}, 0.5f);
    punctual(LightType::point, {-2.0, 0.6, 1.5}, 0.8f);
    punctual(LightType::spot, {1.5, 2.0, -0.5}, 2.0f);
    punctual(LightType::directional, {0.3, 1.0, -0.6}, 0.7f);
    return scene;
}

constexpr int kAllLights = 9;

/// The whole against the sum of its parts, in standard errors, at points with and without shadows.
void expect_additive(Device& device, const Material& material, int count) {
    const std::vector<glm::dvec3> targets = {{0, 0, 0}, {-0.4, 0, -1.1}, {0.95, 0, 0.2}};
    const auto looks = [&](const std::function<bool(int)>& is_on) {
        Observer observer(device, lit_scene(is_on, material));
        std::vector<Estimate> estimates;
        for (const glm::dvec3& target : targets)
            estimates.push_back(observer.look({0.5, 3, 3}, target, 512));
        return estimates;
    };
    const std::vector<Estimate> together = looks([&](int light) { return light < count; });
    std::vector<glm::dvec3> sum(targets.size(), glm::dvec3(0.0));
    std::vector<glm::dvec3> variance(targets.size(), glm::dvec3(0.0));
    for (int light = 0; light < count; ++light) {
        const std::vector<Estimate> alone = looks([&](int other) { return other == light; });
        for (std::size_t i = 0; i < targets.size(); ++i) {
            sum[i] += alone[i].mean;
            variance[i] += alone[i].standard_error * alone[i].standard_error;
        }
    }
    for (std::size_t i = 0; i < targets.size(); ++i) {
        for (int channel = 0; channel < 3; ++channel) {
            const double error = together[i].standard_error[channel];
            const double deviation = std::sqrt(variance[i][channel] + error * error);
            const double size = sum[i][channel];
            EXPECT_LE(deviation, 5e-3 * size) << "too noisy to tell";
            EXPECT_NEAR(together[i].mean[channel], size, kSigmas * deviation + kRounding * size)
                << "target " << i;
        }
    }
}

// One environment, eight light triangles and four punctual lights: more than are weighed against each other
// at once.
TEST_F(LightChoice, ManyLightsGiveTheSumOfEach) {
    Material plastic;
    plastic.base_colour = glm::vec3(0.6f);
    plastic.metallic = 0.0f;
    plastic.roughness = 0.5f;
    expect_additive(device(), plastic, kAllLights);
}

TEST_F(LightChoice, FewLightsGiveTheSumOfEach) {
    expect_additive(device(), lambert(glm::vec3(0.6f)), 3);
}

}  // namespace
}  // namespace utsuri::test
