// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "interop/light_mesh.h"

#include <cstdint>
#include <span>
#include <vector>

namespace utsuri {

/// Numbers of places in an order in which neighbours on a surface follow each other: triangles as they lie in
/// the scene, places of one triangle along a Z curve (Morton 1966). What is done for neighbours at once, such
/// as rays to one light, takes similar ways.
std::vector<std::uint32_t> order_by_place(std::span<const interop::LightMeshPlace> places);

}  // namespace utsuri
