// SPDX-License-Identifier: Apache-2.0
// Watertight intersection and compensated sums hold only as long as no multiplication is fused into a sum:
// what GLSL calls `precise` and SPIR-V NoContraction. Front ends have lost that on the way, so the modules
// themselves are read.
#include "support/product_kernels.h"
#include "support/spirv_module.h"

#include "interop/bindings.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

namespace utsuri {
namespace {

using test::SpirvInstruction;
using test::SpirvModule;
using testing::HasSubstr;

bool is_product(std::uint32_t operation) {
    return operation == test::kOpFMul || operation == test::kOpVectorTimesScalar;
}

bool is_sum(std::uint32_t operation) {
    return operation == test::kOpFAdd || operation == test::kOpFSub;
}

/// Products, differences and sums of a function, all of them and those that may not be contracted.
struct Arithmetic {
    int products = 0;
    int differences = 0;
    int sums = 0;
};

struct FunctionArithmetic {
    Arithmetic all;
    Arithmetic uncontracted;
    /// Sums over a product, of which one or the other may be contracted.
    int contractible = 0;
};

FunctionArithmetic arithmetic_of(const SpirvModule& module, const std::string& function) {
    const std::set<std::uint32_t> uncontracted = module.uncontracted();
    FunctionArithmetic result;
    std::map<std::uint32_t, std::uint32_t> operations;  // by result id
    for (const SpirvInstruction& instruction : module.function(function)) {
        if (!is_product(instruction.operation) && !is_sum(instruction.operation)) continue;
        // Operands of these: result type, result, two values.
        const std::uint32_t id = instruction.words[1];
        operations[id] = instruction.operation;
        const auto count = [&](Arithmetic& arithmetic) {
            arithmetic.products += is_product(instruction.operation) ? 1 : 0;
            arithmetic.differences += instruction.operation == test::kOpFSub ? 1 : 0;
            arithmetic.sums += instruction.operation == test::kOpFAdd ? 1 : 0;
        };
        count(result.all);
        if (uncontracted.contains(id)) count(result.uncontracted);
        if (!is_sum(instruction.operation)) continue;
        for (const std::uint32_t value : {instruction.words[2], instruction.words[3]}) {
            const auto found = operations.find(value);
            if (found == operations.end() || !is_product(found->second)) continue;
            if (!uncontracted.contains(id) || !uncontracted.contains(value)) ++result.contractible;
        }
    }
    return result;
}

/// What is wrong with the edge functions of a module; empty if nothing.
std::string edge_function_problem(const SpirvModule& module) {
    const FunctionArithmetic found = arithmetic_of(module, "intersect_triangle");
    // Three sheared vertices (a product and a difference each), three edge functions (two products and a
    // difference each), determinant (two sums), depth (three products, two sums).
    const Arithmetic& kept = found.uncontracted;
    if (kept.products < 3 + 6 + 3 || kept.differences < 3 + 3 || kept.sums < 2 + 2) {
        return fmt::format("{} products, {} differences and {} sums are kept from contraction", kept.products,
                           kept.differences, kept.sums);
    }
    if (found.contractible > 0)
        return fmt::format("{} sums over products may be contracted", found.contractible);
    return {};
}

/// What is wrong with the compensated sum of a module; empty if nothing.
std::string compensated_sum_problem(const SpirvModule& module) {
    const FunctionArithmetic found = arithmetic_of(module, "add_compensated");
    // value - compensation, sum + corrected, (total - sum) - corrected.
    if (found.uncontracted.sums != 1 || found.uncontracted.differences != 3) {
        return fmt::format("{} sums and {} differences are kept from contraction", found.uncontracted.sums,
                           found.uncontracted.differences);
    }
    if (found.all.sums != 1 || found.all.differences != 3) {
        return fmt::format("{} sums and {} differences in all", found.all.sums, found.all.differences);
    }
    return {};
}

/// Names of the product's kernels for which a question is answered with yes.
template <typename Question>
std::set<std::string> kernels_for_which(const Question& question) {
    std::set<std::string> names;
    for (const test::ProductKernel& kernel : test::product_kernels())
        if (question(SpirvModule(kernel.spirv))) names.insert(kernel.name);
    return names;
}

std::set<std::string> kernels_with(const std::string& function) {
    return kernels_for_which([&](const SpirvModule& module) { return !module.function(function).empty(); });
}

// What a kernel does tells what it must hold, whatever its functions are called: without this, an edge
// function under another name, or one that the compiler takes apart, would be looked at by no test.
TEST(NoContractionKernels, AllThatSearchTheTreeHaveTheEdgeFunctions) {
    auto searching = kernels_for_which(
        [](const SpirvModule& module) { return module.reaches(interop::BINDING_BVH_NODES); });
    // Vertex stages look up the bounds of the root, and no more: they have no rays.
    std::erase_if(searching, [](const std::string& name) { return name.ends_with("_vert"); });
    EXPECT_FALSE(searching.empty());
    EXPECT_EQ(kernels_with("intersect_triangle"), searching);
}

TEST(NoContractionKernels, AllThatAddToFilmsHaveTheCompensatedSum) {
    const auto adding = kernels_for_which(
        [](const SpirvModule& module) { return module.stores_into(interop::BINDING_FILM); });
    EXPECT_FALSE(adding.empty());
    EXPECT_EQ(kernels_with("add_compensated"), adding);
}

class NoContraction : public testing::TestWithParam<std::string> {
  protected:
    static std::vector<std::uint32_t> spirv() {
        for (const test::ProductKernel& kernel : test::product_kernels()) {
            if (kernel.name == GetParam()) return kernel.spirv;
        }
        return {};
    }
};

std::string name_of(const testing::TestParamInfo<std::string>& info) {
    return info.param;
}

class NoContractionInEdgeFunctions : public NoContraction {};

TEST_P(NoContractionInEdgeFunctions, IsKeptByTheCompiler) {
    EXPECT_EQ(edge_function_problem(SpirvModule(spirv())), "");
}

TEST_P(NoContractionInEdgeFunctions, IsMissedWithoutPrecise) {
    const SpirvModule stripped(test::without_no_contraction(spirv()));
    EXPECT_TRUE(stripped.uncontracted().empty());
    EXPECT_THAT(edge_function_problem(stripped), HasSubstr("0 products, 0 differences"));
}

INSTANTIATE_TEST_SUITE_P(Kernels, NoContractionInEdgeFunctions,
                         testing::ValuesIn(kernels_with("intersect_triangle")), name_of);

class NoContractionInCompensatedSums : public NoContraction {};

TEST_P(NoContractionInCompensatedSums, IsKeptByTheCompiler) {
    EXPECT_EQ(compensated_sum_problem(SpirvModule(spirv())), "");
}

TEST_P(NoContractionInCompensatedSums, IsMissedWithoutPrecise) {
    EXPECT_NE(compensated_sum_problem(SpirvModule(test::without_no_contraction(spirv()))), "");
}

INSTANTIATE_TEST_SUITE_P(Kernels, NoContractionInCompensatedSums,
                         testing::ValuesIn(kernels_with("add_compensated")), name_of);

}  // namespace
}  // namespace utsuri
