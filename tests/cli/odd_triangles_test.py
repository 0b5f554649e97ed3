#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Triangles that cannot be drawn: the program says so, and every method renders what is left."""
import math
import unittest

import gltf_scene
import plate
from odd_case import MIRROR, OddCase, with_material

NAN, INFINITY = math.nan, math.inf


class OddTriangles(OddCase):
    def check(self, positions, indices, note):
        """The square alone is left: as lit metal, and as a mirror that shows a uniform environment."""
        path = self.write(*gltf_scene.mesh_document(positions, indices))
        pictures, told = self.pictures(path)
        self.check_notes(path, told, note, 2)
        for method, rows in pictures.items():
            self.assert_within(rows, lambda *pixel: plate.lit_bounds(plate.footprint(*pixel)), method)
        document, buffer = gltf_scene.mesh_document(positions, indices, light=False)
        pictures, told = self.pictures(self.write(with_material(document, MIRROR), buffer))
        self.assertIn(f"note: {note}\n", told)
        self.assert_uniform(pictures, 1.0)

    def test_vertices_that_are_not_finite(self):
        positions = gltf_scene.QUAD + ((NAN, 0.0, 0.0), (0.0, INFINITY, 0.0), (0.0, 0.0, -INFINITY))
        indices = gltf_scene.QUAD_INDICES + (0, 1, 4, 1, 2, 5, 2, 3, 6)
        self.check(positions, indices,
                   "meshes[0].primitives[0]: 3 triangles with a vertex that is not finite dropped")

    def test_triangles_of_zero_area(self):
        positions = gltf_scene.QUAD + ((0.0, -1.0, 0.0),)
        indices = gltf_scene.QUAD_INDICES + (0, 0, 1, 0, 1, 4)  # a repeated corner, three corners on a line
        self.check(positions, indices, "meshes[0].primitives[0]: 2 triangles of zero area dropped")

    def test_only_triangles_that_cannot_be_drawn(self):
        path = self.write(*gltf_scene.mesh_document(indices=(0, 0, 0)))
        pictures, told = self.pictures(path)
        self.check_notes(path, told, "meshes[0].primitives[0]: 1 triangle of zero area dropped", 0)
        self.assert_uniform(pictures, 0.0)


if __name__ == "__main__":
    unittest.main()
