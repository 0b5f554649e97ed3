// SPDX-License-Identifier: Apache-2.0
#include "support/product_kernels.h"

#include "base/file.h"

#include <cstring>
#include <filesystem>
#include <sstream>
#include <utility>

namespace utsuri::test {

std::vector<ProductKernel> product_kernels() {
    std::vector<ProductKernel> kernels;
    std::istringstream names(UTSURI_KERNELS);
    for (std::string name; std::getline(names, name, ',');) {
        const std::vector<std::byte> bytes =
            read_file(std::filesystem::path(UTSURI_SPIRV_FOLDER) / (name + ".spv"), "read kernel");
        ProductKernel kernel{name, std::vector<std::uint32_t>(bytes.size() / sizeof(std::uint32_t))};
        std::memcpy(kernel.spirv.data(), bytes.data(), bytes.size());
        kernels.push_back(std::move(kernel));
    }
    return kernels;
}

}  // namespace utsuri::test
