#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Scene files that cannot be drawn: each is exit code 3, with the file, the place in it and what is right."""
import unittest

import gltf_scene
from cli_case import INPUT, SMALL, CliCase


class BadFiles(CliCase):
    def refuse(self, path, *words):
        """Every subcommand that takes a scene refuses it in the same words."""
        name = path.name
        self.fail_with(INPUT, (name, *words), "info", path)
        self.fail_with(INPUT, (name, *words), "render", path, "-o", "picture.exr", *SMALL)
        self.fail_with(INPUT, (name, *words), "compare", path, "-o", "folder", *SMALL)

    def refuse_document(self, document, buffer, *words):
        self.refuse(gltf_scene.write_gltf(self.scratch / "bad.gltf", document, buffer), *words)

    def test_missing_file(self):
        self.refuse(self.scratch / "nowhere.glb", "no such file")

    def test_folder(self):
        folder = self.scratch / "folder.glb"
        folder.mkdir()
        self.refuse(folder, "is a folder, expected a file")

    def test_empty_file(self):
        path = self.scratch / "empty.glb"
        path.write_bytes(b"")
        self.refuse(path, "the file is empty", "must be glTF 2.0")

    def test_truncated_glb(self):
        whole = gltf_scene.glb_bytes(*gltf_scene.mesh_document())
        path = self.scratch / "cut.glb"
        for length in (3, 11, 12, 19, 200, len(whole) - 1):
            with self.subTest(length=length):
                path.write_bytes(whole[:length])
                words = ("not a binary glTF file", "must be") if length < 4 else ("truncated", f"{length}")
                self.refuse(path, *words)

    def test_file_of_another_kind(self):
        path = self.scratch / "picture.glb"
        path.write_bytes(b"\x89PNG\r\n\x1a\n" + bytes(64))
        self.refuse(path, "not a binary glTF file", 'must be "glTF"')

    def test_json_syntax_error(self):
        path = self.scratch / "syntax.gltf"
        path.write_text('{"asset":\n {"version": "2.0",}}', encoding="utf-8")
        self.refuse(path, "not valid JSON", "line 2, column 20", "expected string literal")

    def test_wrong_version(self):
        document, buffer = gltf_scene.mesh_document()
        document["asset"]["version"] = "1.0"
        self.refuse_document(document, buffer, "asset.version", '"1.0"', "must be 2.x")

    def test_accessor_past_its_buffer(self):
        document, buffer = gltf_scene.mesh_document()
        document["accessors"][0]["count"] = 5
        self.refuse_document(document, buffer, "accessors[0]", "5 elements", "must end within the 48 bytes")

    def test_buffer_view_past_its_buffer(self):
        document, buffer = gltf_scene.mesh_document()
        document["bufferViews"][1]["byteLength"] = 1000
        self.refuse_document(document, buffer, "bufferViews[1]", "must")

    def test_buffer_shorter_than_declared(self):
        document, buffer = gltf_scene.mesh_document()
        self.refuse_document(document, buffer[:-8], "buffers[0]", str(len(buffer)), str(len(buffer) - 8))

    def test_index_out_of_range(self):
        document, buffer = gltf_scene.mesh_document(indices=(0, 1, 4))
        self.refuse_document(document, buffer, "meshes[0].primitives[0].indices", "index 2 is 4",
                             "must be below the number of vertices, 4")

    def test_reference_to_nothing(self):
        document, buffer = gltf_scene.mesh_document()
        document["nodes"][0]["mesh"] = 7
        self.refuse_document(document, buffer, "nodes[0].mesh", "7", "must be")

    def test_node_cycle(self):
        document, buffer = gltf_scene.mesh_document()
        first = len(document["nodes"])
        document["nodes"] += [{"children": [first + 1]}, {"children": [first]}]
        self.refuse_document(document, buffer, f"nodes[{first}]", "cycle", "nodes must form trees")

    def test_node_with_two_parents(self):
        document, buffer = gltf_scene.mesh_document()
        shared = len(document["nodes"])
        document["nodes"].append({})
        gltf_scene.add_node(document, {"children": [shared]})
        second = gltf_scene.add_node(document, {"children": [shared]})
        self.refuse_document(document, buffer, f"nodes[{second}].children[0]", "must have one parent")

    def test_missing_texture_file(self):
        document, buffer = gltf_scene.mesh_document()
        document["images"] = [{"uri": "lost.png"}]
        document["textures"] = [{"source": 0}]
        document["materials"] = [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}]
        document["meshes"][0]["primitives"][0]["material"] = 0
        document["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] = 2
        texcoords = {"bufferView": 0, "componentType": gltf_scene.FLOAT, "count": 4, "type": "VEC2"}
        document["accessors"].append(texcoords)
        self.refuse_document(document, buffer, "images[0].uri", "lost.png", "must be a readable file")

    def test_missing_buffer_file(self):
        document, _ = gltf_scene.mesh_document()
        document["buffers"][0]["uri"] = "lost.bin"
        self.refuse_document(document, b"", "buffers[0].uri", "lost.bin", "must be a readable file")

    def test_required_extension(self):
        document, buffer = gltf_scene.mesh_document()
        document["extensionsUsed"].append("KHR_draco_mesh_compression")
        document["extensionsRequired"] = ["KHR_draco_mesh_compression"]
        self.refuse_document(document, buffer, "extensionsRequired[0]", "KHR_draco_mesh_compression",
                             "supported are KHR_lights_punctual")


if __name__ == "__main__":
    unittest.main()
