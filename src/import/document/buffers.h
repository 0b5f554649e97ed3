// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "import/document/document.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace utsuri {

/// The contents of the buffers of a document, each read at its first use. The document must outlive it.
class Buffers {
  public:
    explicit Buffers(const Document& document);

    /// The bytes of a bufferView, an index that exists; valid as long as this object.
    /// @throws InputError if the buffer cannot be read or is shorter than it says.
    std::span<const std::byte> view(std::size_t buffer_view);

  private:
    std::span<const std::byte> buffer(std::size_t index);
    std::span<const std::byte> read_buffer(std::size_t index);
    /// Names of the extensions on a buffer and on the bufferViews of it.
    [[nodiscard]] std::string extensions_on(std::size_t index) const;

    const Document& document_;
    std::vector<std::vector<std::byte>> storage_;
    std::vector<std::optional<std::span<const std::byte>>> contents_;
};

}  // namespace utsuri
