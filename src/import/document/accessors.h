// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "import/document/buffers.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <string_view>
#include <vector>

namespace utsuri {

/// A run of elements of an accessor.
struct ElementRange {
    std::size_t first = 0;
    std::size_t count = 0;
};

/// Reads VEC3 or VEC2 elements as floats: 32-bit float, or 8- or 16-bit integers, normalized or not. Sparse
/// values are in place. `place` is the JSON path of the reference to the accessor; the range lies in the
/// accessor.
/// @throws InputError if the accessor has another type, or its sparse indices are wrong.
std::vector<glm::vec3> read_vec3(const Document& document, Buffers& buffers, std::size_t accessor,
                                 ElementRange range, std::string_view place);
std::vector<glm::vec2> read_vec2(const Document& document, Buffers& buffers, std::size_t accessor,
                                 ElementRange range, std::string_view place);

/// Reads a whole accessor of vertex indices.
/// @throws InputError if it is not an accessor of unsigned scalars without a stride.
std::vector<std::uint32_t> read_indices(const Document& document, Buffers& buffers, std::size_t accessor,
                                        std::string_view place);

}  // namespace utsuri
