// SPDX-License-Identifier: Apache-2.0
#include "import/document/document.h"

#include "import/document/extensions.h"
#include "import/document/layout.h"
#include "import/document/schema.h"

#include <fmt/format.h>

#include <string>

namespace utsuri {
namespace {

using Json = nlohmann::json;

/// Deeper than any glTF needs (about ten), shallow enough for the parsers' recursion.
constexpr int kMaxNesting = 128;

Json parse_json(const SourceFile& file, std::string_view text) {
    const auto limit_nesting = [&](int depth, Json::parse_event_t, Json&) {
        if (depth > kMaxNesting) {
            file.fail("", fmt::format("JSON nested more than {} deep; glTF needs about ten", kMaxNesting));
        }
        return true;
    };
    try {
        return Json::parse(text.begin(), text.end(), limit_nesting);
    } catch (const Json::exception& error) {
        // "[json.exception.parse_error.101] parse error at line 1, column 2: ..."
        const std::string message = error.what();
        const std::size_t start = message.find("] ");
        file.fail("", fmt::format("not valid JSON: {}",
                                  start == std::string::npos ? message : message.substr(start + 2)));
    }
}

/// The number before the dot of "2.0", or -1 if the text has another form.
int major_version(const std::string& version) {
    const std::size_t dot = version.find('.');
    const auto digits = [](std::string_view text) {
        return !text.empty() && text.size() < 5 &&
               text.find_first_not_of("0123456789") == std::string_view::npos;
    };
    if (dot == std::string::npos || !digits(version.substr(0, dot)) || !digits(version.substr(dot + 1)))
        return -1;
    return std::stoi(version.substr(0, dot));
}

void check_version(const SourceFile& file, const Json& json) {
    if (!json.is_object()) file.fail("", "the JSON is not an object; must be a glTF 2.0 object");
    const Json::json_pointer version_at("/asset/version");
    if (!json.contains("asset") || !json["asset"].is_object()) {
        file.fail("asset", "missing or not an object; must hold the version of the file, such as \"2.0\"");
    }
    if (!json.contains(version_at) || !json[version_at].is_string()) {
        file.fail("asset.version", "missing or not a string; must be 2.x, such as \"2.0\"");
    }
    const std::string version = json[version_at].get<std::string>();
    if (major_version(version) != 2) {
        file.fail("asset.version", fmt::format("is \"{}\"; must be 2.x, such as \"2.0\"", version));
    }
    const Json::json_pointer minimum_at("/asset/minVersion");
    if (json.contains(minimum_at) && json[minimum_at] != "2.0") {
        file.fail("asset.minVersion", fmt::format("is {}; must be \"2.0\"", json[minimum_at].dump()));
    }
}

/// The parser refuses index accessors that are all zeros or sparse over zeros.
void check_index_accessors(const SourceFile& file, const Json& json) {
    if (!json.contains("meshes")) return;
    const Json& meshes = json["meshes"];
    for (std::size_t m = 0; m < meshes.size(); ++m) {
        const Json& primitives = meshes[m]["primitives"];
        for (std::size_t p = 0; p < primitives.size(); ++p) {
            if (!primitives[p].contains("indices")) continue;
            const std::size_t accessor = primitives[p]["indices"];
            if (json["accessors"][accessor].contains("bufferView")) continue;
            file.fail(fmt::format("accessors[{}].bufferView", accessor),
                      fmt::format("missing; meshes[{}].primitives[{}].indices requires it", m, p));
        }
    }
}

/// What a table of independent properties cannot say.
void check_dependent_properties(const SourceFile& file, const Json& json) {
    const Json none = Json::array();
    check_index_accessors(file, json);
    const Json cameras = json.value("cameras", none);
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        const std::string type = cameras[i]["type"];
        if (!cameras[i].contains(type))
            file.fail(fmt::format("cameras[{}].{}", i, type), "missing; the type requires it");
    }
    const Json lights = extension_of(json, "KHR_lights_punctual").value("lights", none);
    for (std::size_t i = 0; i < lights.size(); ++i) {
        if (lights[i]["type"] == "spot" && !lights[i].contains("spot")) {
            file.fail(fmt::format("extensions.KHR_lights_punctual.lights[{}].spot", i),
                      "missing; the type requires it");
        }
    }
}

/// Resources are read by the importer itself: exact messages, only what is used, and no search in the working
/// directory. What is left out is neither read from disk nor decoded by the parser.
tinygltf::Model typed_model(const SourceFile& file, Json json) {
    for (const char* left_out : {"buffers", "images", "skins", "animations", "extras"})
        json.erase(left_out);
    const std::string text = json.dump();
    tinygltf::TinyGLTF parser;
    tinygltf::Model model;
    std::string error;
    std::string warning;
    const auto size = static_cast<unsigned int>(text.size());
    if (size != text.size()) file.fail("", "more than 4 GiB of JSON; large data belongs into buffers");
    if (!parser.LoadASCIIFromString(&model, &error, &warning, text.c_str(), size, "")) {
        while (!error.empty() && error.back() == '\n')
            error.pop_back();
        file.fail("", fmt::format("the glTF parser says: {}; must follow the glTF 2.0 specification", error));
    }
    return model;
}

}  // namespace

const Json& extension_of(const Json& parent, const char* name) {
    static const Json empty = Json::object();
    const auto extensions = parent.find("extensions");
    if (extensions == parent.end() || !extensions->is_object()) return empty;
    const auto found = extensions->find(name);
    return found != extensions->end() && found->is_object() ? *found : empty;
}

Document load_document(const std::filesystem::path& path) {
    Document document;
    document.file.path = path;
    document.container = read_container(document.file);
    document.json = parse_json(document.file, document.container.json);
    check_version(document.file, document.json);
    check_required_extensions(document.file, document.json);
    check_schema(document.file, document.json);
    check_dependent_properties(document.file, document.json);
    check_layout(document.file, document.json);
    document.model = typed_model(document.file, document.json);
    return document;
}

}  // namespace utsuri
