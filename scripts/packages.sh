# SPDX-License-Identifier: Apache-2.0
# The Debian and Ubuntu packages the project uses, each with its reason. Read by scripts/setup.

# Needed to build and run the program.
build_packages=(
    "g++|C++20 compiler"
    "cmake|build system, 3.25 or later"
    "ninja-build|runs the build"
    "glslang-tools|compiles the kernels to SPIR-V"
    "spirv-tools|validates the SPIR-V"
    "libvulkan-dev|Vulkan headers and loader"
    "mesa-vulkan-drivers|software Vulkan (lavapipe), used where there is no GPU"
    "libglm-dev|vectors and matrices"
    "libfmt-dev|text formatting"
    "libopenimageio-dev|reads and writes pictures"
    "libtinygltf-dev|parses glTF"
    "nlohmann-json3-dev|JSON"
    "libcli11-dev|command line"
)

# Needed by the tests and benchmarks only.
test_packages=(
    "python3|scene generators and end-to-end tests"
    "libgtest-dev|unit tests"
    "libgmock-dev|unit tests"
    "libbenchmark-dev|benchmarks"
    "libembree-dev|oracle for hits, and the peer that benchmarks race"
    "vulkan-validationlayers|any message fails the tests"
    "clang-format|source layout"
    "clang-tidy|static checks (scripts/check-tidy)"
)

# Used by a test where it can be had; the test is skipped elsewhere.
optional_packages=(
    "chromium|opens report.html as a user would"
)
