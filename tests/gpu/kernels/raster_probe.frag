// SPDX-License-Identifier: Apache-2.0
// Says which triangle covers a pixel, counted from 1, and where in the picture.
#version 460
#extension GL_EXT_scalar_block_layout : require

layout(constant_id = 0) const float MARK = 1.0;

layout(location = 0) in vec2 position;
layout(location = 1) flat in uint triangle;
layout(location = 0) out vec4 found;

void main() {
    found = vec4(float(triangle + 1u), position, MARK);
}
