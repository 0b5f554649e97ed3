// SPDX-License-Identifier: Apache-2.0
#include "renderers/film/frame_camera.h"

#include <cmath>

namespace utsuri {

interop::CameraInfo make_camera_info(const Camera& camera, const glm::dvec3& scene_origin,
                                     std::uint32_t width, std::uint32_t height) {
    const double half_height = std::tan(0.5 * camera.vertical_fov);
    const double half_width = half_height * static_cast<double>(width) / static_cast<double>(height);
    return {glm::vec3(camera.position - scene_origin), glm::vec3(half_width * camera.right),
            glm::vec3(half_height * camera.up), glm::vec3(camera.forward)};
}

}  // namespace utsuri
