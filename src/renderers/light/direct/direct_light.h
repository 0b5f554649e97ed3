// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/light/light.h"

namespace utsuri {

/// Direct light with shadows, no diffuse interreflection (Whitted 1980).
LightMethod direct_light();

}  // namespace utsuri
