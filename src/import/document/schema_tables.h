// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <string_view>

namespace utsuri {

/// The lists that indices point into.
enum class List : std::size_t {
    accessors,
    buffers,
    buffer_views,
    cameras,
    images,
    materials,
    meshes,
    nodes,
    samplers,
    scenes,
    skins,
    textures,
    lights,
};

/// The JSON names of the lists, in the order of List. Lights live in KHR_lights_punctual, the others at the
/// root.
constexpr std::array<std::string_view, 13> kListNames = {
    "accessors", "buffers",  "bufferViews", "cameras", "images",   "materials", "meshes",
    "nodes",     "samplers", "scenes",      "skins",   "textures", "lights"};

enum class Kind {
    boolean,
    word,        ///< string, one of `words` if there are any
    words,       ///< array of strings
    integer,     ///< in [min, max], a multiple of `multiple`, one of `codes` if there are any
    number,      ///< in [min, max]
    numbers,     ///< array of `length` numbers, each in [min, max]
    index,       ///< into `list`
    indices,     ///< array of indices into `list`
    index_map,   ///< object whose values are indices into `list`
    object,      ///< as `schema` says
    objects,     ///< array of objects
    index_maps,  ///< array of index maps
};

struct Schema;

/// One property of a glTF object.
struct Field {
    std::string_view name;
    Kind kind = Kind::object;
    bool required = false;
    double min = -std::numeric_limits<double>::max();
    double max = std::numeric_limits<double>::max();
    int multiple = 1;
    std::size_t length = 0;
    List list = List::accessors;
    const Schema* schema = nullptr;
    std::span<const std::string_view> words = {};
    std::span<const int> codes = {};
};

struct Schema {
    std::span<const Field> fields;
};

/// The root object, asset.version and extensionsRequired excepted, which are checked before.
const Schema& root_schema();

}  // namespace utsuri
