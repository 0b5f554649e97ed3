// SPDX-License-Identifier: Apache-2.0
// Damaged files must give a valid scene or an InputError, never a crash or another exception. Meant to run
// under the address and undefined-behaviour sanitizers too.
#include "scene/check_scene.h"

#include "unit/import/gltf_writer.h"

#include <random>

namespace utsuri::test {
namespace {

constexpr std::size_t kVariants = 3000;
constexpr std::mt19937::result_type kSeed = 20240607;

/// A valid .glb with indices, sparse values, a light, a camera, a hierarchy and materials.
Bytes valid_glb(GltfWriter& writer) {
    writer.add_mesh({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0})["material"] = 0;
    writer.primitive()["indices"] = writer.add_accessor<std::uint16_t>({0, 1, 2, 2, 1, 3}, "SCALAR");
    writer.primitive()["attributes"]["NORMAL"] =
        writer.add_accessor<float>({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
    const std::size_t replaced = writer.add_view(bytes_of(std::vector<std::uint8_t>{1}));
    const std::size_t values = writer.add_view(bytes_of(std::vector<float>{2, 0, 0}));
    writer.json["accessors"][0]["sparse"] = {{"count", 1},
                                             {"indices", {{"bufferView", replaced}, {"componentType", 5121}}},
                                             {"values", {{"bufferView", values}}}};
    writer.json["materials"] = Json::array({{{"emissiveFactor", {1, 1, 1}}}});
    writer.json["cameras"] =
        Json::array({{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}}});
    writer.json["extensions"] = {{"KHR_lights_punctual", {{"lights", Json::array({{{"type", "point"}}})}}}};
    writer.add("nodes", {{"children", {0}},
                         {"camera", 0},
                         {"rotation", {0, 0, 0, 1}},
                         {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    writer.json["scenes"] = Json::array({{{"nodes", {1}}}});
    return writer.glb();
}

enum class Outcome { scene, error };

/// What check_scene() says of a scene.
std::string fault_of(const Scene& scene) {
    try {
        check_scene(scene);
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

Outcome import_bytes(const GltfWriter& writer, std::span<const std::byte> bytes) {
    const auto path = write_bytes(writer.folder() / "damaged.glb", bytes);
    try {
        const ImportResult result = import_gltf(path);
        EXPECT_EQ(fault_of(result.scene), "");
        EXPECT_FALSE(result.scene.cameras.empty());
        return Outcome::scene;
    } catch (const Error&) {
        return Outcome::error;
    }
}

TEST(DamagedFiles, UndamagedOneImports) {
    GltfWriter writer;
    EXPECT_EQ(import_bytes(writer, valid_glb(writer)), Outcome::scene);
}

TEST(DamagedFiles, TruncatedAtEveryLength) {
    GltfWriter writer;
    const Bytes glb = valid_glb(writer);
    for (std::size_t length = 0; length < glb.size(); ++length) {
        EXPECT_EQ(import_bytes(writer, std::span(glb).first(length)), Outcome::error) << length << " bytes";
    }
}

TEST(DamagedFiles, FlippedBytes) {
    GltfWriter writer;
    const Bytes glb = valid_glb(writer);
    std::mt19937 random(kSeed);
    std::size_t scenes = 0;
    for (std::size_t variant = 0; variant < kVariants; ++variant) {
        Bytes damaged = glb;
        const std::size_t flips = 1 + random() % 4;
        for (std::size_t i = 0; i < flips; ++i)
            damaged[random() % damaged.size()] = static_cast<std::byte>(random());
        ASSERT_NO_THROW(scenes += import_bytes(writer, damaged) == Outcome::scene ? 1 : 0)
            << "variant " << variant;
    }
    EXPECT_GT(scenes, 0u);
    EXPECT_LT(scenes, kVariants);
}

/// Flips that keep the JSON well-formed reach deeper: digits become other digits.
TEST(DamagedFiles, ChangedDigits) {
    GltfWriter writer;
    const Bytes glb = valid_glb(writer);
    std::vector<std::size_t> digits;
    for (std::size_t i = 20; i < glb.size(); ++i) {
        if (std::isdigit(std::to_integer<unsigned char>(glb[i])) != 0) digits.push_back(i);
    }
    std::mt19937 random(kSeed);
    std::size_t scenes = 0;
    for (std::size_t variant = 0; variant < kVariants; ++variant) {
        Bytes damaged = glb;
        const std::size_t changes = 1 + random() % 3;
        for (std::size_t i = 0; i < changes; ++i) {
            damaged[digits[random() % digits.size()]] = static_cast<std::byte>('0' + random() % 10);
        }
        ASSERT_NO_THROW(scenes += import_bytes(writer, damaged) == Outcome::scene ? 1 : 0)
            << "variant " << variant;
    }
    EXPECT_GT(scenes, 0u);
    EXPECT_LT(scenes, kVariants);
}

}  // namespace
}  // namespace utsuri::test
