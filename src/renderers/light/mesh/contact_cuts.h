// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/light/mesh/contacts.h"
#include "renderers/light/mesh/mesh_tree.h"

namespace utsuri {

/// Splits the leaves of a new mesh along the lines in which things touch or cross them. Leaves on both sides
/// then have points of their own, a little off the line: no light is interpolated across it.
/// @param finest leaves are not split below a fraction of it, metres
/// @param most_points after which triangles are left whole
void cut_at_contacts(MeshTree& mesh, const SceneData& scene, const ContactFinder& finder, double finest,
                     std::uint64_t most_points);

}  // namespace utsuri
