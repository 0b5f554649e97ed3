// SPDX-License-Identifier: Apache-2.0
#include "unit/import/gltf_writer.h"

#include <map>

namespace utsuri::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// A file that has one of everything that has or is an index.
Json file_of_everything(GltfWriter& writer) {
    writer.add_triangle()["material"] = 0;
    writer.primitive()["indices"] = writer.add_accessor<std::uint8_t>({0, 1, 2}, "SCALAR");
    writer.primitive()["targets"] = Json::array({{{"POSITION", 0}}});
    writer.json["materials"] =
        Json::array({{{"pbrMetallicRoughness",
                       {{"baseColorTexture", {{"index", 0}, {"texCoord", 1}}},
                        {"metallicRoughnessTexture", {{"index", 0}, {"texCoord", 1}}}}},
                      {"normalTexture", {{"index", 0}}},
                      {"occlusionTexture", {{"index", 0}}},
                      {"emissiveTexture", {{"index", 0}, {"texCoord", 1}}}}});
    writer.json["textures"] = Json::array({{{"source", 0}, {"sampler", 0}}});
    writer.json["samplers"] = Json::array({Json::object()});
    writer.json["images"] = Json::array({{{"bufferView", 0}, {"mimeType", "image/png"}}});
    writer.json["cameras"] =
        Json::array({{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}}});
    writer.json["skins"] = Json::array({{{"joints", {0}}, {"skeleton", 0}, {"inverseBindMatrices", 0}}});
    writer.json["animations"] = Json::array(
        {{{"channels", Json::array({{{"sampler", 0}, {"target", {{"node", 0}, {"path", "scale"}}}}})},
          {"samplers", Json::array({{{"input", 0}, {"output", 0}}})}}});
    writer.json["extensions"] = {{"KHR_lights_punctual", {{"lights", Json::array({{{"type", "point"}}})}}}};
    writer.json["nodes"][0]["skin"] = 0;
    writer.json["nodes"][0]["camera"] = 0;
    writer.json["nodes"][0]["extensions"] = {{"KHR_lights_punctual", {{"light", 0}}}};
    writer.add("nodes", {{"children", {0}}});
    writer.json["scenes"] = Json::array({{{"nodes", {1}}}});
    writer.json["scene"] = 0;
    writer.write_gltf();
    return writer.json;
}

/// "/nodes/0/mesh" as "nodes[0].mesh"
std::string place_of(const std::string& pointer) {
    std::string place;
    std::size_t start = 1;
    while (start <= pointer.size()) {
        const std::size_t end = std::min(pointer.find('/', start), pointer.size());
        const std::string key = pointer.substr(start, end - start);
        const bool is_index = key.find_first_not_of("0123456789") == std::string::npos;
        if (is_index) {
            place += "[" + key + "]";
        } else {
            place += (place.empty() ? "" : ".") + key;
        }
        start = end + 1;
    }
    return place;
}

const std::vector<std::string> kIndices = {
    "/scene",
    "/scenes/0/nodes/0",
    "/nodes/0/mesh",
    "/nodes/0/skin",
    "/nodes/0/camera",
    "/nodes/0/extensions/KHR_lights_punctual/light",
    "/nodes/1/children/0",
    "/meshes/0/primitives/0/attributes/POSITION",
    "/meshes/0/primitives/0/indices",
    "/meshes/0/primitives/0/material",
    "/meshes/0/primitives/0/targets/0/POSITION",
    "/materials/0/pbrMetallicRoughness/baseColorTexture/index",
    "/materials/0/pbrMetallicRoughness/metallicRoughnessTexture/index",
    "/materials/0/normalTexture/index",
    "/materials/0/occlusionTexture/index",
    "/materials/0/emissiveTexture/index",
    "/textures/0/source",
    "/textures/0/sampler",
    "/images/0/bufferView",
    "/accessors/0/bufferView",
    "/bufferViews/0/buffer",
    "/skins/0/joints/0",
    "/skins/0/skeleton",
    "/skins/0/inverseBindMatrices",
    "/animations/0/channels/0/target/node",
    "/animations/0/samplers/0/input",
    "/animations/0/samplers/0/output",
};

TEST(Schema, FileOfEverythingIsValid) {
    GltfWriter writer;
    file_of_everything(writer);
    EXPECT_EQ(import_error(writer), "");
}

