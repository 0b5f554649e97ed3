// SPDX-License-Identifier: Apache-2.0
#include "renderers/scene/light_list.h"

#include "renderers/scene/light_table.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace utsuri {
namespace {

constexpr double kPi = std::numbers::pi;

double rec709_luminance(const glm::vec3& c) {
    return 0.2126 * static_cast<double>(c.x) + 0.7152 * static_cast<double>(c.y) +
           0.0722 * static_cast<double>(c.z);
}

double triangle_area(const interop::BvhTriangle& triangle) {
    const glm::dvec3 v0(triangle.v0);
    return 0.5 * glm::length(glm::cross(glm::dvec3(triangle.v1) - v0, glm::dvec3(triangle.v2) - v0));
}

/// Collects lights with their power in lumens over 4 pi, which is what they are chosen by.
class LightList {
  public:
    explicit LightList(SceneData& data) : data_(data) {
        radius_ = 0.5 * glm::length(glm::dvec3(data.bounds.empty() ? glm::vec3(0.0f) : data.bounds.extent()));
    }

    void add(const interop::LightInfo& info, double power) {
        if (!(power > 0.0)) return;
        data_.lights.push_back(info);
        weights_.push_back(power);
    }

    void add_environment(const glm::vec3& radiance) {
        interop::LightInfo info{};
        info.type = interop::LIGHT_ENVIRONMENT;
        info.triangle = interop::NONE;
        info.intensity = radiance;
        // An empty scene has no size; the environment is still its light.
        const double disc = radius_ > 0.0 ? kPi * radius_ * radius_ : 1.0;
        add(info, kPi * disc * rec709_luminance(radiance));
    }

    void add_punctual(const Light& light, const glm::dvec3& origin) {
        interop::LightInfo info{};
        info.triangle = interop::NONE;
        info.position = glm::vec3(light.position - origin);
        info.direction = glm::vec3(light.direction);
        info.intensity = light.intensity;
        info.range =
            light.range > 0.0 ? static_cast<float>(light.range) : std::numeric_limits<float>::infinity();
        const double cos_outer = std::cos(light.outer_cone_angle);
        const double scale = 1.0 / std::max(0.001, std::cos(light.inner_cone_angle) - cos_outer);
        info.spot_scale = static_cast<float>(scale);
        info.spot_offset = static_cast<float>(-cos_outer * scale);
        const double intensity = rec709_luminance(light.intensity);
        switch (light.type) {
            case LightType::point:
                info.type = interop::LIGHT_POINT;
                return add(info, 4.0 * kPi * intensity);
            case LightType::spot:
                info.type = interop::LIGHT_SPOT;
                return add(info, 2.0 * kPi * (1.0 - cos_outer) * intensity);
            case LightType::directional:
                info.type = interop::LIGHT_DIRECTIONAL;
                return add(info, kPi * radius_ * radius_ * intensity);
        }
    }

    void add_triangle(std::uint32_t triangle, const glm::vec3& radiance, bool double_sided) {
        interop::LightInfo info{};
        info.type = interop::LIGHT_TRIANGLE;
        info.triangle = triangle;
        const double area = triangle_area(data_.bvh.triangles[triangle]);
        const std::size_t before = data_.lights.size();
        add(info, kPi * area * rec709_luminance(radiance) * (double_sided ? 2.0 : 1.0));
        if (data_.lights.size() > before)
            data_.triangle_infos[triangle].light = static_cast<std::uint32_t>(before);
    }

    void finish() { make_light_table(weights_, data_.lights); }

  private:
    SceneData& data_;
    double radius_ = 0.0;
    std::vector<double> weights_;
};

}  // namespace

void list_lights(const Scene& scene, std::span<const glm::vec3> emission, SceneData& data) {
    data.lights.clear();
    LightList lights(data);
    if (data.requirements.environment) lights.add_environment(scene.environment);
    for (const Light& light : scene.lights)
        lights.add_punctual(light, data.origin);
    for (std::uint32_t i = 0; i < data.triangle_infos.size(); ++i) {
        data.triangle_infos[i].light = interop::NONE;
        const std::uint32_t material = data.triangle_infos[i].material;
        if (emission[material] == glm::vec3(0.0f)) continue;
        lights.add_triangle(i, emission[material], scene.materials[material].double_sided);
    }
    lights.finish();
}

}  // namespace utsuri
