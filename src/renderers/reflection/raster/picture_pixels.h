// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/attachment.h"

#include <glm/vec4.hpp>

#include <vector>

namespace utsuri {

/// The four channels of a picture that was drawn, row-major, top row first.
std::vector<glm::vec4> picture_pixels(Device& device, const Attachment& picture);

/// How the reflections of drawn pixels were found, by their fourth channel: Renderer::traced_pixels().
std::vector<float> traced_pixels_of(const std::vector<glm::vec4>& pixels);

}  // namespace utsuri
