# SPDX-License-Identifier: Apache-2.0
"""Reads a .glb back and tests its structure against glTF 2.0; knows nothing of the writer's internals."""

import json
import math
import struct
import zlib

COMPONENTS = {5123: ("H", 2), 5125: ("I", 4), 5126: ("f", 4)}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3}
ARRAY_BUFFER, ELEMENT_ARRAY_BUFFER = 34962, 34963
FLOAT = 5126
PNG_SIGNATURE = b"\x89PNG\r\n\x1a\n"

# A unit vector stored as float32 is off by about 1e-7; ten times that.
UNIT_TOLERANCE = 1e-6


class Fault(Exception):
    """What is wrong with a file, with its place in the document."""


def require(condition, place, problem):
    if not condition:
        raise Fault(f"{place}: {problem}")


def split(data):
    """The JSON document and the binary chunk of a .glb."""
    require(len(data) >= 20, "header", "shorter than a glTF header and a chunk header")
    magic, version, length, text_length, text_kind = struct.unpack_from("<5I", data)
    require(magic == 0x46546C67 and version == 2, "header", "not binary glTF 2")
    require(length == len(data), "header", f"says {length} bytes, the file has {len(data)}")
    require(text_kind == 0x4E4F534A and text_length % 4 == 0, "chunk 0", "not JSON, or not padded to 4 bytes")
    document = json.loads(data[20:20 + text_length])
    binary_length, binary_kind = struct.unpack_from("<2I", data, 20 + text_length)
    require(binary_kind == 0x004E4942 and binary_length % 4 == 0, "chunk 1",
            "not binary, or not padded to 4 bytes")
    binary = data[28 + text_length:]
    # The chunk may be padded past the end of the buffer by up to 3 bytes (glTF 2.0, 4.4.3.3).
    padding = binary_length - document["buffers"][0]["byteLength"]
    require(len(binary) == binary_length and 0 <= padding < 4, "chunk 1", "lengths disagree")
    return document, binary


def read_accessor(document, binary, index):
    """The elements of an accessor as tuples, in file order."""
    place = f"accessors[{index}]"
    accessor = document["accessors"][index]
    view = document["bufferViews"][accessor["bufferView"]]
    code, size = COMPONENTS[accessor["componentType"]]
    width, count = WIDTHS[accessor["type"]], accessor["count"]
    stride = view.get("byteStride", width * size)
    offset = accessor.get("byteOffset", 0)
    require(count > 0, place, "is empty")
    require(offset % 4 == 0 and view["byteOffset"] % 4 == 0 and stride % size == 0, place, "is not aligned")
    end = offset + (count - 1) * stride + width * size
    require(end <= view["byteLength"], place, "leaves its buffer view")
    require(view["byteOffset"] + view["byteLength"] <= len(binary), place, "leaves the buffer")
    start = view["byteOffset"] + offset
    values = [struct.unpack_from(f"<{width}{code}", binary, start + i * stride) for i in range(count)]
    if "min" in accessor:
        for c in range(width):
            column = [value[c] for value in values]
            require(accessor["min"][c] == min(column) and accessor["max"][c] == max(column), place,
                    f"min or max of component {c} is not that of the data")
    return values


