// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace utsuri::test {

/// One instruction of a SPIR-V module: its operation code and the words after the first.
struct SpirvInstruction {
    std::uint32_t operation = 0;
    std::vector<std::uint32_t> words;
};

// Operation codes of the SPIR-V specification, version 1.6.
inline constexpr std::uint32_t kOpName = 5;
inline constexpr std::uint32_t kOpMemberName = 6;
inline constexpr std::uint32_t kOpTypeInt = 21;
inline constexpr std::uint32_t kOpTypeFloat = 22;
inline constexpr std::uint32_t kOpTypeVector = 23;
inline constexpr std::uint32_t kOpTypeArray = 28;
inline constexpr std::uint32_t kOpConstant = 43;
inline constexpr std::uint32_t kOpTypeRuntimeArray = 29;
inline constexpr std::uint32_t kOpTypeStruct = 30;
inline constexpr std::uint32_t kOpFunction = 54;
inline constexpr std::uint32_t kOpFunctionEnd = 56;
inline constexpr std::uint32_t kOpLoad = 61;
inline constexpr std::uint32_t kOpStore = 62;
inline constexpr std::uint32_t kOpAccessChain = 65;
inline constexpr std::uint32_t kOpInBoundsAccessChain = 66;
inline constexpr std::uint32_t kOpDecorate = 71;
inline constexpr std::uint32_t kOpMemberDecorate = 72;
inline constexpr std::uint32_t kOpFAdd = 129;
inline constexpr std::uint32_t kOpFSub = 131;
inline constexpr std::uint32_t kOpFMul = 133;
inline constexpr std::uint32_t kOpVectorTimesScalar = 142;
inline constexpr std::uint32_t kArrayStride = 6;
inline constexpr std::uint32_t kBinding = 33;
inline constexpr std::uint32_t kOffset = 35;
inline constexpr std::uint32_t kNoContraction = 42;

/// What tests ask of a module.
class SpirvModule {
  public:
    explicit SpirvModule(std::span<const std::uint32_t> words);

    [[nodiscard]] const std::vector<SpirvInstruction>& instructions() const { return instructions_; }

    /// Ids that carry the decoration NoContraction.
    [[nodiscard]] std::set<std::uint32_t> uncontracted() const;
    /// The instructions of the function whose name starts with `name` and an opening parenthesis; empty
    /// without one.
    [[nodiscard]] std::vector<SpirvInstruction> function(const std::string& name) const;

    /// Whether any instruction points into the buffer bound to a number: declared alone it may be unused.
    [[nodiscard]] bool reaches(std::uint32_t binding) const;
    /// Whether any instruction stores into it.
    [[nodiscard]] bool stores_into(std::uint32_t binding) const;

    struct Member {
        std::string name;
        std::uint32_t offset = 0;
        std::uint32_t size = 0;  ///< bytes
    };
    struct Struct {
        std::string name;
        std::vector<Member> members;
        std::set<std::uint32_t> array_strides;  ///< of arrays of it

        /// Where the last member ends.
        [[nodiscard]] std::uint32_t end() const;
    };
    /// Structs that have offsets, blocks that wrap a single array or struct included. One name may occur
    /// several times.
    [[nodiscard]] std::vector<Struct> laid_out_structs() const;

  private:
    /// Ids of pointers into the buffer bound to a number.
    [[nodiscard]] std::set<std::uint32_t> pointers_into(std::uint32_t binding) const;
    [[nodiscard]] std::uint32_t size_of(std::uint32_t type) const;

    std::vector<SpirvInstruction> instructions_;
    std::map<std::uint32_t, std::string> names_;
    std::map<std::uint32_t, std::map<std::uint32_t, std::string>> member_names_;
    std::map<std::uint32_t, std::map<std::uint32_t, std::uint32_t>> offsets_;
    std::map<std::uint32_t, SpirvInstruction> types_;
    std::map<std::uint32_t, std::uint32_t> constants_;  ///< their first word
};

/// The module without its NoContraction decorations: what a compiler would make of the source without
/// `precise`.
std::vector<std::uint32_t> without_no_contraction(std::span<const std::uint32_t> words);

}  // namespace utsuri::test
