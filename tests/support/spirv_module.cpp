// SPDX-License-Identifier: Apache-2.0
#include "support/spirv_module.h"

#include "base/check.h"

#include <algorithm>

namespace utsuri::test {
namespace {

constexpr std::size_t kHeaderWords = 5;

/// A text packed into words, lowest byte first.
std::string text_of(std::span<const std::uint32_t> words) {
    std::string text;
    for (const std::uint32_t word : words) {
        for (int byte = 0; byte < 4; ++byte) {
            const char c = static_cast<char>((word >> (8 * byte)) & 0xffu);
            if (c == '\0') return text;
            text += c;
        }
    }
    return text;
}

bool is_type(std::uint32_t operation) {
    return operation == kOpTypeInt || operation == kOpTypeFloat || operation == kOpTypeVector ||
           operation == kOpTypeArray || operation == kOpTypeRuntimeArray || operation == kOpTypeStruct;
}

}  // namespace

SpirvModule::SpirvModule(std::span<const std::uint32_t> words) {
    for (std::size_t at = kHeaderWords; at < words.size();) {
        const std::uint32_t count = words[at] >> 16;
        UTSURI_CHECK_LT(0u, count);
        UTSURI_CHECK_LE(at + count, words.size());
        const auto operands = words.subspan(at + 1, count - 1);
        instructions_.push_back({words[at] & 0xffffu, {operands.begin(), operands.end()}});
        const SpirvInstruction& instruction = instructions_.back();
        if (instruction.operation == kOpName) {
            names_[operands[0]] = text_of(operands.subspan(1));
        } else if (instruction.operation == kOpMemberName) {
            member_names_[operands[0]][operands[1]] = text_of(operands.subspan(2));
        } else if (instruction.operation == kOpMemberDecorate && operands[2] == kOffset) {
            offsets_[operands[0]][operands[1]] = operands[3];
        } else if (is_type(instruction.operation)) {
            types_[operands[0]] = instruction;
        } else if (instruction.operation == kOpConstant) {
            constants_[operands[1]] = operands[2];
        }
        at += count;
    }
}

std::set<std::uint32_t> SpirvModule::uncontracted() const {
    std::set<std::uint32_t> ids;
    for (const SpirvInstruction& instruction : instructions_) {
        if (instruction.operation == kOpDecorate && instruction.words[1] == kNoContraction) {
            ids.insert(instruction.words[0]);
        }
    }
    return ids;
}

std::vector<SpirvInstruction> SpirvModule::function(const std::string& name) const {
    std::vector<SpirvInstruction> body;
    bool inside = false;
    for (const SpirvInstruction& instruction : instructions_) {
        if (instruction.operation == kOpFunction) {
            const auto found = names_.find(instruction.words[1]);
            inside = found != names_.end() && found->second.starts_with(name + "(");
        }
        if (inside) body.push_back(instruction);
        if (instruction.operation == kOpFunctionEnd) inside = false;
    }
    return body;
}

std::set<std::uint32_t> SpirvModule::pointers_into(std::uint32_t binding) const {
    std::set<std::uint32_t> buffers;
    std::set<std::uint32_t> pointers;
    for (const SpirvInstruction& instruction : instructions_) {
        const std::vector<std::uint32_t>& words = instruction.words;
        if (instruction.operation == kOpDecorate && words[1] == kBinding && words[2] == binding) {
            buffers.insert(words[0]);
        } else if (instruction.operation == kOpAccessChain ||
                   instruction.operation == kOpInBoundsAccessChain) {
            // Operands of these: result type, result, base, indices.
            if (buffers.contains(words[2]) || pointers.contains(words[2])) pointers.insert(words[1]);
        } else if (instruction.operation == kOpLoad && buffers.contains(words[2])) {
            pointers.insert(words[1]);  // texels: the image is loaded first
        }
    }
    return pointers;
}

bool SpirvModule::reaches(std::uint32_t binding) const {
    return !pointers_into(binding).empty();
}

bool SpirvModule::stores_into(std::uint32_t binding) const {
    const std::set<std::uint32_t> pointers = pointers_into(binding);
    return std::any_of(instructions_.begin(), instructions_.end(), [&](const SpirvInstruction& instruction) {
        return instruction.operation == kOpStore && pointers.contains(instruction.words[0]);
    });
}

std::uint32_t SpirvModule::Struct::end() const {
    return members.empty() ? 0 : members.back().offset + members.back().size;
}

std::uint32_t SpirvModule::size_of(std::uint32_t type) const {
    const auto found = types_.find(type);
    if (found == types_.end()) return 0;
    const std::vector<std::uint32_t>& words = found->second.words;
    switch (found->second.operation) {
        case kOpTypeInt:
        case kOpTypeFloat:
            return words[1] / 8;
        case kOpTypeVector:
            return words[2] * size_of(words[1]);
        case kOpTypeStruct: {
            const auto offsets = offsets_.find(type);
            if (offsets == offsets_.end() || words.size() < 2) return 0;
            const auto last = static_cast<std::uint32_t>(words.size() - 2);
            return offsets->second.at(last) + size_of(words.back());
        }
        case kOpTypeArray: {
            // Scalar layout packs elements. A length that is a specialization constant is in no buffer.
            const auto length = constants_.find(words[2]);
            return length == constants_.end() ? 0 : length->second * size_of(words[1]);
        }
        default:
            return 0;  // arrays whose length is open
    }
}

std::vector<SpirvModule::Struct> SpirvModule::laid_out_structs() const {
    std::map<std::uint32_t, std::uint32_t> strides;
    for (const SpirvInstruction& instruction : instructions_) {
        if (instruction.operation == kOpDecorate && instruction.words[1] == kArrayStride) {
            strides[instruction.words[0]] = instruction.words[2];
        }
    }
    std::vector<Struct> result;
    for (const auto& [id, offsets] : offsets_) {
        Struct laid_out;
        laid_out.name = names_.at(id);
        const std::vector<std::uint32_t>& words = types_.at(id).words;
        for (std::uint32_t i = 0; i + 1 < words.size(); ++i) {
            laid_out.members.push_back({member_names_.at(id).at(i), offsets.at(i), size_of(words[i + 1])});
        }
        for (const auto& [array, stride] : strides) {
            const auto found = types_.find(array);
            if (found != types_.end() && found->second.words[1] == id) laid_out.array_strides.insert(stride);
        }
        result.push_back(std::move(laid_out));
    }
    return result;
}

std::vector<std::uint32_t> without_no_contraction(std::span<const std::uint32_t> words) {
    std::vector<std::uint32_t> result(words.begin(), words.begin() + kHeaderWords);
    for (std::size_t at = kHeaderWords; at < words.size(); at += words[at] >> 16) {
        const std::uint32_t count = words[at] >> 16;
        const bool dropped = (words[at] & 0xffffu) == kOpDecorate && words[at + 2] == kNoContraction;
        if (!dropped) {
            const auto instruction = words.subspan(at, count);
            result.insert(result.end(), instruction.begin(), instruction.end());
        }
    }
    return result;
}

}  // namespace utsuri::test
