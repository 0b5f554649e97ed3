// SPDX-License-Identifier: Apache-2.0
#include "gpu/spirv.h"

#include "base/check.h"

#include <set>

namespace utsuri {
namespace {

// Numbers of the SPIR-V specification, version 1.6.
constexpr std::uint32_t kOpDecorate = 71;
constexpr std::uint32_t kOpMemberDecorate = 72;
constexpr std::uint32_t kSpecId = 1;
constexpr std::uint32_t kBinding = 33;
constexpr std::size_t kHeaderWords = 5;

std::vector<std::uint32_t> decoration_values(std::span<const std::uint32_t> module,
                                             std::uint32_t decoration) {
    std::set<std::uint32_t> values;
    for (const SpirvDecoration& found : spirv_decorations(module)) {
        if (found.decoration == decoration) values.insert(found.value);
    }
    return {values.begin(), values.end()};
}

}  // namespace

std::vector<SpirvDecoration> spirv_decorations(std::span<const std::uint32_t> module) {
    std::vector<SpirvDecoration> result;
    for (std::size_t at = kHeaderWords; at < module.size();) {
        const std::uint32_t operation = module[at] & 0xffffu;
        const std::uint32_t words = module[at] >> 16;
        UTSURI_CHECK_LT(0u, words);
        UTSURI_CHECK_LE(at + words, module.size());
        if (operation == kOpDecorate) {
            result.push_back({module[at + 1], -1, module[at + 2], words > 3 ? module[at + 3] : 0});
        } else if (operation == kOpMemberDecorate) {
            result.push_back(
                {module[at + 1], module[at + 2], module[at + 3], words > 4 ? module[at + 4] : 0});
        }
        at += words;
    }
    return result;
}

std::vector<std::uint32_t> spirv_bindings(std::span<const std::uint32_t> module) {
    return decoration_values(module, kBinding);
}

std::vector<std::uint32_t> spirv_specialization_ids(std::span<const std::uint32_t> module) {
    return decoration_values(module, kSpecId);
}

}  // namespace utsuri
