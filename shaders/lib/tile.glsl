// SPDX-License-Identifier: Apache-2.0
// Which pixels work side by side.
#ifndef UTSURI_LIB_TILE
#define UTSURI_LIB_TILE

#include "interop/frame.h"

/// Position in a tile of the invocation: neighbours in a subgroup form compact blocks (4x2 of 8, 8x4 of 32), because
/// rays of neighbouring pixels take similar ways.
uvec2 position_in_tile(uint invocation) {
    return uvec2((invocation & 3u) | ((invocation >> 1) & 4u), ((invocation >> 2) & 1u) | ((invocation >> 3) & 6u));
}

/// Pixel of an invocation, of those in a row of tiles after the other.
/// @param tile number of the invocation's tile
/// @param width of the picture
uvec2 pixel_in_tiles(uint tile, uint width, uint invocation) {
    uint tiles_per_row = (width + TILE_SIZE - 1u) / TILE_SIZE;
    return uvec2(tile % tiles_per_row, tile / tiles_per_row) * TILE_SIZE + position_in_tile(invocation);
}

#endif
