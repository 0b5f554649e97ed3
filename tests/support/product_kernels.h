// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace utsuri::test {

/// The SPIR-V of a kernel of the product, with the file it was compiled from.
struct ProductKernel {
    std::string name;
    std::span<const std::uint32_t> spirv;
};

/// All of them; shaders/CMakeLists.txt lists them too.
std::vector<ProductKernel> product_kernels();

}  // namespace utsuri::test
