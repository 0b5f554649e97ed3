// SPDX-License-Identifier: Apache-2.0
#include "import/conversion/lights.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace utsuri {
namespace {

constexpr const char* kExtension = "KHR_lights_punctual";

using Json = nlohmann::json;

/// Angles that are equal may differ by this share when they are kept in float32: by a rounding of each.
constexpr double kAngleRounding = 0x1p-23;

void read_cone(ImportContext& context, const Json& source, const std::string& place, Light& light) {
    const Json& spot = source["spot"];
    const double inner = spot.value("innerConeAngle", 0.0);
    const double outer = spot.value("outerConeAngle", std::numbers::pi / 4.0);
    if (inner > outer * (1.0 + kAngleRounding)) {
        context.document.fail(place + ".spot.innerConeAngle",
                              fmt::format("is {}; must be less than outerConeAngle, {}", inner, outer));
    }
    if (inner >= outer)
        context.ignored.add("spots whose inner cone is as wide as the outer one have a hard edge", place);
    light.outer_cone_angle = std::min(outer, std::numbers::pi / 2.0);
    light.inner_cone_angle = std::min(inner, light.outer_cone_angle);
}

glm::vec3 read_intensity(const Document& document, const Json& source, const std::string& place) {
    const double intensity = source.value("intensity", 1.0);
    glm::vec3 product(static_cast<float>(intensity));
    if (source.contains("color")) {
        for (int c = 0; c < 3; ++c) {
            const double colour = source["color"][static_cast<std::size_t>(c)];
            product[c] = static_cast<float>(colour * intensity);
        }
    }
    for (int c = 0; c < 3; ++c) {
        if (std::isfinite(product[c])) continue;
        document.fail(
            place + ".intensity",
            fmt::format("is {}, which times color is beyond the range of float32; must be below 3.4e38",
                        intensity));
    }
    return product;
}

LightType light_type(const std::string& name) {
    if (name == "spot") return LightType::spot;
    return name == "point" ? LightType::point : LightType::directional;
}

}  // namespace

void import_light(ImportContext& context, const PlacedNode& placed) {
    const Document& document = context.document;
    const Json& reference = extension_of(document.json["nodes"][placed.node], kExtension);
    if (!reference.contains("light")) return;
    const std::size_t index = reference["light"];
    const Json& source = extension_of(document.json, kExtension)["lights"][index];
    const std::string place = fmt::format("extensions.{}.lights[{}]", kExtension, index);
    Light light;
    light.type = light_type(source["type"]);
    const std::string& node_name = document.model.nodes[placed.node].name;
    light.name = source.value("name", node_name.empty() ? fmt::format("nodes[{}]", placed.node) : node_name);
    light.intensity = read_intensity(document, source, place);
    light.range = source.value("range", 0.0);
    if (light.type == LightType::spot) read_cone(context, source, place, light);
    light.position = glm::dvec3(placed.world_from_node[3]);
    const glm::dvec3 direction(-placed.world_from_node[2]);
    const double length = glm::length(direction);
    if (light.type != LightType::point) {
        if (!std::isfinite(length) || length == 0.0) {
            context.ignored.add("lights whose node has no direction left are not used",
                                fmt::format("nodes[{}]", placed.node));
            return;
        }
        light.direction = direction / length;
    }
    context.result.scene.lights.push_back(light);
}

void add_default_light(ImportContext& context) {
    Scene& scene = context.result.scene;
    const auto emits = [&](const Instance& instance) {
        const glm::vec3 emissive = scene.materials[instance.material].emissive;
        return emissive.x > 0.0f || emissive.y > 0.0f || emissive.z > 0.0f;
    };
    if (!scene.lights.empty() || std::any_of(scene.instances.begin(), scene.instances.end(), emits)) return;
    scene.environment = glm::vec3(1.0f);
    context.result.added.emplace_back("no light in the file: lit by a uniform environment of 1 cd/m2");
}

}  // namespace utsuri
