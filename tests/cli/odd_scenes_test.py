#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Scenes that lack something or hold triangles that cannot be drawn: they render, and the program says so."""
import math
import unittest

import gltf_scene
from cli_case import SMALL, CliCase

NAN, INFINITY = math.nan, math.inf


class OddScenes(CliCase):
    def write(self, document, buffer=b""):
        return gltf_scene.write_gltf(self.scratch / "odd.gltf", document, buffer)

    def render(self, path, *options):
        """(JSON, standard error) of a render whose samples are all finite."""
        picture, result = self.scratch / "picture.exr", self.scratch / "result.json"
        done = self.succeed("render", path, "-o", picture, *SMALL, "--json", result, *options)
        values = self.load(result)
        self.assertEqual(values["nonfinite"], 0)
        self.assertTrue(picture.is_file())
        return values, done.stderr

    def check(self, document, buffer, note, triangles):
        """`render` and `info` both tell `note`, and `triangles` of them are left."""
        path = self.write(document, buffer)
        _, told = self.render(path)
        self.assertIn(f"note: {note}\n", told)
        values = self.json_of("info", path)
        self.assertIn(note, values["notes"])
        self.assertEqual(values["triangles"], triangles)

    def test_vertices_that_are_not_finite(self):
        positions = gltf_scene.QUAD + ((NAN, 0.0, 0.0), (0.0, INFINITY, 0.0), (0.0, 0.0, -INFINITY))
        indices = gltf_scene.QUAD_INDICES + (0, 1, 4, 1, 2, 5, 2, 3, 6)
        self.check(*gltf_scene.mesh_document(positions, indices),
                   "meshes[0].primitives[0]: 3 triangles with a vertex that is not finite dropped", 2)

    def test_triangles_of_zero_area(self):
        positions = gltf_scene.QUAD + ((0.0, -1.0, 0.0),)
        indices = gltf_scene.QUAD_INDICES + (0, 0, 1, 0, 1, 4)  # a repeated corner, three corners on a line
        self.check(*gltf_scene.mesh_document(positions, indices),
                   "meshes[0].primitives[0]: 2 triangles of zero area dropped", 2)

    def test_only_triangles_that_cannot_be_drawn(self):
        self.check(*gltf_scene.mesh_document(indices=(0, 0, 0)),
                   "meshes[0].primitives[0]: 1 triangle of zero area dropped", 0)

    def test_without_camera(self):
        self.check(*gltf_scene.mesh_document(camera=False),
                   'no camera in the file: one that frames the whole scene, named "default"', 2)

    def test_without_light(self):
        self.check(*gltf_scene.mesh_document(light=False),
                   "no light in the file: lit by uniform surroundings of 1 cd/m2", 2)

    def test_empty_scene_shows_the_surroundings(self):
        for reflection in ("trace", "polygon-map", "sphere-map", "proxy-map", "distance-map", "planar", "hybrid"):
            with self.subTest(reflection=reflection):
                path = self.write({"asset": {"version": "2.0"}})
                _, told = self.render(path, "--reflection", reflection)
                self.assertIn("no triangle in the file: the scene is empty", told)
                # Every pixel is 1 cd/m2, so both pictures are white at exposure 0.
                self.succeed("render", path, "-o", "black.png", *SMALL, "--exposure", "-60")
                self.succeed("render", path, "-o", "white.png", *SMALL, "--exposure", "0")
                metrics = self.json_of("diff", "black.png", "white.png")["metrics"]
                self.assertEqual(metrics["max"], 1.0)
                self.assertEqual(metrics["mse"], 1.0)

    def test_ignored_extension_is_named(self):
        document, buffer = gltf_scene.mesh_document()
        document["materials"] = [{"extensions": {"KHR_materials_clearcoat": {"clearcoatFactor": 1.0}}}]
        document["extensionsUsed"].append("KHR_materials_clearcoat")
        document["meshes"][0]["primitives"][0]["material"] = 0
        _, told = self.render(self.write(document, buffer))
        self.assertIn("KHR_materials_clearcoat is not supported (clear coats are not drawn)", told)
        self.assertIn("materials[0]", told)


if __name__ == "__main__":
    unittest.main()
