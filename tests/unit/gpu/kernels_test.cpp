// SPDX-License-Identifier: Apache-2.0
#include "support/product_kernels.h"
#include "support/spirv_module.h"

#include "gpu/spirv.h"

#include "interop/bindings.h"
#include "interop/frame.h"
#include "interop/raster.h"
#include "interop/rays.h"
#include "interop/specialization.h"
#include "interop/workgroup.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>

namespace utsuri {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::Not;

const fs::path kShaders = fs::path(UTSURI_SOURCE_DIR) / "shaders";

/// Values of the constants with a name prefix that an interop header declares.
std::set<std::uint32_t> declared(const std::string& header, const std::string& prefix) {
    std::ifstream stream(kShaders / "interop" / header);
    const std::regex constant("INTEROP_CONSTANT (" + prefix + "[A-Z0-9_]+) = ([0-9]+)u;");
    std::set<std::uint32_t> values;
    for (std::string line; std::getline(stream, line);) {
        std::smatch match;
        if (!std::regex_search(line, match, constant) || match[1] == prefix + "COUNT") continue;
        const bool added = values.insert(static_cast<std::uint32_t>(std::stoul(match[2]))).second;
        EXPECT_TRUE(added) << match[1] << " has a number that is taken";
    }
    return values;
}

/// What the execution mode LocalSize says, or LocalSizeId by way of constants.
std::uint32_t invocations_per_group(std::span<const std::uint32_t> spirv) {
    constexpr std::uint32_t kOpExecutionMode = 16;
    constexpr std::uint32_t kOpConstant = 43;
    constexpr std::uint32_t kOpExecutionModeId = 331;
    constexpr std::uint32_t kLocalSize = 17;
    constexpr std::uint32_t kLocalSizeId = 38;
    std::map<std::uint32_t, std::uint32_t> constants;
    std::vector<std::uint32_t> size;
    std::vector<std::uint32_t> size_ids;
    const test::SpirvModule module(spirv);
    for (const test::SpirvInstruction& instruction : module.instructions()) {
        const std::vector<std::uint32_t>& words = instruction.words;
        if (instruction.operation == kOpConstant) constants[words[1]] = words[2];
        if (instruction.operation == kOpExecutionMode && words[1] == kLocalSize)
            size = {words.begin() + 2, words.end()};
        if (instruction.operation == kOpExecutionModeId && words[1] == kLocalSizeId) {
            size_ids = {words.begin() + 2, words.end()};
        }
    }
    for (const std::uint32_t id : size_ids)
        size.push_back(constants.at(id));
    return size.size() == 3 ? size[0] * size[1] * size[2] : 0;
}

TEST(Kernels, AreAllKnownToTheTests) {
    std::set<std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(kShaders / "kernels")) {
        const std::string stem = entry.path().stem().string();
        const std::string extension = entry.path().extension().string();
        if (extension == ".comp") files.insert(stem);
        if (extension == ".vert" || extension == ".frag") files.insert(stem + "_" + extension.substr(1));
    }
    std::set<std::string> names;
    for (const test::ProductKernel& kernel : test::product_kernels())
        names.insert(kernel.name);
    EXPECT_EQ(names, files);
}

TEST(Kernels, BindOnlyWhatInteropNumbers) {
    const std::set<std::uint32_t> numbers = declared("bindings.h", "BINDING_");
    EXPECT_EQ(numbers.size(), interop::BINDING_COUNT);
    std::set<std::uint32_t> used;
    for (const test::ProductKernel& kernel : test::product_kernels()) {
        for (const SpirvBinding& binding : spirv_bindings(kernel.spirv)) {
            EXPECT_THAT(numbers, Contains(binding.number)) << kernel.name;
            used.insert(binding.number);
        }
    }
    EXPECT_EQ(used, numbers) << "a binding number that no kernel uses";
}

// Metal binds 31 buffers to a stage, of which MoltenVK takes one for push constants; lavapipe binds 32.
// Buffers that are read as texels are bound as textures, of which there may be more. What the fullest kernel
// leaves is room for what surfaces and lights will ask for: a new buffer there is paid for here.
TEST(Kernels, LeaveRoomAmongTheBuffersThatDevicesBindToAStage) {
    constexpr std::size_t kMostBuffers = 30;
    constexpr std::size_t kRoom = 2;
    for (const test::ProductKernel& kernel : test::product_kernels()) {
        const std::vector<SpirvBinding> bindings = spirv_bindings(kernel.spirv);
        const auto buffers = std::count_if(bindings.begin(), bindings.end(), [](const SpirvBinding& binding) {
            return binding.kind != BindingKind::texels;
        });
        EXPECT_LE(static_cast<std::size_t>(buffers), kMostBuffers - kRoom) << kernel.name;
    }
}

// What the scene holds is in one set, which all methods share; what a method adds is in the other.
TEST(Kernels, KeepTheSceneInASetOfItsOwn) {
    for (const test::ProductKernel& kernel : test::product_kernels()) {
        for (const SpirvBinding& binding : spirv_bindings(kernel.spirv)) {
            const bool is_scene = binding.number <= interop::BINDING_LIGHT_TREE;
            EXPECT_EQ(binding.set, is_scene ? interop::SCENE_SET : interop::METHOD_SET)
                << kernel.name << ", binding " << binding.number;
        }
    }
}

TEST(Kernels, SpecializeOnlyWhatInteropNumbers) {
    const std::set<std::uint32_t> ids = declared("specialization.h", "SPEC_");
    EXPECT_EQ(ids.size(), interop::SPEC_COUNT);
    std::set<std::uint32_t> used;
    for (const test::ProductKernel& kernel : test::product_kernels()) {
        for (const std::uint32_t id : spirv_specialization_ids(kernel.spirv)) {
            EXPECT_LT(id, interop::SPEC_COUNT) << kernel.name;
            used.insert(id);
        }
    }
    EXPECT_EQ(used, ids) << "a specialization id that no kernel uses";
}

TEST(Kernels, HaveTheWorkgroupsThatTheHostCountsWith) {
    for (const test::ProductKernel& kernel : test::product_kernels()) {
        const bool is_drawn = kernel.name.ends_with("_vert") || kernel.name.ends_with("_frag");
        EXPECT_EQ(invocations_per_group(kernel.spirv), is_drawn ? 0u : interop::WORKGROUP_SIZE)
            << kernel.name;
    }
    EXPECT_EQ(interop::TILE_SIZE * interop::TILE_SIZE, interop::WORKGROUP_SIZE);
}

TEST(Kernels, FitTheirPushConstantsIntoWhatEveryDeviceHas) {
    constexpr std::size_t kGuaranteed = 128;  // Vulkan 1.3, table "Required Limits"
    EXPECT_LE(sizeof(interop::FramePush), kGuaranteed);
    EXPECT_LE(sizeof(interop::ViewPush), kGuaranteed);
}

}  // namespace
}  // namespace utsuri
