// SPDX-License-Identifier: Apache-2.0
#include "session/checked_settings.h"

#include "renderers/film/render_settings.h"
#include "renderers/methods/reflection.h"

#include "base/error.h"
#include "scene/check_scene.h"

#include <fmt/format.h>

namespace utsuri {

const LightSettings& checked(const LightSettings& light) {
    if (!(light.spacing > 0.0) || light.samples < 1 || light.samples > kMostLightSamples ||
        light.points_per_dispatch < 1) {
        throw UsageError(
            "keep light on surfaces",
            fmt::format("{} samples at points {:g} apart", light.samples, light.spacing),
            fmt::format("samples may be 1 to {}, points more than 0 apart, and at least one of them "
                        "in a dispatch",
                        kMostLightSamples));
    }
    return light;
}

const Camera& checked(const Camera& camera) {
    if (const auto fault = find_fault(camera)) throw UsageError("use camera", fault->name, fault->problem);
    return camera;
}

void check_picture_size(std::uint32_t width, std::uint32_t height) {
    if (width >= 1 && width <= kLargestPictureEdge && height >= 1 && height <= kLargestPictureEdge) return;
    throw UsageError("make a picture", fmt::format("of {} x {} pixels", width, height),
                     fmt::format("each edge must have 1 to {}", kLargestPictureEdge));
}

const PictureSettings& checked(const PictureSettings& settings) {
    if (settings.method.light == nullptr || settings.method.reflection == nullptr) {
        throw UsageError("make a picture", "of no method",
                         "both of its axes must be set: take it from find_method()");
    }
    checked(settings.camera);
    check_picture_size(settings.render.width, settings.render.height);
    check_map_settings(settings.maps);
    return settings;
}

}  // namespace utsuri
