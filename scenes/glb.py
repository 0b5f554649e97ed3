# SPDX-License-Identifier: Apache-2.0
"""Writes binary glTF 2.0 files (.glb): meshes, materials, textures, cameras, punctual lights, nodes.

The same calls give the same bytes on every run: nothing depends on time, hashing order or a compression
library. Units are those of glTF (metres, cd/m2 for emission, cd for point and spot lights), but angles are
degrees in this Python API.
"""

import argparse
import json
import math
import pathlib
import struct

ARRAY_BUFFER = 34962
ELEMENT_ARRAY_BUFFER = 34963
FLOAT, UNSIGNED_SHORT, UNSIGNED_INT = 5126, 5123, 5125
NEAREST, LINEAR = 9728, 9729
CLAMP_TO_EDGE, REPEAT = 33071, 10497
GLB_MAGIC, JSON_CHUNK, BIN_CHUNK = 0x46546C67, 0x4E4F534A, 0x004E4942

# 65535 is the primitive restart value, which glTF forbids as an index.
MAX_SHORT_INDEX = 65534

# Digits kept in JSON: finer than float32 resolves, coarse enough to hide the last bit of the host's libm.
JSON_DIGITS = 9


def _numbers(values):
    rounded = [round(float(v), JSON_DIGITS) + 0.0 for v in values]
    return [int(v) if v == int(v) else v for v in rounded]


def look_rotation(direction, up=(0.0, 1.0, 0.0)):
    """Quaternion (x, y, z, w) that turns -Z to `direction` and +Y towards `up`: for cameras and spots."""
    back = _unit([-c for c in direction])
    right = _unit(_cross(up, back))
    true_up = _cross(back, right)
    m = [[right[i], true_up[i], back[i]] for i in range(3)]
    # Largest of the four candidates first keeps the division well conditioned.
    squares = [1 + m[0][0] - m[1][1] - m[2][2], 1 - m[0][0] + m[1][1] - m[2][2],
               1 - m[0][0] - m[1][1] + m[2][2], 1 + m[0][0] + m[1][1] + m[2][2]]
    best = max(range(4), key=lambda i: squares[i])
    s = 0.5 / math.sqrt(squares[best])
    rows = [[squares[0], m[0][1] + m[1][0], m[0][2] + m[2][0], m[2][1] - m[1][2]],
            [m[0][1] + m[1][0], squares[1], m[1][2] + m[2][1], m[0][2] - m[2][0]],
            [m[0][2] + m[2][0], m[1][2] + m[2][1], squares[2], m[1][0] - m[0][1]],
            [m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1], squares[3]]]
    return [s * c for c in rows[best]]


def turn_y(degrees):
    """Quaternion of a turn about +Y, counter-clockwise seen from above."""
    half = math.radians(degrees) / 2
    return [0.0, math.sin(half), 0.0, math.cos(half)]


def turn(axis, degrees):
    """Quaternion of a right-handed turn about `axis`."""
    half = math.radians(degrees) / 2
    return [*(math.sin(half) * c for c in _unit(axis)), math.cos(half)]


def after(a, b):
    """Quaternion of the turn `b`, followed by the turn `a`."""
    (ax, ay, az, aw), (bx, by, bz, bw) = a, b
    return [aw * bx + ax * bw + ay * bz - az * by, aw * by - ax * bz + ay * bw + az * bx,
            aw * bz + ax * by - ay * bx + az * bw, aw * bw - ax * bx - ay * by - az * bz]


def _cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def _unit(a):
    length = math.sqrt(sum(c * c for c in a))
    if length == 0.0:
        raise ValueError(f"normalise {a}: the vector has no length")
    return [c / length for c in a]


class _View:
    """A bufferView under construction; equal data are stored once."""

    def __init__(self, target=None, stride=None):
        self.target, self.stride = target, stride
        self.data = bytearray()
        self.accessors = {}


