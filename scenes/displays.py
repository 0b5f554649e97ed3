# SPDX-License-Identifier: Apache-2.0
"""Pictures that hang, and pictures that shine: screens, a window, a clock. Each returns a PNG."""

import math

import png


def dashboard(draw):
    """A screen full of charts: bars, a line, a ring and text."""
    width, height = 160, 96
    panel, text, grid, *tones = range(1, 9)      # 0 is the ground
    picture = png.Picture(width, height, [(14, 18, 28), (26, 32, 46), (210, 216, 226), (54, 62, 80),
                                          (64, 156, 240), (246, 156, 62), (92, 206, 132), (226, 84, 96),
                                          (176, 132, 236)])
    picture.rectangle(0, 0, width, 9, panel)
    for x in range(4, 60, 9):
        picture.rectangle(x, 3, x + 3 + int(4 * draw()), 6, text)
    for x0, y0, x1, y1 in ((4, 13, 100, 55), (104, 13, 156, 55), (4, 59, 64, 92), (68, 59, 156, 92)):
        picture.rectangle(x0, y0, x1, y1, panel)
        picture.rectangle(x0 + 3, y0 + 3, x0 + 20, y0 + 5, text)
    for y in range(22, 54, 8):
        picture.rectangle(8, y, 96, y + 1, grid)
    for k, phase in enumerate((0.0, 1.7)):
        for x in range(8, 96):
            y = int(36 + 9 * math.sin(0.09 * x + phase) + 4 * math.sin(0.31 * x + 2 * phase))
            picture.rectangle(x, y, x + 1, y + 2, tones[k])
    for y in range(20, 54):
        for x in range(110, 150):
            dx, dy = x - 130, y - 36
            if 10 <= math.hypot(dx, dy) <= 16:
                share = math.atan2(dy, dx) / math.tau % 1.0
                picture.rectangle(x, y, x + 1, y + 1, tones[0 if share < 0.45 else 1 if share < 0.7 else 2])
    for k in range(8):
        tall = int(6 + 18 * draw())
        picture.rectangle(9 + 7 * k, 90 - tall, 13 + 7 * k, 90, tones[k % 2 * 2])
    for row in range(5):
        picture.rectangle(72, 66 + 5 * row, 72 + int(30 + 44 * draw()), 68 + 5 * row, text if row % 2 else tones[3])
    return picture.encode()


def text_page(draw):
    """A screen that shows a document in black on white, with coloured headings."""
    width, height = 128, 80
    picture = png.Picture(width, height, [(236, 238, 240), (60, 64, 72), (38, 92, 190), (200, 204, 210),
                                          (250, 250, 250)])
    picture.rectangle(0, 0, width, 7, 3)
    picture.rectangle(24, 10, 104, height, 4)
    for row in range(15):
        y = 14 + 4 * row
        if row % 6 == 0:
            picture.rectangle(30, y, 62 + int(16 * draw()), y + 2, 2)
        else:
            picture.rectangle(30, y, 84 + int(14 * draw()), y + 1, 1)
    return picture.encode()


def sky():
    """What a window shows: evening sky over a low skyline; it shines."""
    width, height = 96, 96
    picture = png.Picture(width, height, [*png.shades((150, 188, 236), (255, 236, 206), 12), (96, 102, 118),
                                          (70, 76, 90), (255, 214, 140), (52, 58, 66)])

    def colour_at(x, y):
        block = x // 9
        crest = 72 + (block * 7919 % 13) - (6 if block % 4 == 1 else 0)
        if y < crest:
            return min(11, int(12 * y / 84))
        lit = x % 9 in (2, 5) and (y - crest) % 5 == 2 and (x * 31 + y * 17) % 3 == 0
        return 14 if lit else 12 + block % 2

    picture.paint(colour_at)
    return picture.encode()


def clock_face():
    """Twelve marks around a white dial."""
    size = 128
    picture = png.Picture(size, size, [(240, 238, 230), (30, 30, 32), (150, 148, 142)])

    def colour_at(x, y):
        dx, dy = x - 63.5, y - 63.5
        radius, angle = math.hypot(dx, dy), math.degrees(math.atan2(dy, dx))
        off = abs((angle + 15) % 30 - 15) / 180 * math.pi * radius
        quarter = abs((angle + 45) % 90 - 45) < 10
        if (48 if quarter else 52) < radius < 59 and off < (2.6 if quarter else 1.4):
            return 1
        return 2 if 60.5 < radius < 62 else 0

    picture.paint(colour_at)
    return picture.encode()


def abstract(draw):
    """A painting of overlapping discs."""
    size = 96
    discs = [(size * draw(), size * draw(), 8 + 22 * draw()) for _ in range(9)]
    picture = png.Picture(size, size, [(230, 222, 204), (196, 74, 48), (232, 168, 60), (40, 92, 110), (24, 40, 62),
                                       (120, 146, 128), (214, 200, 176), (150, 54, 62), (84, 120, 150), (60, 56, 52)])

    def colour_at(x, y):
        inside = [k for k, (cx, cy, r) in enumerate(discs) if math.hypot(x - cx, y - cy) < r]
        return sum(k + 1 for k in inside) % 9 + 1 if inside else 0

    picture.paint(colour_at)
    return picture.encode()


def book_cover(tone, gold=(206, 172, 90)):
    """Cloth with two bands."""
    dark = tuple(c * 3 // 4 for c in tone)
    picture = png.Picture(32, 32, [tone, dark, gold])
    picture.paint(lambda x, y: 2 if y in (5, 26) else (x * 7 + y * 13) % 5 == 0)
    return picture.encode()
