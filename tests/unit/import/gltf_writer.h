// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "import/conversion/gltf.h"

#include "base/error.h"

#include <fmt/format.h>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace utsuri::test {

using Json = nlohmann::json;
using Bytes = std::vector<std::byte>;

/// A folder of its own for the running test, removed at the end.
class TemporaryFolder {
  public:
    TemporaryFolder() {
        const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
        std::string name = fmt::format("utsuri_import_{}_{}", test->test_suite_name(), test->name());
        for (char& c : name)
            c = c == '/' ? '_' : c;
        std::string pattern = (std::filesystem::temp_directory_path() / (name + "_XXXXXX")).string();
        path_ = ::mkdtemp(pattern.data());
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

template <class Value>
Bytes bytes_of(const std::vector<Value>& values) {
    Bytes bytes(values.size() * sizeof(Value));
    if (!bytes.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

inline Bytes bytes_of(std::string_view text) {
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

inline std::filesystem::path write_bytes(const std::filesystem::path& path,
                                         std::span<const std::byte> bytes) {
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    return path;
}

inline std::string base64_encode(std::span<const std::byte> bytes) {
    constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            bits = (bits << 8) | (i + k < bytes.size() ? std::to_integer<std::uint32_t>(bytes[i + k]) : 0u);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            const bool padding = i + k > bytes.size();
            text += padding ? '=' : kDigits[(bits >> (18 - 6 * k)) & 63u];
        }
    }
    return text;
}

/// The chunks of a .glb; `bin` may be empty.
inline Bytes glb_bytes(std::string json, Bytes bin) {
    while (json.size() % 4 != 0)
        json += ' ';
    bin.resize((bin.size() + 3) / 4 * 4);
    Bytes glb;
    const auto append_u32 = [&](std::size_t value) {
        for (int i = 0; i < 4; ++i)
            glb.push_back(static_cast<std::byte>((value >> (8 * i)) & 0xFFu));
    };
    const std::size_t bin_chunk = bin.empty() ? 0 : 8 + bin.size();
    append_u32(0x46546C67u);
    append_u32(2);
    append_u32(12 + 8 + json.size() + bin_chunk);
    append_u32(json.size());
    append_u32(0x4E4F534Au);
    const Bytes text = bytes_of(std::string_view(json));
    glb.insert(glb.end(), text.begin(), text.end());
    if (!bin.empty()) {
        append_u32(bin.size());
        append_u32(0x004E4942u);
        glb.insert(glb.end(), bin.begin(), bin.end());
    }
    return glb;
}

/// Component types by glTF's numbers.
template <class Component>
constexpr int component_type() {
    if constexpr (std::is_same_v<Component, std::int8_t>) return 5120;
    if constexpr (std::is_same_v<Component, std::uint8_t>) return 5121;
    if constexpr (std::is_same_v<Component, std::int16_t>) return 5122;
    if constexpr (std::is_same_v<Component, std::uint16_t>) return 5123;
    if constexpr (std::is_same_v<Component, std::uint32_t>) return 5125;
    return 5126;
}

/// Builds a glTF file in memory: one buffer, and JSON that a test may change at will before writing.
class GltfWriter {
  public:
    Json json = {{"asset", {{"version", "2.0"}}}};
    Bytes bin;

    /// Appends to `list` at the root; returns the index.
    std::size_t add(const char* list, Json object) {
        json[list].push_back(std::move(object));
        return json[list].size() - 1;
    }

    std::size_t add_view(const Bytes& bytes, std::size_t stride = 0) {
        bin.resize((bin.size() + 3) / 4 * 4);
        Json view = {{"buffer", 0}, {"byteOffset", bin.size()}, {"byteLength", bytes.size()}};
        if (stride != 0) view["byteStride"] = stride;
        bin.insert(bin.end(), bytes.begin(), bytes.end());
        return add("bufferViews", view);
    }

    /// An accessor of its own view, tightly packed. `components` holds all components of all elements.
    template <class Component>
    std::size_t add_accessor(const std::vector<Component>& components, const char* type,
                             bool normalized = false) {
        const std::string name = type;
        const std::size_t per_element = name == "SCALAR" ? 1 : static_cast<std::size_t>(name.back() - '0');
        return add("accessors", {{"bufferView", add_view(bytes_of(components))},
                                 {"componentType", component_type<Component>()},
                                 {"count", components.size() / per_element},
                                 {"normalized", normalized},
                                 {"type", type}});
    }

    /// A mesh of one primitive with positions only, and a node that carries it. Returns the primitive.
    Json& add_mesh(const std::vector<float>& positions) {
        const std::size_t accessor = add_accessor(positions, "VEC3");
        return add_mesh_of(accessor);
    }

    Json& add_mesh_of(std::size_t position_accessor) {
        const std::size_t mesh =
            add("meshes", {{"primitives", {{{"attributes", {{"POSITION", position_accessor}}}}}}});
        add("nodes", {{"mesh", mesh}});
        return json["meshes"][mesh]["primitives"][0];
    }

    /// The unit right triangle in the plane z = 0, front towards +Z.
    Json& add_triangle() { return add_mesh({0, 0, 0, 1, 0, 0, 0, 1, 0}); }

    Json& primitive() { return json["meshes"][0]["primitives"][0]; }

    std::filesystem::path write_gltf() {
        if (!bin.empty() && !json.contains("buffers")) {
            const std::string uri = "data:application/octet-stream;base64," + base64_encode(bin);
            json["buffers"] = {{{"byteLength", bin.size()}, {"uri", uri}}};
        }
        return write_bytes(folder_.path() / "scene.gltf", bytes_of(std::string_view(json.dump())));
    }

    Bytes glb() {
        if (!bin.empty() && !json.contains("buffers")) json["buffers"] = {{{"byteLength", bin.size()}}};
        return glb_bytes(json.dump(), bin);
    }

    std::filesystem::path write_glb() { return write_bytes(folder_.path() / "scene.glb", glb()); }

    [[nodiscard]] const std::filesystem::path& folder() const { return folder_.path(); }

    ImportResult import() { return import_gltf(write_gltf()); }

  private:
    TemporaryFolder folder_;
};

/// The message of the InputError that importing throws, or an empty string if it does not throw.
inline std::string import_error(const std::filesystem::path& path) {
    try {
        import_gltf(path);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

inline std::string import_error(GltfWriter& writer) {
    return import_error(writer.write_gltf());
}

/// Closest two vectors get when they are equal up to a few roundings of float32.
constexpr float kFloatTolerance = 1e-6f;

inline void expect_near(glm::dvec3 value, glm::dvec3 expected, double tolerance) {
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(value[c], expected[c], tolerance) << "component " << c;
}

}  // namespace utsuri::test
