# SPDX-License-Identifier: Apache-2.0
"""Looks of surfaces whose textures carry roughness and metal, and pictures that screens and lamps show.

A look is a pair of PNGs, base colour and roughness with metallicness. `draw` returns random numbers in [0, 1).
"""

import math

import png


def look(width, height, kinds, kind_at):
    """`kinds` lists up to 16 (sRGB colour, roughness, metallicness); kind_at(x, y) is an index into it."""
    colour = png.Picture(width, height, [kind[0] for kind in kinds])
    colour.paint(kind_at)
    finish = png.Picture(width, height, [(255, round(255 * r), round(255 * m)) for _, r, m in kinds])
    finish.rows = colour.rows
    return colour.encode(), finish.encode()


def scale(dark, light, smooth, rough, count, metallic=0.0):
    """Kinds from `dark` to `light`; the lightest has the roughness `smooth`."""
    return [(colour, rough + (smooth - rough) * i / (count - 1), metallic)
            for i, colour in enumerate(png.shades(dark, light, count))]


def noise(draw, cells):
    """A smooth function of u and v with period 1 in both, in [0, 1]."""
    values = [[draw() for _ in range(cells)] for _ in range(cells)]

    def at(u, v):
        x, y = u * cells, v * cells
        i, j = math.floor(x), math.floor(y)
        s, t = ((f * f * (3 - 2 * f)) for f in (x - i, y - j))
        rows = [values[k % cells] for k in (j, j + 1)]
        a, b = (row[i % cells] * (1 - s) + row[(i + 1) % cells] * s for row in rows)
        return a * (1 - t) + b * t

    return at


def _pick(value, first, last):
    return max(first, min(last, first + int(value * (last - first + 1))))


