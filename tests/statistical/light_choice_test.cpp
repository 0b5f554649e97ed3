// SPDX-License-Identifier: Apache-2.0
// Choosing among lights: the alias table, and that many lights at once give what each gives alone.
#include "renderers/scene/light_table.h"
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

/// Weights over six decades, some zero.
std::vector<double> uneven_weights(std::size_t count, std::uint32_t seed) {
    std::mt19937 engine(seed);
    std::vector<double> weights;
    for (std::size_t i = 0; i < count; ++i) {
        weights.push_back(i % 17 == 5 ? 0.0 : std::pow(10.0, 6.0 * static_cast<double>(engine()) * 0x1p-32));
    }
    return weights;
}

TEST_F(LightChoice, AliasTableHoldsTheProbabilitiesExactly) {
    for (const std::size_t count : {1u, 2u, 7u, 1000u, 100000u}) {
        SCOPED_TRACE(count);
        const std::vector<double> weights = uneven_weights(count, 7);
        std::vector<interop::LightInfo> lights(count);
        make_light_table(weights, lights);
        double sum = 0.0;
        for (const double weight : weights)
            sum += weight;
        std::vector<double> probability(count, 0.0);
        std::vector<double> entries(count, 1.0);
        for (std::size_t i = 0; i < count; ++i) {
            ASSERT_GE(lights[i].threshold, 0.0f);
            ASSERT_LE(lights[i].threshold, 1.0f);
            const double own = static_cast<double>(lights[i].threshold);
            probability[i] += own / static_cast<double>(count);
            ASSERT_LT(lights[i].alias, count);
            probability[lights[i].alias] += (1.0 - own) / static_cast<double>(count);
            entries[lights[i].alias] += 1.0;
        }
        for (std::size_t i = 0; i < count; ++i) {
            // Each entry's threshold is rounded to float32: half a unit of 2^-24 of 1 / count.
            const double rounding = entries[i] * 0x1p-24 / static_cast<double>(count);
            ASSERT_NEAR(probability[i], weights[i] / sum, rounding + 1e-12) << i;
            ASSERT_NEAR(static_cast<double>(lights[i].probability), weights[i] / sum,
                        0x1p-24 * weights[i] / sum);
        }
    }
}

TEST_F(LightChoice, TheDeviceChoosesByTheTable) {
    constexpr std::size_t kLights = 40;
    constexpr std::size_t kSamples = 400000;
    Scene scene;
    std::mt19937 engine(3);
    for (std::size_t i = 0; i < kLights; ++i) {
        Light light;
        light.position = {static_cast<double>(i), 1.0, 0.0};
        light.intensity = glm::vec3(1.0f + static_cast<float>(engine() % 1000));
        scene.lights.push_back(light);
    }
    add(scene, ground(1.0f), lambert(glm::vec3(0.5f)));
    const SceneData data = prepare_scene_data(scene);
    ASSERT_EQ(data.lights.size(), kLights);
    std::vector<double> observed(kLights, 0.0);
    std::vector<double> expected;
    double sum = 0.0;
    for (const Light& light : scene.lights)
        sum += static_cast<double>(light.intensity.x);
    for (const Light& light : scene.lights) {
        expected.push_back(kSamples * static_cast<double>(light.intensity.x) / sum);
    }
    for (const auto& output :
         probe(device(), data, interop::PROBE_LIGHT_CHOICE, {}, random_pairs(kSamples, 300))) {
        ASSERT_LT(output.light, kLights);
        observed[output.light] += 1.0;
    }
    EXPECT_GE(chi_square_p_value(observed, expected), kRejection);
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
