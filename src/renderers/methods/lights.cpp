// SPDX-License-Identifier: Apache-2.0
// The light axis: a new light is a folder of renderers/light and a line here.
#include "renderers/light/direct/direct_light.h"
#include "renderers/methods/method.h"

#include <array>

namespace utsuri {

std::span<const LightMethod> light_methods() {
    static const std::array kLights = {direct_light()};
    return kLights;
}

}  // namespace utsuri
