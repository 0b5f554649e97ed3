# SPDX-License-Identifier: Apache-2.0
"""Small indexed-colour pictures and their PNG encoding, for textures."""

import struct
import zlib

# Five columns by seven rows; every letter differs from its own mirror image, so orientation can be read off.
LETTERS = {
    "F": ("#####", "#....", "#....", "####.", "#....", "#....", "#...."),
    "R": ("####.", "#...#", "#...#", "####.", "#.#..", "#..#.", "#...#"),
    "B": ("####.", "#...#", "#...#", "####.", "#...#", "#...#", "####."),
    "L": ("#....", "#....", "#....", "#....", "#....", "#....", "#####"),
}
LETTER_COLUMNS, LETTER_ROWS = 5, 7

MAX_PALETTE = 16        # four bits a pixel
MAX_STORED = 0xFFFF     # longest stored block of DEFLATE (RFC 1951, 3.2.4)


class Picture:
    """`palette` holds up to 16 sRGB triples of 0..255; row 0 is the top."""

    def __init__(self, width, height, palette):
        if len(palette) > MAX_PALETTE:
            raise ValueError(f"make picture: {len(palette)} colours; at most {MAX_PALETTE} fit four bits")
        self.width, self.height, self.palette = width, height, palette
        self.rows = [[0] * width for _ in range(height)]

    def paint(self, colour_at):
        """Sets every pixel to the palette index colour_at(x, y)."""
        self.rows = [[colour_at(x, y) for x in range(self.width)] for y in range(self.height)]

    def rectangle(self, x0, y0, x1, y1, colour):
        """Fills x0 <= x < x1, y0 <= y < y1; parts outside are left out."""
        for y in range(max(y0, 0), min(y1, self.height)):
            for x in range(max(x0, 0), min(x1, self.width)):
                self.rows[y][x] = colour

    def letter(self, letter, x0, y0, cell, colour):
        """Draws a letter of `cell` pixels a dot, its top left corner at (x0, y0)."""
        for row, dots in enumerate(LETTERS[letter]):
            for column, dot in enumerate(dots):
                if dot == "#":
                    x, y = x0 + column * cell, y0 + row * cell
                    self.rectangle(x, y, x + cell, y + cell, colour)

    def arrow_right(self, x0, y0, length, thickness, colour):
        """An arrow that points to +x; its box is `length` wide and 3 * `thickness` high."""
        head = thickness + thickness // 2
        middle = y0 + head
        self.rectangle(x0, middle - thickness // 2, x0 + length - head, middle + (thickness + 1) // 2, colour)
        for step in range(head):
            x = x0 + length - 1 - step
            self.rectangle(x, middle - step, x + 1, middle + step, colour)

    def encode(self):
        """A PNG file. Stored, not compressed: its bytes do not depend on the version of zlib."""
        scanlines = bytearray()
        for row in self.rows:
            padded = row + [0] * (len(row) % 2)
            scanlines.append(0)
            scanlines.extend(high << 4 | low for high, low in zip(padded[0::2], padded[1::2]))
        header = struct.pack(">2I5B", self.width, self.height, 4, 3, 0, 0, 0)
        colours = b"".join(bytes(colour) for colour in self.palette)
        return (b"\x89PNG\r\n\x1a\n" + _chunk(b"IHDR", header) + _chunk(b"PLTE", colours)
                + _chunk(b"IDAT", _stored_zlib(bytes(scanlines))) + _chunk(b"IEND", b""))


def shades(dark, light, count):
    """`count` sRGB colours evenly spaced from `dark` to `light`."""
    return [tuple(round(d + (l - d) * i / (count - 1)) for d, l in zip(dark, light)) for i in range(count)]


def _chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def _stored_zlib(data):
    out = bytearray(b"\x78\x01")
    for start in range(0, len(data), MAX_STORED):
        block = data[start:start + MAX_STORED]
        last = start + MAX_STORED >= len(data)
        out += struct.pack("<B2H", last, len(block), len(block) ^ MAX_STORED) + block
    return bytes(out + struct.pack(">I", zlib.adler32(data)))
