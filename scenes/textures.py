# SPDX-License-Identifier: Apache-2.0
"""Pictures of surfaces that several scenes show. `draw` returns random numbers in [0, 1)."""

import math

import png


def carpet(draw):
    """Two by two tiles of 0.5 m, pile turned a quarter from tile to tile."""
    size, tile = 128, 64
    picture = png.Picture(size, size, png.shades((96, 101, 110), (150, 154, 160), 12))

    def colour_at(x, y):
        along = x if (x // tile + y // tile) % 2 else y
        seam = x % tile == 0 or y % tile == 0
        return max(0, min(11, int(3 + 2 * (along // 2 % 2) + 5 * draw()) - (4 if seam else 0)))

    picture.paint(colour_at)
    return picture.encode()


def wood(draw):
    """Grain along u; repeats without a seam because every wave has a whole number of periods."""
    width, height = 128, 64
    picture = png.Picture(width, height, png.shades((134, 88, 50), (196, 146, 94), 16))
    fibre = [draw() for _ in range(height)]

    def colour_at(x, y):
        u, v = math.tau * x / width, math.tau * y / height
        warp = 1.2 * math.sin(u) + 0.5 * math.sin(2 * u + v)
        rings = 0.5 + 0.5 * math.sin(5 * v + warp)
        return min(15, int(2 + 7 * rings + 4 * fibre[y] + 2.5 * draw()))

    picture.paint(colour_at)
    return picture.encode()


def landscape():
    """Four ridges in mist under an evening sky."""
    width, height = 144, 96
    sky = png.shades((92, 132, 168), (246, 206, 158), 11)
    ridges = [(176, 160, 158), (128, 130, 142), (84, 98, 116), (46, 62, 78), (255, 238, 196)]
    picture = png.Picture(width, height, sky + ridges)

    def colour_at(x, y):
        for ridge in (3, 2, 1, 0):
            base = 50 + 11 * ridge
            crest = base + (9 - ridge) * math.sin(0.045 * (ridge + 1) * x + 1.9 * ridge) + 3 * math.sin(
                0.17 * x + 2.3 * ridge)
            if y > crest:
                return len(sky) + ridge
        if (x - 98) ** 2 + (y - 34) ** 2 < 64:
            return len(sky) + 4
        return min(10, y // 5)

    picture.paint(colour_at)
    return picture.encode()
