// SPDX-License-Identifier: Apache-2.0
#include "session/checked_settings.h"

#include "renderers/film/render_settings.h"
#include "renderers/methods/reflection.h"

#include "base/error.h"
#include "scene/check_scene.h"

#include <fmt/format.h>

#include <cmath>

namespace utsuri {

const LightSettings& checked(const LightSettings& light) {
    const std::string object = fmt::format(
        "{} samples, spacing {:g}, refinement {:g}, tolerance {:g}, {} points in a dispatch", light.samples,
        light.spacing, light.refinement, light.tolerance, light.points_per_dispatch);
    const auto refuse = [&](const std::string& problem) {
        throw UsageError("keep light on surfaces", object, problem);
    };
    if (light.samples < 1 || light.samples > kMostLightSamples)
        refuse(fmt::format("samples may be 1 to {}", kMostLightSamples));
    if (!(light.spacing > 0.0) || !std::isfinite(light.spacing))
        refuse("the spacing must be finite and more than 0");
    if (!(light.refinement >= 1.0) || !std::isfinite(light.refinement))
        refuse("the refinement must be finite and at least 1");
    if (!(light.tolerance >= 0.0)) refuse("the tolerance must be at least 0");
    if (light.points_per_dispatch < 1) refuse("a dispatch must have at least a point");
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
