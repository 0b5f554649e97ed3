// SPDX-License-Identifier: Apache-2.0
// The radiance of a textured light, in pieces: level by level, from 1 to 8 equal parts along each edge. Parts
// of a level with n along an edge go row by row, from the edge between the first two corners to the third;
// row j has n - j upright ones and, between them, those that are turned by half a turn.
#ifndef UTSURI_INTEROP_LIGHT_PIECES_H
#define UTSURI_INTEROP_LIGHT_PIECES_H
#include "interop/prelude.h"
INTEROP_BEGIN

INTEROP_CONSTANT LIGHT_PIECE_LEVELS = 4u;
INTEROP_CONSTANT LIGHT_PIECES = 85u;  ///< of all levels: 1 + 4 + 16 + 64

INTEROP_END
#endif
