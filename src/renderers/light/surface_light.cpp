// SPDX-License-Identifier: Apache-2.0
#include "renderers/light/surface_light.h"

#include "renderers/light/lobe_albedo.h"

#include "interop/bindings.h"

namespace utsuri {

SurfaceLight::SurfaceLight(Device& device, bool under_glossy)
    : lobe_albedos_(make_buffer<interop::LobeAlbedo>(
          device, under_glossy ? lobe_albedo_table() : std::vector<interop::LobeAlbedo>(),
          "albedos of lobes")) {}

Bindings SurfaceLight::bindings() const {
    Bindings bindings = kept_bindings();
    bindings[interop::BINDING_LOBE_ALBEDO] = &lobe_albedos_;
    return bindings;
}

}  // namespace utsuri
