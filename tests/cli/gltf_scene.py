# SPDX-License-Identifier: Apache-2.0
"""Tiny glTF files for tests: a document as a dictionary and one buffer, to be spoilt at will."""
import base64
import json
import struct

FLOAT, UNSIGNED_SHORT = 5126, 5123
GLB_MAGIC, JSON_CHUNK, BIN_CHUNK = 0x46546C67, 0x4E4F534A, 0x004E4942

QUAD = ((-1.0, -1.0, 0.0), (1.0, -1.0, 0.0), (1.0, 1.0, 0.0), (-1.0, 1.0, 0.0))
QUAD_INDICES = (0, 1, 2, 0, 2, 3)


def mesh_document(positions=QUAD, indices=QUAD_INDICES, camera=True, light=True):
    """A document and its buffer: one mesh, a camera 3 m in front of it, a point light beside the camera."""
    points = b"".join(struct.pack("<3f", *point) for point in positions)
    numbers = struct.pack(f"<{len(indices)}H", *indices)
    buffer = points + numbers
    document = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "name": "thing"}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [
            {"bufferView": 0, "componentType": FLOAT, "count": len(positions), "type": "VEC3"},
            {"bufferView": 1, "componentType": UNSIGNED_SHORT, "count": len(indices), "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": len(points)},
                        {"buffer": 0, "byteOffset": len(points), "byteLength": len(numbers)}],
        "buffers": [{"byteLength": len(buffer)}],
    }
    if camera:
        add_node(document, {"camera": 0, "translation": [0, 0, 3]})
        lens = {"yfov": 0.9, "znear": 0.1}
        document["cameras"] = [{"type": "perspective", "perspective": lens, "name": "front"}]
    if light:
        add_node(document, {"translation": [1, 1, 3], "extensions": {"KHR_lights_punctual": {"light": 0}}})
        document["extensionsUsed"] = ["KHR_lights_punctual"]
        document["extensions"] = {"KHR_lights_punctual": {"lights": [{"type": "point", "intensity": 100}]}}
    return document, buffer


def add_node(document, node):
    """Adds a node that is drawn; returns its index."""
    document["nodes"].append(node)
    document["scenes"][0]["nodes"].append(len(document["nodes"]) - 1)
    return len(document["nodes"]) - 1


def write_gltf(path, document, buffer=b""):
    """Writes a .gltf whose buffer is embedded."""
    if buffer:
        text = base64.b64encode(buffer).decode("ascii")
        document["buffers"][0]["uri"] = f"data:application/octet-stream;base64,{text}"
    path.write_text(json.dumps(document), encoding="utf-8")
    return path


def glb_bytes(document, buffer):
    text = json.dumps(document).encode("utf-8")
    text += b" " * (-len(text) % 4)
    buffer += b"\0" * (-len(buffer) % 4)
    chunks = struct.pack("<II", len(text), JSON_CHUNK) + text
    chunks += struct.pack("<II", len(buffer), BIN_CHUNK) + buffer
    return struct.pack("<III", GLB_MAGIC, 2, 12 + len(chunks)) + chunks
