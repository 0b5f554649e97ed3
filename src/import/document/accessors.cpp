// SPDX-License-Identifier: Apache-2.0
#include "import/document/accessors.h"

#include "import/document/layout.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>
#include <type_traits>

namespace utsuri {
namespace {

/// Elements somewhere in memory. `first` points to element 0; all elements that are read exist
/// (check_layout).
struct Elements {
    const std::byte* first = nullptr;
    std::size_t stride = 0;
    bool normalized = false;
};

/// glTF 2.0 specification, section 3.6.2.2 (normalized integers).
template <class Component>
float to_float(Component value, bool normalized) {
    if constexpr (std::is_floating_point_v<Component>) {
        return value;
    } else {
        if (!normalized) return static_cast<float>(value);
        constexpr auto kMax = static_cast<float>(std::numeric_limits<Component>::max());
        return std::max(static_cast<float>(value) / kMax, -1.0f);
    }
}

template <class Component, int N>
void decode(const Elements& source, ElementRange range, glm::vec<N, float>* out) {
    for (std::size_t i = 0; i < range.count; ++i) {
        Component components[N];
        std::memcpy(components, source.first + (range.first + i) * source.stride, sizeof(components));
        for (int c = 0; c < N; ++c)
            out[i][c] = to_float(components[c], source.normalized);
    }
}

template <int N>
void decode(int component_type, const Elements& source, ElementRange range, glm::vec<N, float>* out) {
    switch (component_type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            decode<std::int8_t, N>(source, range, out);
            break;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            decode<std::uint8_t, N>(source, range, out);
            break;
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            decode<std::int16_t, N>(source, range, out);
            break;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            decode<std::uint16_t, N>(source, range, out);
            break;
        default:
            decode<float, N>(source, range, out);
            break;
    }
}

template <class Index>
void decode_indices(const std::byte* first, std::size_t count, std::uint32_t* out) {
    for (std::size_t i = 0; i < count; ++i) {
        Index index;
        std::memcpy(&index, first + i * sizeof(Index), sizeof(Index));
        out[i] = index;
    }
}

/// `count` tightly packed unsigned integers at `offset` of a bufferView.
std::vector<std::uint32_t> unsigned_integers(std::span<const std::byte> view, std::size_t offset,
                                             std::size_t count, int component_type) {
    std::vector<std::uint32_t> indices(count);
    const std::byte* first = view.data() + offset;
    switch (component_type) {
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            decode_indices<std::uint8_t>(first, count, indices.data());
            break;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            decode_indices<std::uint16_t>(first, count, indices.data());
            break;
        default:
            decode_indices<std::uint32_t>(first, count, indices.data());
            break;
    }
    return indices;
}

class AccessorReader {
  public:
    AccessorReader(const Document& document, Buffers& buffers, std::size_t index)
        : document_(document), buffers_(buffers), index_(index), accessor_(document.model.accessors[index]) {}

    template <int N>
    std::vector<glm::vec<N, float>> vectors(ElementRange range, std::string_view place) {
        constexpr int kType = N == 2 ? TINYGLTF_TYPE_VEC2 : TINYGLTF_TYPE_VEC3;
        if (accessor_.type != kType) {
            document_.fail(place, fmt::format("accessors[{}].type must be VEC{}", index_, N));
        }
        if (accessor_.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT) {
            document_.fail(
                place,
                fmt::format("accessors[{}].componentType is 5125 (unsigned int); must be 5126 (float), "
                            "or 5120 to 5123 (8 or 16 bits)",
                            index_));
        }
        std::vector<glm::vec<N, float>> result(range.count, glm::vec<N, float>(0.0f));
        if (accessor_.bufferView >= 0) {
            const auto view = static_cast<std::size_t>(accessor_.bufferView);
            const std::size_t packed = element_size<N>();
            const std::size_t declared = document_.model.bufferViews[view].byteStride;
            const Elements source = {buffers_.view(view).data() + accessor_.byteOffset,
                                     declared == 0 ? packed : declared, accessor_.normalized};
            decode<N>(accessor_.componentType, source, range, result.data());
        }
        if (accessor_.sparse.isSparse) replace_sparse<N>(range, result);
        return result;
    }

