// SPDX-License-Identifier: Apache-2.0
// The glTF 2.0 objects (specification, chapter 5) as far as the importer or the glTF parser reads them.
#include "import/document/schema_tables.h"

#include <numbers>

namespace utsuri {
namespace {

constexpr double kMaxExact = 9007199254740991.0;  // 2^53 - 1: larger integers are not exact in JSON
constexpr double kMaxInt = 2147483647.0;          // tinygltf keeps these in an int
constexpr double kMaxFloat = 3.4028234663852886e38;
constexpr double kAboveZero = std::numeric_limits<double>::min();

constexpr std::array kComponentTypes = {5120, 5121, 5122, 5123, 5125, 5126};
constexpr std::array kSparseIndexTypes = {5121, 5123, 5125};
constexpr std::array kMagFilters = {9728, 9729};
constexpr std::array kMinFilters = {9728, 9729, 9984, 9985, 9986, 9987};
constexpr std::array kWraps = {10497, 33071, 33648};
constexpr std::array<std::string_view, 7> kAccessorTypes = {"SCALAR", "VEC2", "VEC3", "VEC4",
                                                            "MAT2",   "MAT3", "MAT4"};
constexpr std::array<std::string_view, 3> kAlphaModes = {"OPAQUE", "MASK", "BLEND"};
constexpr std::array<std::string_view, 2> kCameraTypes = {"perspective", "orthographic"};
constexpr std::array<std::string_view, 3> kLightTypes = {"point", "spot", "directional"};

constexpr Field kName = {.name = "name", .kind = Kind::word};

constexpr std::array kSparseIndices = {
    Field{.name = "bufferView", .kind = Kind::index, .required = true, .list = List::buffer_views},
    Field{.name = "byteOffset", .kind = Kind::integer, .min = 0, .max = kMaxInt},
    Field{.name = "componentType", .kind = Kind::integer, .required = true, .codes = kSparseIndexTypes},
};
constexpr Schema kSparseIndicesSchema = {kSparseIndices};

constexpr std::array kSparseValues = {
    Field{.name = "bufferView", .kind = Kind::index, .required = true, .list = List::buffer_views},
    Field{.name = "byteOffset", .kind = Kind::integer, .min = 0, .max = kMaxInt},
};
constexpr Schema kSparseValuesSchema = {kSparseValues};

constexpr std::array kSparse = {
    Field{.name = "count", .kind = Kind::integer, .required = true, .min = 1, .max = kMaxInt},
    Field{.name = "indices", .kind = Kind::object, .required = true, .schema = &kSparseIndicesSchema},
    Field{.name = "values", .kind = Kind::object, .required = true, .schema = &kSparseValuesSchema},
};
constexpr Schema kSparseSchema = {kSparse};

constexpr std::array kAccessor = {
    kName,
    Field{.name = "bufferView", .kind = Kind::index, .list = List::buffer_views},
    Field{.name = "byteOffset", .kind = Kind::integer, .min = 0, .max = kMaxExact},
    Field{.name = "componentType", .kind = Kind::integer, .required = true, .codes = kComponentTypes},
    Field{.name = "normalized", .kind = Kind::boolean},
    Field{.name = "count", .kind = Kind::integer, .required = true, .min = 1, .max = kMaxExact},
    Field{.name = "type", .kind = Kind::word, .required = true, .words = kAccessorTypes},
    Field{.name = "sparse", .kind = Kind::object, .schema = &kSparseSchema},
};
constexpr Schema kAccessorSchema = {kAccessor};

constexpr std::array kBuffer = {
    kName,
    Field{.name = "uri", .kind = Kind::word},
    Field{.name = "byteLength", .kind = Kind::integer, .required = true, .min = 1, .max = kMaxExact},
};
constexpr Schema kBufferSchema = {kBuffer};

constexpr std::array kBufferView = {
    kName,
    Field{.name = "buffer", .kind = Kind::index, .required = true, .list = List::buffers},
    Field{.name = "byteOffset", .kind = Kind::integer, .min = 0, .max = kMaxExact},
    Field{.name = "byteLength", .kind = Kind::integer, .required = true, .min = 1, .max = kMaxExact},
    Field{.name = "byteStride", .kind = Kind::integer, .min = 0, .max = 252, .multiple = 4},
};
constexpr Schema kBufferViewSchema = {kBufferView};

constexpr std::array kImage = {
    kName,
    Field{.name = "uri", .kind = Kind::word},
    Field{.name = "mimeType", .kind = Kind::word},
    Field{.name = "bufferView", .kind = Kind::index, .list = List::buffer_views},
};
constexpr Schema kImageSchema = {kImage};

constexpr std::array kSampler = {
    kName,
    Field{.name = "magFilter", .kind = Kind::integer, .codes = kMagFilters},
    Field{.name = "minFilter", .kind = Kind::integer, .codes = kMinFilters},
    Field{.name = "wrapS", .kind = Kind::integer, .codes = kWraps},
    Field{.name = "wrapT", .kind = Kind::integer, .codes = kWraps},
};
constexpr Schema kSamplerSchema = {kSampler};

constexpr std::array kTexture = {
    kName,
    Field{.name = "sampler", .kind = Kind::index, .list = List::samplers},
    Field{.name = "source", .kind = Kind::index, .list = List::images},
};
constexpr Schema kTextureSchema = {kTexture};

constexpr std::array kTextureInfo = {
    Field{.name = "index", .kind = Kind::index, .required = true, .list = List::textures},
    Field{.name = "texCoord", .kind = Kind::integer, .min = 0, .max = kMaxInt},
    Field{.name = "scale", .kind = Kind::number},
    Field{.name = "strength", .kind = Kind::number},
};
constexpr Schema kTextureInfoSchema = {kTextureInfo};

constexpr std::array kMetallicRoughness = {
    Field{.name = "baseColorFactor", .kind = Kind::numbers, .min = 0, .max = 1, .length = 4},
    Field{.name = "metallicFactor", .kind = Kind::number, .min = 0, .max = 1},
    Field{.name = "roughnessFactor", .kind = Kind::number, .min = 0, .max = 1},
    Field{.name = "baseColorTexture", .schema = &kTextureInfoSchema},
    Field{.name = "metallicRoughnessTexture", .schema = &kTextureInfoSchema},
};
constexpr Schema kMetallicRoughnessSchema = {kMetallicRoughness};

constexpr std::array kEmissiveStrength = {
    Field{.name = "emissiveStrength", .kind = Kind::number, .min = 0, .max = kMaxFloat}};
constexpr Schema kEmissiveStrengthSchema = {kEmissiveStrength};

constexpr std::array kIor = {Field{.name = "ior", .kind = Kind::number, .min = 0, .max = kMaxFloat}};
constexpr Schema kIorSchema = {kIor};

constexpr std::array kSpecular = {
    Field{.name = "specularFactor", .kind = Kind::number, .min = 0, .max = 1},
    Field{.name = "specularColorFactor", .kind = Kind::numbers, .min = 0, .max = kMaxFloat, .length = 3},
    Field{.name = "specularTexture", .schema = &kTextureInfoSchema},
    Field{.name = "specularColorTexture", .schema = &kTextureInfoSchema},
};
constexpr Schema kSpecularSchema = {kSpecular};

constexpr std::array kMaterialExtensions = {
    Field{.name = "KHR_materials_emissive_strength", .schema = &kEmissiveStrengthSchema},
    Field{.name = "KHR_materials_ior", .schema = &kIorSchema},
    Field{.name = "KHR_materials_specular", .schema = &kSpecularSchema},
};
constexpr Schema kMaterialExtensionsSchema = {kMaterialExtensions};

constexpr std::array kMaterial = {
    kName,
    Field{.name = "pbrMetallicRoughness", .schema = &kMetallicRoughnessSchema},
    Field{.name = "normalTexture", .schema = &kTextureInfoSchema},
    Field{.name = "occlusionTexture", .schema = &kTextureInfoSchema},
    Field{.name = "emissiveTexture", .schema = &kTextureInfoSchema},
    Field{.name = "emissiveFactor", .kind = Kind::numbers, .min = 0, .max = kMaxFloat, .length = 3},
    Field{.name = "alphaMode", .kind = Kind::word, .words = kAlphaModes},
    Field{.name = "alphaCutoff", .kind = Kind::number},
    Field{.name = "doubleSided", .kind = Kind::boolean},
    Field{.name = "extensions", .schema = &kMaterialExtensionsSchema},
};
constexpr Schema kMaterialSchema = {kMaterial};

constexpr std::array kPrimitive = {
    Field{.name = "attributes", .kind = Kind::index_map, .required = true, .list = List::accessors},
    Field{.name = "indices", .kind = Kind::index, .list = List::accessors},
    Field{.name = "material", .kind = Kind::index, .list = List::materials},
    Field{.name = "mode", .kind = Kind::integer, .min = 0, .max = 6},
    Field{.name = "targets", .kind = Kind::index_maps, .list = List::accessors},
};
constexpr Schema kPrimitiveSchema = {kPrimitive};

constexpr std::array kMesh = {
    kName,
    Field{.name = "primitives", .kind = Kind::objects, .required = true, .schema = &kPrimitiveSchema},
};
constexpr Schema kMeshSchema = {kMesh};

constexpr std::array kNodeLight = {
    Field{.name = "light", .kind = Kind::index, .required = true, .list = List::lights}};
constexpr Schema kNodeLightSchema = {kNodeLight};

constexpr std::array kNodeExtensions = {Field{.name = "KHR_lights_punctual", .schema = &kNodeLightSchema}};
constexpr Schema kNodeExtensionsSchema = {kNodeExtensions};

constexpr std::array kNode = {
    kName,
    Field{.name = "children", .kind = Kind::indices, .list = List::nodes},
    Field{.name = "camera", .kind = Kind::index, .list = List::cameras},
    Field{.name = "mesh", .kind = Kind::index, .list = List::meshes},
    Field{.name = "skin", .kind = Kind::index, .list = List::skins},
    Field{.name = "matrix", .kind = Kind::numbers, .length = 16},
    Field{.name = "translation", .kind = Kind::numbers, .length = 3},
    Field{.name = "rotation", .kind = Kind::numbers, .length = 4},
    Field{.name = "scale", .kind = Kind::numbers, .length = 3},
    Field{.name = "extensions", .schema = &kNodeExtensionsSchema},
};
constexpr Schema kNodeSchema = {kNode};

constexpr std::array kScene = {kName, Field{.name = "nodes", .kind = Kind::indices, .list = List::nodes}};
constexpr Schema kSceneSchema = {kScene};

constexpr std::array kPerspective = {
    Field{.name = "yfov", .kind = Kind::number, .required = true, .min = kAboveZero, .max = kMaxFloat},
    Field{.name = "znear", .kind = Kind::number, .required = true},
    Field{.name = "zfar", .kind = Kind::number},
    Field{.name = "aspectRatio", .kind = Kind::number},
};
constexpr Schema kPerspectiveSchema = {kPerspective};

constexpr std::array kOrthographic = {
    Field{.name = "xmag", .kind = Kind::number, .required = true},
    Field{.name = "ymag", .kind = Kind::number, .required = true},
    Field{.name = "znear", .kind = Kind::number, .required = true},
    Field{.name = "zfar", .kind = Kind::number, .required = true},
};
constexpr Schema kOrthographicSchema = {kOrthographic};

constexpr std::array kCamera = {
    kName,
    Field{.name = "type", .kind = Kind::word, .required = true, .words = kCameraTypes},
    Field{.name = "perspective", .schema = &kPerspectiveSchema},
    Field{.name = "orthographic", .schema = &kOrthographicSchema},
};
constexpr Schema kCameraSchema = {kCamera};

/// A right angle as exporters write it that keep angles in float32: a little more than pi / 2.
constexpr double kRightAngle = static_cast<float>(std::numbers::pi / 2);

constexpr std::array kSpot = {
    Field{.name = "innerConeAngle", .kind = Kind::number, .min = 0, .max = kRightAngle},
    Field{.name = "outerConeAngle", .kind = Kind::number, .min = kAboveZero, .max = kRightAngle},
};
constexpr Schema kSpotSchema = {kSpot};

constexpr std::array kLight = {
    kName,
    Field{.name = "type", .kind = Kind::word, .required = true, .words = kLightTypes},
    Field{.name = "color", .kind = Kind::numbers, .min = 0, .max = kMaxFloat, .length = 3},
    Field{.name = "intensity", .kind = Kind::number, .min = 0, .max = kMaxFloat},
    Field{.name = "range", .kind = Kind::number, .min = kAboveZero},
    Field{.name = "spot", .schema = &kSpotSchema},
};
constexpr Schema kLightSchema = {kLight};

constexpr std::array kLights = {Field{.name = "lights", .kind = Kind::objects, .schema = &kLightSchema}};
constexpr Schema kLightsSchema = {kLights};

constexpr std::array kRootExtensions = {Field{.name = "KHR_lights_punctual", .schema = &kLightsSchema}};
constexpr Schema kRootExtensionsSchema = {kRootExtensions};

constexpr std::array kSkin = {
    Field{.name = "inverseBindMatrices", .kind = Kind::index, .list = List::accessors},
    Field{.name = "skeleton", .kind = Kind::index, .list = List::nodes},
    Field{.name = "joints", .kind = Kind::indices, .required = true, .list = List::nodes},
};
constexpr Schema kSkinSchema = {kSkin};

constexpr std::array kAnimationSampler = {
    Field{.name = "input", .kind = Kind::index, .required = true, .list = List::accessors},
    Field{.name = "output", .kind = Kind::index, .required = true, .list = List::accessors},
};
constexpr Schema kAnimationSamplerSchema = {kAnimationSampler};

constexpr std::array kChannelTarget = {Field{.name = "node", .kind = Kind::index, .list = List::nodes}};
constexpr Schema kChannelTargetSchema = {kChannelTarget};

constexpr std::array kChannel = {Field{.name = "target", .required = true, .schema = &kChannelTargetSchema}};
constexpr Schema kChannelSchema = {kChannel};

constexpr std::array kAnimation = {
    Field{.name = "samplers", .kind = Kind::objects, .required = true, .schema = &kAnimationSamplerSchema},
    Field{.name = "channels", .kind = Kind::objects, .required = true, .schema = &kChannelSchema},
};
constexpr Schema kAnimationSchema = {kAnimation};

constexpr std::array kRoot = {
    Field{.name = "extensionsUsed", .kind = Kind::words},
    Field{.name = "scene", .kind = Kind::index, .list = List::scenes},
    Field{.name = "accessors", .kind = Kind::objects, .schema = &kAccessorSchema},
    Field{.name = "animations", .kind = Kind::objects, .schema = &kAnimationSchema},
    Field{.name = "buffers", .kind = Kind::objects, .schema = &kBufferSchema},
    Field{.name = "bufferViews", .kind = Kind::objects, .schema = &kBufferViewSchema},
    Field{.name = "cameras", .kind = Kind::objects, .schema = &kCameraSchema},
    Field{.name = "images", .kind = Kind::objects, .schema = &kImageSchema},
    Field{.name = "materials", .kind = Kind::objects, .schema = &kMaterialSchema},
    Field{.name = "meshes", .kind = Kind::objects, .schema = &kMeshSchema},
    Field{.name = "nodes", .kind = Kind::objects, .schema = &kNodeSchema},
    Field{.name = "samplers", .kind = Kind::objects, .schema = &kSamplerSchema},
    Field{.name = "scenes", .kind = Kind::objects, .schema = &kSceneSchema},
    Field{.name = "skins", .kind = Kind::objects, .schema = &kSkinSchema},
    Field{.name = "textures", .kind = Kind::objects, .schema = &kTextureSchema},
    Field{.name = "extensions", .schema = &kRootExtensionsSchema},
};
constexpr Schema kRootSchema = {kRoot};

}  // namespace

const Schema& root_schema() {
    return kRootSchema;
}

}  // namespace utsuri
