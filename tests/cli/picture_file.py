# SPDX-License-Identifier: Apache-2.0
"""Reads as much of PNG and OpenEXR files as the tests need, independently of the library that wrote them."""
import struct
import zlib

PNG_SIGNATURE = b"\x89PNG\r\n\x1a\n"
PNG_CHANNELS = {0: 1, 2: 3, 6: 4}  # by colour type
EXR_MAGIC = 20000630
EXR_FLOAT = 2
EXR_RGB = [("B", EXR_FLOAT), ("G", EXR_FLOAT), ("R", EXR_FLOAT)]
EXR_ZIP, EXR_ZIP_ROWS = 3, 16


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


def _exr_attributes(path, data):
    """({name: (type, bytes)}, offset behind them) of a single-part file."""
    if struct.unpack_from("<I", data)[0] != EXR_MAGIC:
        raise ValueError(f"{path}: not an OpenEXR file")
    offset, attributes = 8, {}
    while data[offset]:
        name, offset = _text(data, offset)
        kind, offset = _text(data, offset)
        size, = struct.unpack_from("<I", data, offset)
        attributes[name] = (kind, data[offset + 4:offset + 4 + size])
        offset += 4 + size
    return attributes, offset + 1


def _exr_size(attributes):
    left, top, right, bottom = struct.unpack("<4i", attributes["dataWindow"][1])
    return right - left + 1, bottom - top + 1


def _exr_channels(attributes):
    """(name, type of its values) of each channel, in the order of the file."""
    contents, at, channels = attributes["channels"][1], 0, []
    while contents[at]:
        name, at = _text(contents, at)
        channels.append((name, struct.unpack_from("<i", contents, at)[0]))
        at += 16
    return channels


def read_exr_header(path):
    """(width, height, channel names, texts by name) of a single-part scan line file."""
    attributes, _ = _exr_attributes(path, path.read_bytes())
    texts = {name: value.decode("utf-8") for name, (kind, value) in attributes.items() if kind == "string"}
    return *_exr_size(attributes), [name for name, _ in _exr_channels(attributes)], texts


def _unzip_exr(packed, size):
    """Bytes of a chunk: differences of neighbours were packed, those of even places first."""
    if len(packed) == size:
        return packed
    halves, value = bytearray(zlib.decompress(packed)), 128
    for i, difference in enumerate(halves):
        value = (value + difference - 128) & 0xff
        halves[i] = value
    whole, even = bytearray(size), (size + 1) // 2
    whole[0::2], whole[1::2] = halves[:even], halves[even:]
    return bytes(whole)


def read_exr(path):
    """(width, height, rows of (red, green, blue)) of a scan line file packed with ZIP, of R, G and B as float32."""
    data = path.read_bytes()
    attributes, offset = _exr_attributes(path, data)
    width, height = _exr_size(attributes)
    if attributes["compression"][1] != bytes([EXR_ZIP]) or _exr_channels(attributes) != EXR_RGB:
        raise ValueError(f"{path}: not R, G and B of float32, packed with ZIP")
    rows = []
    for first in range(0, height, EXR_ZIP_ROWS):
        chunk, = struct.unpack_from("<Q", data, offset + 8 * (first // EXR_ZIP_ROWS))
        _, length = struct.unpack_from("<ii", data, chunk)
        count = min(EXR_ZIP_ROWS, height - first)
        values = struct.unpack(f"<{3 * width * count}f",
                               _unzip_exr(data[chunk + 8:chunk + 8 + length], 12 * width * count))
        for at in range(0, len(values), 3 * width):
            blue, green, red = (values[at + i * width:at + (i + 1) * width] for i in range(3))
            rows.append(list(zip(red, green, blue)))
    return width, height, rows


def write_grey_png(path, width, height, level):
    """An 8-bit greyscale picture of one level, 0 to 255."""
    def chunk(kind, contents):
        checksum = zlib.crc32(kind + contents)
        return struct.pack(">I", len(contents)) + kind + contents + struct.pack(">I", checksum)

    rows = (b"\0" + bytes([level]) * width) * height
    path.write_bytes(PNG_SIGNATURE + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)) +
                     chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))