def check_primitive(document, binary, place, primitive):
    """Tests one primitive and returns its number of triangles."""
    attributes = primitive["attributes"]
    for name, accessor in attributes.items():
        view = document["bufferViews"][document["accessors"][accessor]["bufferView"]]
        require(view.get("target") == ARRAY_BUFFER, f"{place}.{name}",
                "its buffer view is not an ARRAY_BUFFER")
    require("min" in document["accessors"][attributes["POSITION"]], place, "POSITION lacks min and max")
    positions = read_accessor(document, binary, attributes["POSITION"])
    require(all(math.isfinite(c) for p in positions for c in p), place, "a position is not finite")
    if "NORMAL" in attributes:
        normals = read_accessor(document, binary, attributes["NORMAL"])
        require(len(normals) == len(positions), place, "normals and positions differ in number")
        require(all(abs(math.hypot(*n) - 1) < UNIT_TOLERANCE for n in normals), place,
                "a normal is not of unit length")
    if "TEXCOORD_0" in attributes:
        texcoords = read_accessor(document, binary, attributes["TEXCOORD_0"])
        require(len(texcoords) == len(positions), place, "texture coordinates and positions differ in number")
    view = document["bufferViews"][document["accessors"][primitive["indices"]]["bufferView"]]
    require(view.get("target") == ELEMENT_ARRAY_BUFFER, place,
            "the indices' buffer view is not an ELEMENT_ARRAY_BUFFER")
    indices = [i for (i,) in read_accessor(document, binary, primitive["indices"])]
    require(len(indices) % 3 == 0, place, "the number of indices is not a multiple of 3")
    require(max(indices) < len(positions), place, "an index is out of range")
    for a, b, c in zip(indices[0::3], indices[1::3], indices[2::3]):
        normal = cross(minus(positions[b], positions[a]), minus(positions[c], positions[a]))
        require(any(normal), place, f"triangle ({a}, {b}, {c}) has no area")
        if "NORMAL" in attributes:
            mean = [sum(normals[i][k] for i in (a, b, c)) for k in range(3)]
            require(sum(m * n for m, n in zip(mean, normal)) > 0, place,
                    f"triangle ({a}, {b}, {c}) is wound against its normals")
    material = document["materials"][primitive["material"]]
    textured = any(key.endswith("Texture") for key in (*material, *material["pbrMetallicRoughness"]))
    require(not textured or "TEXCOORD_0" in attributes, place, "is textured and has no texture coordinates")
    return len(indices) // 3


def minus(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def check_png(document, binary, index):
    """Tests signature, chunk checksums and that the picture decodes to its size."""
    place = f"images[{index}]"
    view = document["bufferViews"][document["images"][index]["bufferView"]]
    data = binary[view["byteOffset"]:view["byteOffset"] + view["byteLength"]]
    require(data[:8] == PNG_SIGNATURE, place, "not a PNG")
    position, chunks = 8, {}
    while position < len(data):
        (length,) = struct.unpack_from(">I", data, position)
        kind, body = data[position + 4:position + 8], data[position + 8:position + 8 + length]
        (checksum,) = struct.unpack_from(">I", data, position + 8 + length)
        require(zlib.crc32(kind + body) == checksum, place, f"checksum of chunk {kind!r} is wrong")
        chunks[kind] = body
        position += 12 + length
    width, height, depth, colour = struct.unpack_from(">2I2B", chunks[b"IHDR"])
    require((depth, colour) == (4, 3), place, "not four-bit indexed colour")
    row = 1 + (width + 1) // 2
    pixels = zlib.decompress(chunks[b"IDAT"])
    require(len(pixels) == row * height, place, "pixel data do not match its size")
    colours = len(chunks[b"PLTE"]) // 3
    used = max(max(byte >> 4, byte & 15) for y in range(height) for byte in pixels[y * row + 1:(y + 1) * row])
    require(used < colours, place, f"uses palette entry {used} of {colours}")


def check_nodes(document):
    """Every node is reached exactly once from the scene."""
    seen = []
    pending = list(document["scenes"][document["scene"]]["nodes"])
    while pending:
        index = pending.pop()
        require(index not in seen, f"nodes[{index}]", "has two parents")
        seen.append(index)
        pending += document["nodes"][index].get("children", [])
    require(len(seen) == len(document["nodes"]), "nodes", "some are not part of the scene")
    for index, node in enumerate(document["nodes"]):
        if "rotation" in node:
            require(abs(math.hypot(*node["rotation"]) - 1) < UNIT_TOLERANCE, f"nodes[{index}].rotation",
                    "is not of unit length")
    require(any("camera" in node for node in document["nodes"]), "nodes", "none holds a camera")


def summarise(data):
    """Tests the whole file. Returns its triangles (instances counted), nodes and materials.

    @raises Fault with the place and the problem.
    """
    document, binary = split(data)
    triangles = []
    for m, mesh in enumerate(document["meshes"]):
        place = f"meshes[{m}] '{mesh['name']}'"
        triangles.append(sum(check_primitive(document, binary, f"{place}.primitives[{p}]", primitive)
                             for p, primitive in enumerate(mesh["primitives"])))
    for index in range(len(document.get("images", []))):
        check_png(document, binary, index)
    check_nodes(document)
    used = sum(triangles[node["mesh"]] for node in document["nodes"] if "mesh" in node)
    return {"triangles": used, "nodes": len(document["nodes"]), "materials": len(document["materials"])}
