// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/scene.h"

namespace utsuri {

/// A camera named "default" that sees the whole scene from a three-quarter view, with a vertical field of
/// view of 45 degrees; at the origin, looking along -Z, where the scene is empty.
/// @param scene valid: check_scene(), but for its cameras
Camera frame_scene(const Scene& scene);

}  // namespace utsuri