TEST(Schema, EveryIndexIsChecked) {
    GltfWriter writer;
    const Json good = file_of_everything(writer);
    for (const std::string& pointer : kIndices) {
        for (const Json& wrong :
             {Json(-1), Json(99), Json(1e18), Json(0.5), Json("0"), Json(nullptr), Json(true)}) {
            writer.json = good;
            ASSERT_TRUE(good.contains(Json::json_pointer(pointer))) << pointer;
            writer.json[Json::json_pointer(pointer)] = wrong;
            EXPECT_THAT(import_error(writer),
                        AllOf(HasSubstr(": " + place_of(pointer) + ": is "), HasSubstr("must be")))
                << pointer << " = " << wrong;
        }
    }
}

TEST(Schema, IntegersMayBeWrittenWithAFraction) {
    GltfWriter writer;
    const Json good = file_of_everything(writer);
    for (const std::string& pointer : kIndices) {
        writer.json[Json::json_pointer(pointer)] = good[Json::json_pointer(pointer)].get<double>();
    }
    writer.json["accessors"][0]["count"] = 3.0;
    EXPECT_EQ(import_error(writer), "");
}

/// Every value of `json` below `pointer`, as JSON pointers, leaves and containers alike.
void collect_pointers(const Json& json, const std::string& pointer, std::vector<std::string>& pointers) {
    if (!pointer.empty()) pointers.push_back(pointer);
    if (json.is_object()) {
        for (const auto& [key, value] : json.items())
            collect_pointers(value, pointer + "/" + key, pointers);
    } else if (json.is_array()) {
        for (std::size_t i = 0; i < json.size(); ++i) {
            collect_pointers(json[i], pointer + "/" + std::to_string(i), pointers);
        }
    }
}

TEST(Schema, WrongTypesAnywhereAreInputErrorsOrIgnored) {
    GltfWriter writer;
    const Json good = file_of_everything(writer);
    std::vector<std::string> pointers;
    collect_pointers(good, "", pointers);
    ASSERT_GT(pointers.size(), 100u);
    std::size_t refused = 0;
    for (const std::string& pointer : pointers) {
        for (const Json& wrong : {Json(nullptr), Json(true), Json(-7), Json(1e300), Json("text"),
                                  Json::array(), Json::array({Json::object()}), Json::object()}) {
            writer.json = good;
            writer.json[Json::json_pointer(pointer)] = wrong;
            std::string error;
            EXPECT_NO_THROW(error = import_error(writer)) << pointer << " = " << wrong;
            refused += error.empty() ? 0 : 1;
        }
    }
    // Of eight replacements of a value at most two keep its type.
    EXPECT_GT(refused, pointers.size() * 8 / 2);
}

TEST(Schema, MissingRequiredProperties) {
    GltfWriter writer;
    const Json good = file_of_everything(writer);
    for (const char* pointer : {"/accessors/0/count", "/accessors/0/type", "/accessors/0/componentType",
                                "/bufferViews/0/buffer", "/bufferViews/0/byteLength", "/buffers/0/byteLength",
                                "/meshes/0/primitives", "/meshes/0/primitives/0/attributes",
                                "/cameras/0/type", "/materials/0/normalTexture/index", "/skins/0/joints"}) {
        writer.json = good;
        const Json::json_pointer at(pointer);
        writer.json[at.parent_pointer()].erase(at.back());
        EXPECT_THAT(import_error(writer), HasSubstr(place_of(pointer) + ": missing; it is required here"))
            << pointer;
    }
}

TEST(Schema, SizesBeyondTheFileAreRefusedBeforeAllocation) {
    GltfWriter writer;
    const Json good = file_of_everything(writer);
    for (const char* pointer : {"/accessors/0/count", "/accessors/0/byteOffset", "/bufferViews/0/byteLength",
                                "/bufferViews/0/byteOffset", "/buffers/0/byteLength"}) {
        for (const Json& size :
             {Json(4294967295u), Json(9007199254740991), Json(18446744073709551615u), Json(1e18)}) {
            writer.json = good;
            writer.json[Json::json_pointer(pointer)] = size;
            EXPECT_THAT(import_error(writer), HasSubstr("must")) << pointer << " = " << size;
        }
    }
}

}  // namespace
}  // namespace utsuri::test
