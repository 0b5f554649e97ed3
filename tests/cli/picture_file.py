# SPDX-License-Identifier: Apache-2.0
"""Reads as much of PNG and OpenEXR files as the tests need, independently of the library that wrote them."""
import struct
import zlib

PNG_SIGNATURE = b"\x89PNG\r\n\x1a\n"
PNG_CHANNELS = {0: 1, 2: 3, 6: 4}  # by colour type
EXR_MAGIC = 20000630


def read_png(path):
    """(width, height, rows as bytes with their filter bytes) of an 8-bit PNG whose checksums all hold."""
    data = path.read_bytes()
    if not data.startswith(PNG_SIGNATURE):
        raise ValueError(f"{path}: not a PNG file")
    offset, header, packed, ended = len(PNG_SIGNATURE), None, b"", False
    while offset < len(data):
        length, kind = struct.unpack_from(">I4s", data, offset)
        contents = data[offset + 8:offset + 8 + length]
        checksum, = struct.unpack_from(">I", data, offset + 8 + length)
        if zlib.crc32(kind + contents) != checksum:
            raise ValueError(f"{path}: checksum of {kind}")
        if kind == b"IHDR":
            header = struct.unpack(">IIBBBBB", contents)
        packed += contents if kind == b"IDAT" else b""
        ended = kind == b"IEND"
        offset += 12 + length
    if header is None or not ended:
        raise ValueError(f"{path}: truncated")
    width, height, depth, colour = header[:4]
    rows = zlib.decompress(packed)
    if depth != 8 or len(rows) != height * (1 + width * PNG_CHANNELS[colour]):
        raise ValueError(f"{path}: {width} x {height} pixels of type {colour} in {len(rows)} bytes")
    return width, height, rows


def _text(data, offset):
    end = data.index(b"\0", offset)
    return data[offset:end].decode("utf-8"), end + 1


def read_exr_header(path):
    """(width, height, channel names, texts by name) of a single-part scan line file."""
    data = path.read_bytes()
    if struct.unpack_from("<I", data)[0] != EXR_MAGIC:
        raise ValueError(f"{path}: not an OpenEXR file")
    offset, attributes = 8, {}
    while data[offset]:
        name, offset = _text(data, offset)
        kind, offset = _text(data, offset)
        size, = struct.unpack_from("<I", data, offset)
        attributes[name] = (kind, data[offset + 4:offset + 4 + size])
        offset += 4 + size
    left, top, right, bottom = struct.unpack("<4i", attributes["dataWindow"][1])
    contents, at, channels = attributes["channels"][1], 0, []
    while contents[at]:
        name, at = _text(contents, at)
        channels.append(name)
        at += 16
    texts = {name: value.decode("utf-8") for name, (kind, value) in attributes.items() if kind == "string"}
    return right - left + 1, bottom - top + 1, channels, texts


def write_grey_png(path, width, height, level):
    """An 8-bit greyscale picture of one level, 0 to 255."""
    def chunk(kind, contents):
        checksum = zlib.crc32(kind + contents)
        return struct.pack(">I", len(contents)) + kind + contents + struct.pack(">I", checksum)

    rows = (b"\0" + bytes([level]) * width) * height
    path.write_bytes(PNG_SIGNATURE + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)) +
                     chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))
