// SPDX-License-Identifier: Apache-2.0
#pragma once

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

/// The binding numbers a module declares, ascending.
std::vector<std::uint32_t> spirv_bindings(std::span<const std::uint32_t> module);

/// The specialization ids a module declares, ascending.
std::vector<std::uint32_t> spirv_specialization_ids(std::span<const std::uint32_t> module);

}  // namespace utsuri
