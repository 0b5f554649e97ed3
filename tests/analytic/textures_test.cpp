// SPDX-License-Identifier: Apache-2.0
// Texture lookups: wrap modes, filters, the sRGB curve and what each slot does, against their definitions.
#include "support/estimate.h"
#include "support/light_scenes.h"
#include "support/test_device.h"

#include <array>
#include <cmath>
#include <numbers>

namespace utsuri::test {
namespace {

constexpr double kPi = std::numbers::pi;
/// The sRGB curve goes through the device's pow(), which Vulkan binds to exp2(x log2 y): some dozens of units
/// in the last place. A gamma of 2.2 instead would be wrong by percents.
constexpr double kCurveError = 1e-4;

class Textures : public DeviceTest {};

double srgb_decoded(double coded) {
    return coded <= 0.04045 ? coded / 12.92 : std::pow((coded + 0.055) / 1.055, 2.4);
}

constexpr int kWidth = 4;
constexpr int kHeight = 2;

/// Red tells the column, green the row, blue is dark enough for the straight part of the curve.
Texture test_texture() {
    Texture texture;
    texture.width = kWidth;
    texture.height = kHeight;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const auto column = static_cast<std::uint8_t>(20 + 70 * x);
            const auto row = static_cast<std::uint8_t>(200 - 130 * y);
            texture.rgba.insert(texture.rgba.end(),
                                {column, row, static_cast<std::uint8_t>(2 + x + 4 * y), 255});
        }
    }
    return texture;
}

glm::dvec3 texel(int x, int y) {
    return {srgb_decoded((20 + 70 * x) / 255.0), srgb_decoded((200 - 130 * y) / 255.0),
            srgb_decoded((2 + x + 4 * y) / 255.0)};
}

/// By the definitions of glTF: repeat is the fraction, mirrored repeat a triangle wave of period 2.
int wrapped(int i, int size, TextureWrap wrap) {
    if (wrap == TextureWrap::clamp_to_edge) return std::clamp(i, 0, size - 1);
    const int repeats = static_cast<int>(std::floor(static_cast<double>(i) / size));
    const int within = i - repeats * size;
    return wrap == TextureWrap::mirrored_repeat && repeats % 2 != 0 ? size - 1 - within : within;
}

glm::dvec3 nearest(glm::dvec2 uv, const TextureSlot& slot) {
    return texel(wrapped(static_cast<int>(std::floor(uv.x * kWidth)), kWidth, slot.wrap_s),
                 wrapped(static_cast<int>(std::floor(uv.y * kHeight)), kHeight, slot.wrap_t));
}

glm::dvec3 linear(glm::dvec2 uv, const TextureSlot& slot) {
    const glm::dvec2 at = uv * glm::dvec2(kWidth, kHeight) - 0.5;
    glm::dvec3 sum(0.0);
    for (int dy = 0; dy < 2; ++dy) {
        for (int dx = 0; dx < 2; ++dx) {
            const int x = static_cast<int>(std::floor(at.x)) + dx;
            const int y = static_cast<int>(std::floor(at.y)) + dy;
            const double weight = (1.0 - std::abs(at.x - x)) * (1.0 - std::abs(at.y - y));
            sum += weight * texel(wrapped(x, kWidth, slot.wrap_s), wrapped(y, kHeight, slot.wrap_t));
        }
    }
    return sum;
}

/// A square facing +z on which the texture coordinate at (x, y, 0) is (x, 1 - y), for x and y in [-2, 3].
Mesh textured_square() {
    Mesh mesh = quad({-2, -2, 0}, {5, 0, 0}, {0, 5, 0});
    mesh.texcoords = {{-2, 3}, {3, 3}, {3, -2}, {-2, -2}};
    return mesh;
}

glm::dvec3 shown_at(Observer& observer, glm::dvec2 uv, std::uint32_t samples = 4) {
    const glm::dvec3 point(uv.x, 1.0 - uv.y, 0.0);
    return observer.look(point + glm::dvec3(0.0, 0.0, 2.0), point, samples).mean;
}

void expect_colour(const glm::dvec3& shown, const glm::dvec3& expected) {
    for (int channel = 0; channel < 3; ++channel) {
        EXPECT_NEAR(shown[channel], expected[channel], kCurveError * expected[channel])
            << "channel " << channel;
    }
}

/// Inside the picture, and outside on every side; off the edges of texels by more than a close-up's width.
constexpr std::array<glm::dvec2, 7> kPlaces = {
    {{0.1, 0.2}, {0.66, 0.7}, {1.1, 0.3}, {2.7, 1.8}, {-0.2, 0.6}, {-1.4, -0.9}, {0.97, -0.1}}};

