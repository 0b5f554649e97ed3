// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/binding_kind.h"

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

namespace utsuri {

/// One decoration of a SPIR-V module: OpDecorate, or OpMemberDecorate where `member` is set.
struct SpirvDecoration {
    std::uint32_t target = 0;
    std::int64_t member = -1;
    std::uint32_t decoration = 0;  ///< for example 33 Binding, 35 Offset, 42 NoContraction
    std::uint32_t value = 0;       ///< first literal, 0 without one
};

/// All decorations of a module, in order.
std::vector<SpirvDecoration> spirv_decorations(std::span<const std::uint32_t> module);

/// A buffer that a module declares.
struct SpirvBinding {
    std::uint32_t number = 0;
    std::uint32_t set = 0;
    BindingKind kind = BindingKind::storage;

    // clang-tidy 14 takes the 0 that such a comparison is held against for a null pointer.
    // NOLINTNEXTLINE(modernize-use-nullptr)
    friend auto operator<=>(const SpirvBinding&, const SpirvBinding&) = default;
};

/// The buffers a module declares, by ascending number.
std::vector<SpirvBinding> spirv_bindings(std::span<const std::uint32_t> module);

/// The specialization ids a module declares, ascending.
std::vector<std::uint32_t> spirv_specialization_ids(std::span<const std::uint32_t> module);

}  // namespace utsuri
