// SPDX-License-Identifier: Apache-2.0
#include "gpu/spirv.h"

#include "base/check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace utsuri {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::uint32_t kSpecId = 1;
constexpr std::uint32_t kBinding = 33;
constexpr std::uint32_t kOffset = 35;
constexpr std::uint32_t kNoContraction = 42;

/// The five words of a header: magic number, version 1.6, generator, bound of ids, schema.
const std::vector<std::uint32_t> kHeader = {0x07230203u, 0x00010600u, 0u, 100u, 0u};

std::uint32_t first_word(std::uint32_t operation, std::uint32_t words) {
    return (words << 16) | operation;
}

std::vector<std::uint32_t> module(std::initializer_list<std::vector<std::uint32_t>> instructions) {
    std::vector<std::uint32_t> words = kHeader;
    for (const auto& instruction : instructions)
        words.insert(words.end(), instruction.begin(), instruction.end());
    return words;
}

std::vector<std::uint32_t> decorate(std::uint32_t target, std::uint32_t decoration, std::uint32_t value) {
    return {first_word(71, 4), target, decoration, value};
}

TEST(Spirv, ReadsDecorationsInOrder) {
    const auto words = module({decorate(7, kBinding, 3),
                               {first_word(72, 5), 8, 2, kOffset, 16},  // OpMemberDecorate
                               {first_word(71, 3), 9, kNoContraction},
                               {first_word(17, 2), 1}});  // OpCapability Shader
    const auto decorations = spirv_decorations(words);
    ASSERT_EQ(decorations.size(), 3u);
    EXPECT_EQ(decorations[0].target, 7u);
    EXPECT_EQ(decorations[0].member, -1);
    EXPECT_EQ(decorations[0].decoration, kBinding);
    EXPECT_EQ(decorations[0].value, 3u);
    EXPECT_EQ(decorations[1].target, 8u);
    EXPECT_EQ(decorations[1].member, 2);
    EXPECT_EQ(decorations[1].value, 16u);
    EXPECT_EQ(decorations[2].decoration, kNoContraction);
    EXPECT_EQ(decorations[2].value, 0u);
}

TEST(Spirv, ListsBindingsAndSpecializationIdsOnceAndAscending) {
    constexpr std::uint32_t kDescriptorSet = 34;
    const auto variable = [](std::uint32_t id, std::uint32_t storage_class) {
        return std::vector<std::uint32_t>{first_word(59, 4), 100, id, storage_class};
    };
    constexpr std::uint32_t kUniformConstant = 0;
    constexpr std::uint32_t kUniform = 2;
    constexpr std::uint32_t kStorageBuffer = 12;
    const auto words =
        module({decorate(1, kBinding, 9), decorate(2, kBinding, 2), decorate(2, kDescriptorSet, 1),
                decorate(3, kBinding, 9), decorate(6, kBinding, 4), decorate(4, kSpecId, 5),
                decorate(5, kSpecId, 0), variable(1, kStorageBuffer), variable(2, kUniform),
                variable(3, kStorageBuffer), variable(6, kUniformConstant)});
    EXPECT_THAT(spirv_bindings(words), ElementsAre(SpirvBinding{2, 1, BindingKind::uniform_block},
                                                   SpirvBinding{4, 0, BindingKind::texels},
                                                   SpirvBinding{9, 0, BindingKind::storage}));
    EXPECT_THAT(spirv_specialization_ids(words), ElementsAre(0, 5));
}

TEST(Spirv, FindsNothingInAnEmptyModule) {
    EXPECT_THAT(spirv_decorations(kHeader), IsEmpty());
    EXPECT_THAT(spirv_bindings(kHeader), IsEmpty());
}

TEST(Spirv, RefusesAModuleThatIsCutOff) {
    auto words = module({decorate(1, kBinding, 9)});
    words.pop_back();
    EXPECT_THROW(spirv_decorations(words), CheckFailure);
    // An instruction of no words would be read forever.
    EXPECT_THROW(spirv_decorations(module({{0u}})), CheckFailure);
}

}  // namespace
}  // namespace utsuri