    std::vector<std::uint32_t> indices(std::string_view place) {
        if (accessor_.type != TINYGLTF_TYPE_SCALAR) {
            document_.fail(place, fmt::format("accessors[{}].type must be SCALAR", index_));
        }
        const int type = accessor_.componentType;
        if (type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE && type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT &&
            type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT) {
            document_.fail(place, fmt::format("accessors[{}].componentType is {}; must be 5121, 5123 or 5125 "
                                              "(unsigned integers) for indices",
                                              index_, type));
        }
        const auto view = static_cast<std::size_t>(accessor_.bufferView);
        if (document_.model.bufferViews[view].byteStride != 0) {
            document_.fail(fmt::format("bufferViews[{}].byteStride", view),
                           fmt::format("given, but {} reads indices; must be absent", place));
        }
        auto result = unsigned_integers(buffers_.view(view), accessor_.byteOffset, accessor_.count, type);
        if (!accessor_.sparse.isSparse) return result;
        const std::vector<std::uint32_t> replaced = sparse_indices();
        const auto values = unsigned_integers(
            buffers_.view(static_cast<std::size_t>(accessor_.sparse.values.bufferView)),
            static_cast<std::size_t>(accessor_.sparse.values.byteOffset), replaced.size(), type);
        for (std::size_t i = 0; i < replaced.size(); ++i)
            result[replaced[i]] = values[i];
        return result;
    }

  private:
    template <int N>
    [[nodiscard]] std::size_t element_size() const {
        return element_layout(accessor_.componentType, N == 2 ? "VEC2" : "VEC3").size();
    }

    /// The elements that the sparse values replace, checked to exist.
    std::vector<std::uint32_t> sparse_indices() {
        const auto& sparse = accessor_.sparse;
        auto indices =
            unsigned_integers(buffers_.view(static_cast<std::size_t>(sparse.indices.bufferView)),
                              static_cast<std::size_t>(sparse.indices.byteOffset),
                              static_cast<std::size_t>(sparse.count), sparse.indices.componentType);
        for (std::size_t i = 0; i < indices.size(); ++i) {
            if (indices[i] < accessor_.count) continue;
            document_.fail(fmt::format("accessors[{}].sparse.indices", index_),
                           fmt::format("index {} is {}; must be below the accessor's count, {}", i,
                                       indices[i], accessor_.count));
        }
        return indices;
    }

    template <int N>
    void replace_sparse(ElementRange range, std::vector<glm::vec<N, float>>& result) {
        const std::vector<std::uint32_t> replaced = sparse_indices();
        const auto view = buffers_.view(static_cast<std::size_t>(accessor_.sparse.values.bufferView));
        const Elements source = {view.data() + accessor_.sparse.values.byteOffset, element_size<N>(),
                                 accessor_.normalized};
        std::vector<glm::vec<N, float>> values(replaced.size());
        decode<N>(accessor_.componentType, source, {0, values.size()}, values.data());
        for (std::size_t i = 0; i < replaced.size(); ++i) {
            if (replaced[i] >= range.first && replaced[i] - range.first < range.count) {
                result[replaced[i] - range.first] = values[i];
            }
        }
    }

    const Document& document_;
    Buffers& buffers_;
    std::size_t index_;
    const tinygltf::Accessor& accessor_;
};

}  // namespace

std::vector<glm::vec3> read_vec3(const Document& document, Buffers& buffers, std::size_t accessor,
                                 ElementRange range, std::string_view place) {
    return AccessorReader(document, buffers, accessor).vectors<3>(range, place);
}

std::vector<glm::vec2> read_vec2(const Document& document, Buffers& buffers, std::size_t accessor,
                                 ElementRange range, std::string_view place) {
    return AccessorReader(document, buffers, accessor).vectors<2>(range, place);
}

std::vector<std::uint32_t> read_indices(const Document& document, Buffers& buffers, std::size_t accessor,
                                        std::string_view place) {
    return AccessorReader(document, buffers, accessor).indices(place);
}

}  // namespace utsuri
