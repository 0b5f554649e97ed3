// SPDX-License-Identifier: Apache-2.0
#include "renderers/light/direct/light_reach.h"

#include "renderers/device_scene/scene_triangles.h"

#include <algorithm>
#include <array>
#include <map>

namespace utsuri {
namespace {

/// How far a shadow ray may be off its way, and the test of it, as a share of the largest coordinate: from
/// the point that is tested and to the one aimed at, rays are moved off surfaces by some tens of roundings
/// (2^-24 each), and what they meet and the test of boxes round a few times more.
constexpr float kRounding = 0x1p-16f;

/// Neighbours in the list are put together until there are at most `most`.
std::vector<Bounds> joined(const std::vector<Bounds>& boxes, std::size_t most) {
    std::vector<Bounds> result(std::min(boxes.size(), most));
    for (std::size_t i = 0; i < boxes.size(); ++i)
        result[i * result.size() / boxes.size()].extend(boxes[i]);
    return result;
}

bool is_infinite(const interop::LightInfo& light) {
    return light.type == interop::LIGHT_DIRECTIONAL || light.type == interop::LIGHT_ENVIRONMENT;
}

/// Of the light, or of the directions to it.
Bounds bounds_of_light(const SceneData& data, const interop::LightInfo& light) {
    switch (light.type) {
        case interop::LIGHT_TRIANGLE:
            return bounds_of(data.bvh.triangles[light.triangle]);
        case interop::LIGHT_DIRECTIONAL:
            return {-light.direction, -light.direction};
        case interop::LIGHT_ENVIRONMENT:
            return {glm::vec3(-1.0f), glm::vec3(1.0f)};
        default:
            return {light.position, light.position};
    }
}

std::vector<Bounds> bounds_of_lights(const SceneData& data, bool infinite) {
    std::vector<Bounds> all;
    for (const interop::LightInfo& light : data.lights) {
        if (is_infinite(light) == infinite) all.push_back(bounds_of_light(data, light));
    }
    return joined(all, kMostLightBounds);
}

float largest_coordinate(const Bounds& box) {
    const glm::vec3 largest = glm::max(glm::abs(box.lower), glm::abs(box.upper));
    return std::max({largest.x, largest.y, largest.z});
}

}  // namespace

std::vector<interop::LightBounds> bounds_of_lights(const SceneData& data) {
    std::vector<interop::LightBounds> result;
    for (const bool infinite : {false, true}) {
        for (const Bounds& box : bounds_of_lights(data, infinite))
            result.push_back({infinite ? 1u : 0u, box.lower, box.upper});
    }
    return result;
}

ChangedSpace changed_space(const SceneData& data, const SceneChange& change) {
    struct Places {
        Bounds before;
        Bounds after;
    };
    std::map<std::uint32_t, Places> instances;
    for (std::size_t i = 0; i < change.triangles.size(); ++i) {
        Places& places = instances[data.triangle_infos[change.triangles[i]].instance];
        places.before.extend(bounds_of(change.before[i]));
        places.after.extend(bounds_of(data.bvh.triangles[change.triangles[i]]));
    }
    std::vector<Bounds> boxes;
    Bounds space = data.bounds;
    for (const auto& [instance, places] : instances) {
        for (const Bounds& box : {places.before, places.after}) {
            boxes.push_back(box);
            space.extend(box);
        }
    }
    for (const Bounds& box : bounds_of_lights(data, false))
        space.extend(box);
    const glm::vec3 room(kRounding * largest_coordinate(space));
    ChangedSpace result{change.triangles, {}};
    for (const Bounds& box : joined(boxes, kMostChangedBoxes))
        result.boxes.push_back({box.lower - room, box.upper + room});
    return result;
}

}  // namespace utsuri
