// SPDX-License-Identifier: Apache-2.0
// Lets one header declare the structs, binding numbers and specialization ids that C++ and GLSL share.
// Vectors are GLM's unaligned types in C++, and buffers use scalar layout in GLSL, so members have the same
// offsets in both; tests/gpu/interop_test.cpp holds the SPIR-V against offsetof.
#ifndef UTSURI_INTEROP_PRELUDE_H
#define UTSURI_INTEROP_PRELUDE_H

#ifdef __cplusplus
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>

namespace utsuri::interop {
using uint = std::uint32_t;
using glm::uvec2;
using glm::uvec3;
using glm::uvec4;
using glm::vec2;
using glm::vec3;
}  // namespace utsuri::interop

#define INTEROP_BEGIN namespace utsuri::interop {
#define INTEROP_END }
#define INTEROP_CONSTANT inline constexpr uint
#define INTEROP_FLOAT_CONSTANT inline constexpr float
#else
#define INTEROP_BEGIN
#define INTEROP_END
#define INTEROP_CONSTANT const uint
#define INTEROP_FLOAT_CONSTANT const float
#endif

INTEROP_BEGIN
/// An index that refers to nothing.
INTEROP_CONSTANT NONE = 0xffffffffu;
INTEROP_END

#endif