Scene emitting_square(const TextureSlot& slot) {
    Scene scene;
    scene.textures.push_back(test_texture());
    Material material = emitter(glm::vec3(1.0f));
    material.emissive_texture = slot;
    material.emissive_texture.texture = 0;
    add(scene, textured_square(), material);
    return scene;
}

TEST_F(Textures, WrapModesWithBothFilters) {
    const TextureWrap repeat = TextureWrap::repeat;
    const TextureWrap clamp = TextureWrap::clamp_to_edge;
    const TextureWrap mirrored = TextureWrap::mirrored_repeat;
    for (const auto& [s, t] :
         {std::pair(repeat, mirrored), std::pair(clamp, repeat), std::pair(mirrored, clamp)}) {
        for (const TextureFilter filter : {TextureFilter::nearest, TextureFilter::linear}) {
            const TextureSlot slot{0, s, t, filter};
            Observer observer(device(), emitting_square(slot));
            for (const glm::dvec2& uv : kPlaces) {
                SCOPED_TRACE(testing::Message()
                             << "wrap " << static_cast<int>(s) << ' ' << static_cast<int>(t) << ", filter "
                             << static_cast<int>(filter) << ", at " << uv.x << ' ' << uv.y);
                expect_colour(shown_at(observer, uv),
                              filter == TextureFilter::nearest ? nearest(uv, slot) : linear(uv, slot));
            }
        }
    }
}

// In the furnace a Lambert surface shows its base colour times the factor.
TEST_F(Textures, BaseColourTextureScalesTheFactor) {
    Scene scene;
    scene.environment = glm::vec3(1.0f);
    scene.textures.push_back(test_texture());
    Material material = lambert({1.0f, 0.5f, 0.25f});
    material.base_colour_texture.texture = 0;
    add(scene, textured_square(), material);
    Observer observer(device(), scene);
    for (const glm::dvec2 uv : {glm::dvec2(0.1, 0.2), glm::dvec2(0.66, 0.7)}) {
        expect_colour(shown_at(observer, uv),
                      glm::dvec3(1.0, 0.5, 0.25) * linear(uv, material.base_colour_texture));
    }
}

// Green is roughness, blue is metallic, and neither is sRGB coded: bytes 0 and 51 make a mirror, a fifth of
// it metal. Straight on it shows 4/5 (0.04 + 0.96 base) + 1/5 base.
TEST_F(Textures, MetallicRoughnessTextureIsLinear) {
    Scene scene;
    scene.environment = glm::vec3(1.0f);
    Texture texture;
    texture.width = texture.height = 1;
    texture.rgba = {255, 0, 51, 255};
    scene.textures.push_back(texture);
    Material material;
    material.base_colour = glm::vec3(0.5f);
    material.metallic_roughness_texture.texture = 0;
    add(scene, textured_square(), material);
    Observer observer(device(), scene);
    expect_colour(shown_at(observer, {0.5, 0.5}), glm::dvec3(0.8 * (0.04 + 0.96 * 0.5) + 0.2 * 0.5));
    EXPECT_GT(observer.counts().lookups, 0u);
}

// Far below a unit square the light is the mean radiance times 9.99999667e-7 (Lambert's sum at height 1000),
// wherever on the square it comes from.
TEST_F(Textures, LightOfAnEmissiveTextureIsItsMean) {
    // The steps between texels cost more samples than a smooth light does.
    constexpr double kTexturedPower = 1e-3;
    Scene scene;
    scene.textures.push_back(test_texture());
    Material material = emitter({2.0f, 3.0f, 50.0f});
    material.emissive_texture.texture = 0;
    material.emissive_texture.filter = TextureFilter::nearest;
    add(scene, ground(2.0f), lambert(glm::vec3(1.0f)));
    add(scene, ceiling({0, 1000, 0}, 0.5f), material);
    glm::dvec3 mean(0.0);
    for (int i = 0; i < kWidth * kHeight; ++i)
        mean += texel(i % kWidth, i / kWidth) / double{kWidth * kHeight};
    const Estimate estimate = Observer(device(), scene).look({1, 1, 0.5}, {0, 0, 0}, 4096);
    const glm::dvec3 expected = glm::dvec3(2.0, 3.0, 50.0) * mean * 9.99999667e-7 / kPi;
    for (int channel = 0; channel < 3; ++channel) {
        EXPECT_LE(estimate.standard_error[channel], kTexturedPower * expected[channel]);
        EXPECT_NEAR(estimate.mean[channel], expected[channel],
                    kSigmas * estimate.standard_error[channel] + kCurveError * expected[channel]);
    }
}

}  // namespace
}  // namespace utsuri::test