class Glb:
    """One scene. Every method that adds something returns its index."""

    def __init__(self, name, about):
        self._document = {
            "asset": {"version": "2.0", "generator": "Utsuri scenes/", "extras": {"about": about}},
            "scene": 0, "scenes": [{"name": name, "nodes": []}]}
        self._extensions = set()
        self._vectors = _View(ARRAY_BUFFER, 12)
        self._texcoords = _View(ARRAY_BUFFER, 8)
        self._indices = _View(ELEMENT_ARRAY_BUFFER)
        self._images = []
        self._textured = set()

    def texture(self, name, png, magnify=LINEAR, wrap=REPEAT):
        """`png` is a whole PNG file, sRGB coded."""
        sampler = {"magFilter": magnify, "minFilter": magnify, "wrapS": wrap, "wrapT": wrap}
        samplers = self._document.setdefault("samplers", [])
        if sampler not in samplers:
            samplers.append(sampler)
        self._images.append(png)
        source = self._add("images", {"name": name, "mimeType": "image/png"})
        return self._add("textures", {"name": name, "sampler": samplers.index(sampler), "source": source})

    def matte(self, name, colour, texture=None):
        """A pure Lambert surface: the specular lobe of glTF's dielectric is switched off."""
        return self.material(name, colour, metallic=0.0, roughness=1.0, specular=0.0, texture=texture)

    def metal(self, name, colour, roughness=0.0):
        """`colour` is the reflectance at normal incidence, linear Rec.709."""
        return self.material(name, colour, metallic=1.0, roughness=roughness)

    def emitter(self, name, luminance):
        """Emits `luminance` (cd/m2 per linear Rec.709 channel) from its front and reflects nothing."""
        return self.material(name, (0.0, 0.0, 0.0), metallic=0.0, roughness=1.0, specular=0.0,
                             emission=luminance)

    def material(self, name, colour, metallic, roughness, specular=None, ior=None, emission=None,
                 texture=None):
        surface = {"baseColorFactor": _numbers([*colour, 1.0]), "metallicFactor": metallic,
                   "roughnessFactor": roughness}
        if texture is not None:
            surface["baseColorTexture"] = {"index": texture}
        material = {"name": name, "pbrMetallicRoughness": surface}
        if emission is not None:
            # emissiveFactor ends at 1 (glTF 2.0, 5.19.6): the strength carries the rest.
            strength = max(emission)
            material["emissiveFactor"] = _numbers([c / strength for c in emission])
            self._extend(material, "KHR_materials_emissive_strength", {"emissiveStrength": strength})
        if specular is not None:
            self._extend(material, "KHR_materials_specular", {"specularFactor": specular})
        if ior is not None:
            self._extend(material, "KHR_materials_ior", {"ior": ior})
        index = self._add("materials", material)
        if texture is not None:
            self._textured.add(index)
        return index

    def finish(self, name, colour=None, roughness=0.5, metallic=0.0, look=None, glow=None, glow_texture=None,
               specular=None):
        """A material as exporters write them: double-sided, a dielectric by default, what is default left out.

        `look` is a pair of textures: base colour, and roughness with metallicness, which then decide alone.
        It emits `glow` (cd/m2), times `glow_texture`. Its meshes always have texture coordinates.
        """
        surface = {}
        if look is None:
            surface = {"baseColorFactor": _numbers([*(colour or (0.8, 0.8, 0.8)), 1.0]),
                       "metallicFactor": metallic, "roughnessFactor": roughness}
        else:
            if colour is not None:
                surface["baseColorFactor"] = _numbers([*colour, 1.0])
            surface["baseColorTexture"] = {"index": look[0]}
            if look[1] is not None:
                surface["metallicRoughnessTexture"] = {"index": look[1]}
            else:
                surface.update(metallicFactor=metallic, roughnessFactor=roughness)
        material = {"doubleSided": True, "name": name, "pbrMetallicRoughness": surface}
        if glow is not None:
            strength = max(glow)
            material["emissiveFactor"] = _numbers([c / strength for c in glow])
            self._extend(material, "KHR_materials_emissive_strength", {"emissiveStrength": strength})
        if glow_texture is not None:
            material["emissiveTexture"] = {"index": glow_texture}
        if specular is not None:
            self._extend(material, "KHR_materials_specular", {"specularFactor": specular})
        index = self._add("materials", material)
        self._textured.add(index)
        return index

    def mesh(self, name, parts, normals=True):
        """`parts` is a list of (material, Patch); parts of one material become one primitive.

        Without `normals` the attribute is left out, which in glTF means flat shading.
        """
        patches = {}
        for material, patch in parts:
            patches.setdefault(material, []).append(patch)
        primitives = [self._primitive(name, material, group, normals) for material, group in patches.items()]
        return self._add("meshes", {"name": name, "primitives": primitives})

    def camera(self, name, vertical_fov, aspect, near=0.01):
        """`vertical_fov` in degrees. No far plane: the projection is infinite."""
        lens = {"yfov": round(math.radians(vertical_fov), JSON_DIGITS), "aspectRatio": aspect, "znear": near}
        return self._add("cameras", {"name": name, "type": "perspective", "perspective": lens})

    def point_light(self, name, colour, candela):
        return self._light({"name": name, "type": "point", "color": _numbers(colour), "intensity": candela})

    def spot_light(self, name, colour, candela, inner, outer):
        """Half angles of the cones in degrees."""
        cone = {"innerConeAngle": round(math.radians(inner), JSON_DIGITS),
                "outerConeAngle": round(math.radians(outer), JSON_DIGITS)}
        return self._light({"name": name, "type": "spot", "color": _numbers(colour), "intensity": candela,
                            "spot": cone})

    def node(self, name, parent=None, mesh=None, camera=None, light=None, at=None, rotation=None, scale=None):
        """`at` in metres of the parent, `rotation` a quaternion (x, y, z, w), `scale` three factors."""
        node = {"name": name}
        for key, value in (("mesh", mesh), ("camera", camera)):
            if value is not None:
                node[key] = value
        for key, value in (("translation", at), ("rotation", rotation), ("scale", scale)):
            if value is not None:
                node[key] = _numbers(value)
        if light is not None:
            self._extend(node, "KHR_lights_punctual", {"light": light})
        index = self._add("nodes", node)
        siblings = (self._document["scenes"][0]["nodes"] if parent is None
                    else self._document["nodes"][parent].setdefault("children", []))
        siblings.append(index)
        return index

    def encode(self):
        """The bytes of the .glb file."""
        document, binary = self._layout()
        if self._extensions:
            document["extensionsUsed"] = sorted(self._extensions)
        text = json.dumps(document, separators=(",", ":")).encode("ascii")
        text += b" " * (-len(text) % 4)
        binary += b"\0" * (-len(binary) % 4)
        chunks = (struct.pack("<2I", len(text), JSON_CHUNK) + text
                  + struct.pack("<2I", len(binary), BIN_CHUNK) + bytes(binary))
        return struct.pack("<3I", GLB_MAGIC, 2, 12 + len(chunks)) + chunks

    def _layout(self):
        """Places the buffer views one after another and resolves the accessors."""
        document = dict(self._document)
        binary = bytearray()
        views = []

        def place(data, **extra):
            binary.extend(b"\0" * (-len(binary) % 4))
            views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": len(data), **extra})
            binary.extend(data)
            return len(views) - 1

        accessors = [dict(accessor) for accessor in document.get("accessors", [])]
        for view in (self._vectors, self._texcoords, self._indices):
            if view.data:
                stride = {"byteStride": view.stride} if view.stride else {}
                index = place(view.data, target=view.target, **stride)
                for accessor in view.accessors.values():
                    accessors[accessor] = {"bufferView": index, **accessors[accessor]}
        document["accessors"] = accessors
        if self._images:
            document["images"] = [{**image, "bufferView": place(png)}
                                  for image, png in zip(document["images"], self._images)]
        document["bufferViews"] = views
        document["buffers"] = [{"byteLength": len(binary)}]
        return document, binary

    def _primitive(self, mesh_name, material, patches, normals):
        positions, normal_values, texcoords, indices = [], [], [], []
        first = 0
        for patch in patches:
            for p, n in zip(patch.positions, patch.normals):
                positions.extend(p)
                normal_values.extend(n)
            if material in self._textured:
                if None in patch.texcoords:
                    raise ValueError(f"write mesh '{mesh_name}': its material is textured but a part has no "
                                     "texture coordinates; give every part of that material some")
                for uv in patch.texcoords:
                    texcoords.extend(uv)
            indices.extend(first + i for triangle in patch.triangles for i in triangle)
            first += len(patch.positions)
        if not indices:
            raise ValueError(f"write mesh '{mesh_name}': no triangles; a mesh needs at least one")
        attributes = {"POSITION": self._floats(self._vectors, positions, "VEC3", with_range=True)}
        if normals:
            attributes["NORMAL"] = self._floats(self._vectors, normal_values, "VEC3")
        if texcoords:
            attributes["TEXCOORD_0"] = self._floats(self._texcoords, texcoords, "VEC2")
        return {"attributes": attributes, "indices": self._index_accessor(indices), "material": material}

    def _floats(self, view, values, shape, with_range=False):
        width = {"VEC2": 2, "VEC3": 3}[shape]
        data = struct.pack(f"<{len(values)}f", *values)
        accessor = {"componentType": FLOAT, "count": len(values) // width, "type": shape}
        if with_range:
            stored = struct.unpack(f"<{len(values)}f", data)
            accessor["min"] = [min(stored[c::width]) for c in range(width)]
            accessor["max"] = [max(stored[c::width]) for c in range(width)]
        return self._accessor(view, data, accessor)

    def _index_accessor(self, indices):
        short = max(indices) <= MAX_SHORT_INDEX
        data = struct.pack(f"<{len(indices)}{'H' if short else 'I'}", *indices)
        kind = UNSIGNED_SHORT if short else UNSIGNED_INT
        accessor = {"componentType": kind, "count": len(indices), "type": "SCALAR"}
        return self._accessor(self._indices, data, accessor)

    def _accessor(self, view, data, accessor):
        # The range is part of the key: positions carry it, normals of the same bytes do not.
        key = (data, accessor["componentType"], "min" in accessor)
        if key not in view.accessors:
            view.data.extend(b"\0" * (-len(view.data) % 4))
            view.accessors[key] = self._add("accessors", {"byteOffset": len(view.data), **accessor})
            view.data.extend(data)
        return view.accessors[key]

    def _light(self, light):
        root = self._document.setdefault("extensions", {})
        lights = root.setdefault("KHR_lights_punctual", {"lights": []})["lights"]
        lights.append(light)
        self._extensions.add("KHR_lights_punctual")
        return len(lights) - 1

    def _extend(self, owner, name, value):
        owner.setdefault("extensions", {})[name] = value
        self._extensions.add(name)

    def _add(self, key, value):
        items = self._document.setdefault(key, [])
        items.append(value)
        return len(items) - 1


def generator_main(build, default_out):
    """Command line of a generator: writes build() to --out."""
    parser = argparse.ArgumentParser(description="Writes the scene of this folder as binary glTF.")
    parser.add_argument("--out", type=pathlib.Path, default=default_out,
                        help="file to write (default: %(default)s)")
    arguments = parser.parse_args()
    arguments.out.write_bytes(build().encode())