def planks(draw, dark=(104, 68, 40), light=(188, 138, 92), smooth=0.10, rough=0.30):
    """Eight lacquered boards along u, four of them jointed at a time; worn where they are dark."""
    size, rows = 256, 8
    board = size // rows
    kinds = [((38, 26, 18), 0.8, 0.0), *scale(dark, light, smooth, rough, 15)]
    joints = [int(size * draw()) for _ in range(rows)]
    tones = [[0.55 * draw() for _ in range(2)] for _ in range(rows)]
    wear, warp = noise(draw, 8), noise(draw, 4)

    def kind_at(x, y):
        row = y // board
        place = (x - joints[row]) % size
        if y % board == 0 or place in (0, size // 2):
            return 0
        u, v = x / size, y / size
        grain = 0.5 + 0.5 * math.sin(math.tau * (24 * v + 2.2 * warp(u, v)) + 40 * tones[row][0])
        tone = tones[row][place // (size // 2)] + 0.2 * grain + 0.15 * wear(u, v) + 0.1 * draw()
        return _pick(tone, 1, 15)

    return look(size, size, kinds, kind_at)


def wood(draw, dark=(110, 70, 40), light=(182, 128, 82), smooth=0.35, rough=0.6):
    """A veneer, grain along u."""
    size = 128
    warp, spots = noise(draw, 4), noise(draw, 16)

    def kind_at(x, y):
        u, v = x / size, y / size
        rings = 0.5 + 0.5 * math.sin(math.tau * (13 * v + 1.1 * warp(u, v)))
        return _pick(0.3 * rings + 0.45 * spots(u, 4 * v) + 0.25 * draw(), 0, 15)

    return look(size, size, scale(dark, light, smooth, rough, 16), kind_at)


def tiles(draw, dark=(176, 186, 188), light=(222, 228, 226), grout=(120, 116, 108), smooth=0.12, count=4):
    """`count` by `count` glazed tiles of different tones, in rough grout."""
    size = 128
    tile = size // count
    tones = [[draw() for _ in range(count)] for _ in range(count)]
    kinds = [(grout, 0.8, 0.0), *scale(dark, light, smooth, smooth + 0.08, 12)]

    def kind_at(x, y):
        if x % tile < 2 or y % tile < 2:
            return 0
        return _pick(0.85 * tones[y // tile][x // tile] + 0.15 * draw(), 1, 12)

    return look(size, size, kinds, kind_at)


def fabric(draw, dark, light):
    """A plain weave; rough all over."""
    size = 64

    def kind_at(x, y):
        over = (x // 2 + y // 2) % 2
        thread = math.sin(math.pi * ((x if over else y) % 2 + 0.5) / 2)
        return _pick(0.35 * over + 0.3 * thread + 0.35 * draw(), 0, 11)

    return look(size, size, scale(dark, light, 0.82, 0.98, 12), kind_at)


def carpet_tiles(draw):
    """Two by two tiles, pile turned a quarter from tile to tile."""
    size, tile = 128, 64

    def kind_at(x, y):
        along = x if (x // tile + y // tile) % 2 else y
        seam = x % tile == 0 or y % tile == 0
        return _pick(0.2 * (along // 2 % 2) + 0.5 * draw() + 0.2 - (0.3 if seam else 0.0), 0, 11)

    return look(size, size, scale((96, 101, 110), (150, 154, 160), 0.9, 1.0, 12), kind_at)


def plaster(draw, dark=(196, 190, 178), light=(228, 224, 214)):
    size = 128
    broad, fine = noise(draw, 6), noise(draw, 24)

    def kind_at(x, y):
        u, v = x / size, y / size
        return _pick(0.5 * broad(u, v) + 0.35 * fine(u, v) + 0.15 * draw(), 0, 15)

    return look(size, size, scale(dark, light, 0.6, 0.9, 16), kind_at)


def worn_metal(draw, dark=(150, 148, 146), light=(214, 212, 208), smooth=0.12, rough=0.45):
    """Metal all over, scratched: a scratch is rougher than what is left of the polish."""
    size = 128
    broad = noise(draw, 5)
    depth = [[0.0] * size for _ in range(size)]
    for _ in range(70):
        x, y, angle = size * draw(), size * draw(), math.pi * (0.15 + 0.2 * draw())
        for step in range(int(10 + 50 * draw())):
            depth[int(y + step * math.sin(angle)) % size][int(x + step * math.cos(angle)) % size] = 0.5

    def kind_at(x, y):
        return _pick(0.9 - depth[y][x] - 0.35 * broad(x / size, y / size) + 0.1 * draw(), 0, 15)

    return look(size, size, scale(dark, light, smooth, rough, 16, 1.0), kind_at)


def brushed_metal(draw):
    """Fine lines along u; roughness between 0.2 and 0.4."""
    size = 128
    lines = [draw() for _ in range(size)]

    def kind_at(x, y):
        return _pick(0.7 * lines[y] + 0.3 * draw(), 0, 15)

    return look(size, size, scale((166, 166, 170), (206, 206, 208), 0.20, 0.40, 16, 1.0), kind_at)


def rusted(draw):
    """Bare metal, rust (no metal) that eats into it, and paint that is left: one material, three by texture."""
    size = 128
    kinds = [*scale((186, 184, 180), (216, 214, 210), 0.15, 0.35, 6, 1.0),
             *scale((74, 34, 16), (146, 78, 38), 0.85, 0.95, 5), *scale((28, 84, 92), (44, 112, 118), 0.3, 0.45, 5)]
    broad, fine = noise(draw, 5), noise(draw, 20)

    def kind_at(x, y):
        u, v = x / size, y / size
        state = 0.7 * broad(u, v) + 0.3 * fine(u, v)
        if state > 0.56:
            return _pick(draw(), 11, 15)
        return _pick(draw(), 6, 10) if state > 0.44 else _pick(draw(), 0, 5)

    return look(size, size, kinds, kind_at)


def stone(draw, dark=(58, 60, 64), light=(150, 150, 148)):
    """Polished terrazzo: chips in a ground that is a little duller."""
    size = 128
    fine, chips = noise(draw, 32), noise(draw, 18)
    kinds = [*scale(dark, tuple((d + g) // 2 for d, g in zip(dark, light)), 0.22, 0.30, 8),
             *scale(tuple((d + 2 * g) // 3 for d, g in zip(dark, light)), light, 0.10, 0.14, 8)]

    def kind_at(x, y):
        u, v = x / size, y / size
        return _pick(fine(u, v), 8, 15) if chips(u, v) > 0.62 else _pick(0.6 * fine(u, v) + 0.4 * draw(), 0, 7)

    return look(size, size, kinds, kind_at)


def carpet(draw, dark, light):
    """A rug with a border and a lozenge pattern; two tones, rough all over."""
    size = 128
    kinds = [*scale(dark, tuple((2 * a + b) // 3 for a, b in zip(dark, light)), 0.9, 1.0, 6),
             *scale(tuple((a + 2 * b) // 3 for a, b in zip(dark, light)), light, 0.9, 1.0, 6)]

    def kind_at(x, y):
        edge = min(x, y, size - 1 - x, size - 1 - y)
        lozenge = (abs((x % 32) - 15.5) + abs((y % 32) - 15.5)) % 16 < 6
        bright = 5 < edge < 9 or (edge > 13 and lozenge)
        return _pick(draw(), 6, 11) if bright else _pick(draw(), 0, 5)

    return look(size, size, kinds, kind_at)
