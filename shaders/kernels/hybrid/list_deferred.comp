// SPDX-License-Identifier: Apache-2.0
// Lists the pixels that left a reflection to rays, tile by tile, so that the kernel that follows them has no idle lanes. The
// order of the tiles changes no picture.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "interop/bindings.h"
#include "interop/raster.h"
#include "interop/workgroup.h"
#include "lib/tile.glsl"

layout(local_size_x = TILE_SIZE * TILE_SIZE) in;

layout(push_constant, scalar) uniform Push { DeferredPush push; };

layout(scalar, set = METHOD_SET, binding = BINDING_FRAME) uniform Frame { FrameInfo frame; };
layout(scalar, set = METHOD_SET, binding = BINDING_DEFERRED) readonly restrict buffer Reflections {
    DeferredReflection reflections[];
};
layout(scalar, set = METHOD_SET, binding = BINDING_DEFERRED_COUNT) restrict buffer Count { DeferredCount count; };
layout(scalar, set = METHOD_SET, binding = BINDING_DEFERRED_PIXELS) writeonly restrict buffer Pixels { uint pixels[]; };

shared uint listed;
shared uint first;

void main() {
    if (gl_LocalInvocationIndex == 0u) listed = 0u;
    barrier();
    uvec2 in_band = pixel_in_tiles(push.first_tile + gl_WorkGroupID.x, frame.width, gl_LocalInvocationID.x);
    uint pixel = in_band.y * frame.width + in_band.x;
    bool waits = in_band.x < frame.width && in_band.y < push.rows &&
                 (reflections[pixel].request & DEFERRED_KIND) != DEFERRED_NONE;
    uint place = waits ? atomicAdd(listed, 1u) : 0u;
    barrier();
    if (gl_LocalInvocationIndex == 0u && listed > 0u) {
        first = atomicAdd(count.pixels, listed);
        atomicMax(count.groups_x, (first + listed - 1u) / WORKGROUP_SIZE + 1u);
    }
    barrier();
    if (waits) pixels[first + place] = pixel;
}
