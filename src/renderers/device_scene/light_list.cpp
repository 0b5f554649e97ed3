// SPDX-License-Identifier: Apache-2.0
#include "renderers/device_scene/light_list.h"

#include "renderers/device_scene/light_tree.h"
#include "renderers/device_scene/scene_triangles.h"

#include "base/check.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <vector>

namespace utsuri {
namespace {

constexpr double kPi = std::numbers::pi;

double rec709_luminance(const glm::vec3& c) {
    return 0.2126 * static_cast<double>(c.x) + 0.7152 * static_cast<double>(c.y) +
           0.0722 * static_cast<double>(c.z);
}

/// Collects lights with their power in lumens; those that are nowhere have to come first.
class LightList {
  public:
    explicit LightList(SceneData& data) : data_(data) {
        radius_ = 0.5 * glm::length(glm::dvec3(data.bounds.empty() ? glm::vec3(0.0f) : data.bounds.extent()));
    }

    void add_environment(const glm::vec3& radiance) {
        interop::LightInfo info{};
        info.type = interop::LIGHT_ENVIRONMENT;
        info.triangle = interop::NONE;
        info.intensity = radiance;
        // An empty scene has no size; the environment is still its light.
        const double disc = radius_ > 0.0 ? kPi * radius_ * radius_ : 1.0;
        add_infinite(info, kPi * disc * rec709_luminance(radiance));
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
        const glm::dvec3 place(info.position);
        switch (light.type) {
            case LightType::point:
                info.type = interop::LIGHT_POINT;
                return add(info, {place, place, glm::dvec3(0.0), false, 4.0 * kPi * intensity});
            case LightType::spot:
                info.type = interop::LIGHT_SPOT;
                // What it shines into is within a quarter turn of its axis.
                return add(info, {place, place, glm::normalize(light.direction), false,
                                  2.0 * kPi * (1.0 - cos_outer) * intensity});
            case LightType::directional:
                info.type = interop::LIGHT_DIRECTIONAL;
                return add_infinite(info, kPi * radius_ * radius_ * intensity);
        }
    }

    void add_triangle(std::uint32_t triangle, const glm::vec3& radiance, bool double_sided) {
        interop::LightInfo info{};
        info.type = interop::LIGHT_TRIANGLE;
        info.triangle = triangle;
        const Corners corners = corners_of(data_, triangle);
        const glm::dvec3 area = 0.5 * doubled_area(corners);
        const double size = glm::length(area);
        if (!(size > 0.0)) return;
        const std::size_t before = data_.lights.size();
        add(info, {glm::min(corners[0], glm::min(corners[1], corners[2])),
                   glm::max(corners[0], glm::max(corners[1], corners[2])), area / size, double_sided,
                   kPi * size * rec709_luminance(radiance) * (double_sided ? 2.0 : 1.0)});
        if (data_.lights.size() > before)
            data_.triangle_infos[triangle].light = static_cast<std::uint32_t>(before);
    }

    /// Sets by what they are chosen.
    void finish() {
        double local = 0.0;
        for (const TreeLight& light : local_)
            local += light.power;
        const double total = std::accumulate(infinite_.begin(), infinite_.end(), local);
        for (std::size_t i = 0; i < data_.lights.size(); ++i) {
            const double power = i < infinite_.size() ? infinite_[i] : local;
            data_.lights[i].probability = static_cast<float>(power / total);
        }
        data_.light_tree = build_light_tree(local_, std::span(data_.lights).subspan(infinite_.size()),
                                            static_cast<std::uint32_t>(infinite_.size()));
    }

  private:
    void add(const interop::LightInfo& info, const TreeLight& light) {
        if (!(light.power > 0.0)) return;
        data_.lights.push_back(info);
        local_.push_back(light);
    }
    void add_infinite(const interop::LightInfo& info, double power) {
        if (!(power > 0.0)) return;
        UTSURI_CHECK_EQ(local_.size(), 0u);
        data_.lights.push_back(info);
        infinite_.push_back(power);
    }

    SceneData& data_;
    double radius_ = 0.0;
    std::vector<double> infinite_;  ///< power of lights that are nowhere
    std::vector<TreeLight> local_;
};

}  // namespace

void list_lights(const Scene& scene, std::span<const glm::vec3> emission, SceneData& data) {
    data.lights.clear();
    LightList lights(data);
    if (data.requirements.environment) lights.add_environment(scene.environment);
    for (const bool directional : {true, false}) {
        for (const Light& light : scene.lights) {
            if ((light.type == LightType::directional) == directional)
                lights.add_punctual(light, data.origin);
        }
    }
    for (std::uint32_t i = 0; i < data.triangle_infos.size(); ++i) {
        data.triangle_infos[i].light = interop::NONE;
        const std::uint32_t material = data.triangle_infos[i].material;
        if (emission[material] == glm::vec3(0.0f)) continue;
        lights.add_triangle(i, emission[material], scene.materials[material].double_sided);
    }
    lights.finish();
}

}  // namespace utsuri
