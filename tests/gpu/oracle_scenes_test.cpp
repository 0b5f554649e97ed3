// SPDX-License-Identifier: Apache-2.0
#include "import/conversion/gltf.h"
#include "support/test_device.h"

#include "gpu/oracle_comparison.h"

#include <filesystem>
#include <string>

namespace utsuri {
namespace {

class EmbreeComparisonOfScenes : public DeviceTest {
  protected:
    static void compare(const std::string& name) {
        const auto path = std::filesystem::path(UTSURI_SOURCE_DIR) / "scenes" / name / (name + ".glb");
        test::compare_with_embree(device(), import_gltf(path).scene);
    }
};

TEST_F(EmbreeComparisonOfScenes, Office) {
    compare("office-lambert");
}
TEST_F(EmbreeComparisonOfScenes, Cornell) {
    compare("cornell");
}
TEST_F(EmbreeComparisonOfScenes, Spheres) {
    compare("spheres");
}

}  // namespace
}  // namespace utsuri
