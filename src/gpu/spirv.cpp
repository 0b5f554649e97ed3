// SPDX-License-Identifier: Apache-2.0
#include "gpu/spirv.h"

#include "base/check.h"

#include <map>
#include <set>

namespace utsuri {
namespace {

// Numbers of the SPIR-V specification, version 1.6.
constexpr std::uint32_t kOpVariable = 59;
constexpr std::uint32_t kOpDecorate = 71;
constexpr std::uint32_t kOpMemberDecorate = 72;
constexpr std::uint32_t kSpecId = 1;
constexpr std::uint32_t kBinding = 33;
constexpr std::uint32_t kDescriptorSet = 34;
// Storage classes.
constexpr std::uint32_t kUniformConstant = 0;
constexpr std::uint32_t kUniform = 2;
constexpr std::size_t kHeaderWords = 5;

/// Calls visit(operation, words) for every instruction, its first word left out.
template <typename Visit>
void for_each_instruction(std::span<const std::uint32_t> module, const Visit& visit) {
    for (std::size_t at = kHeaderWords; at < module.size();) {
        const std::uint32_t words = module[at] >> 16;
        UTSURI_CHECK_LT(0u, words);
        UTSURI_CHECK_LE(at + words, module.size());
        visit(module[at] & 0xffffu, module.subspan(at + 1, words - 1));
        at += words;
    }
}

BindingKind kind_of(std::uint32_t storage_class) {
    if (storage_class == kUniform) return BindingKind::uniform_block;
    // Images would be of this class too; no kernel has one.
    if (storage_class == kUniformConstant) return BindingKind::texels;
    return BindingKind::storage;
}

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
    for_each_instruction(module, [&](std::uint32_t operation, std::span<const std::uint32_t> words) {
        if (operation == kOpDecorate) {
            result.push_back({words[0], -1, words[1], words.size() > 2 ? words[2] : 0});
        } else if (operation == kOpMemberDecorate) {
            result.push_back({words[0], words[1], words[2], words.size() > 3 ? words[3] : 0});
        }
    });
    return result;
}

std::vector<SpirvBinding> spirv_bindings(std::span<const std::uint32_t> module) {
    std::map<std::uint32_t, SpirvBinding> variables;
    for (const SpirvDecoration& found : spirv_decorations(module)) {
        if (found.decoration == kBinding) variables[found.target].number = found.value;
    }
    for (const SpirvDecoration& found : spirv_decorations(module)) {
        const auto variable = variables.find(found.target);
        if (found.decoration == kDescriptorSet && variable != variables.end())
            variable->second.set = found.value;
    }
    for_each_instruction(module, [&](std::uint32_t operation, std::span<const std::uint32_t> words) {
        // Operands: type, result, storage class.
        if (operation != kOpVariable) return;
        const auto variable = variables.find(words[1]);
        if (variable != variables.end()) variable->second.kind = kind_of(words[2]);
    });
    std::set<SpirvBinding> bindings;
    for (const auto& [id, binding] : variables)
        bindings.insert(binding);
    return {bindings.begin(), bindings.end()};
}

std::vector<std::uint32_t> spirv_specialization_ids(std::span<const std::uint32_t> module) {
    return decoration_values(module, kSpecId);
}

}  // namespace utsuri
