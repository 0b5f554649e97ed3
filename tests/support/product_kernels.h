// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace utsuri::test {

/// The SPIR-V of a kernel of the product, with the names that it has in the source.
struct ProductKernel {
    std::string name;
    std::vector<std::uint32_t> spirv;
};

/// All of shaders/CMakeLists.txt.
std::vector<ProductKernel> product_kernels();

}  // namespace utsuri::test
