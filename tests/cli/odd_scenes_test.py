#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Scenes that lack something or hold what is not supported: every method renders them, and the program says so."""
import math
import unittest

import gltf_scene
import plate
from odd_case import SAMPLES, OddCase, with_material

# Standard errors within which the mean of a traced picture lies.
SIGMAS = 5.0


class OddScenes(OddCase):
    def test_without_camera(self):
        path = self.write(*gltf_scene.mesh_document(camera=False))
        pictures, told = self.pictures(path)
        self.check_notes(path, told, 'no camera in the file: one that frames the whole scene, named "default"', 2)
        traced = pictures["trace"]
        self.assertGreater(max(pixel[0] for row in traced for pixel in row), 0.0)
        for method, rows in pictures.items():
            self.assert_within(rows, lambda column, row, *_: neighbourhood(traced, column, row), method)

    def test_without_light(self):
        path = self.write(*gltf_scene.mesh_document(light=False))
        pictures, told = self.pictures(path)
        self.check_notes(path, told, "no light in the file: lit by a uniform environment of 1 cd/m2", 2)
        # These trace glossy lobes.
        traced = [pictures.pop(method) for method in ("trace", "hybrid")]
        for method, rows in pictures.items():
            self.assert_within(rows, lambda *pixel: plate.furnace_bounds(plate.footprint(*pixel)), method)
        for rows in traced:
            values = [pixel[0] for row, pixels in enumerate(rows) for column, pixel in enumerate(pixels)
                      if plate.cover(plate.footprint(column, row, 16, 12)) == 1.0]
            # A sample is between 0 and 1, so its standard deviation is 0.5 at most.
            noise = SIGMAS * 0.5 / math.sqrt(SAMPLES * len(values))
            mean = sum(values) / len(values)
            self.assertTrue(plate.LEAST_ALBEDO - noise <= mean <= plate.MOST_ALBEDO + noise, mean)

    def test_empty_scene_shows_the_surroundings(self):
        pictures, told = self.pictures(self.write({"asset": {"version": "2.0"}}))
        self.assertIn("no triangle in the file: the scene is empty", told)
        self.assert_uniform(pictures, 1.0)

    def test_ignored_extension_is_named(self):
        document, buffer = gltf_scene.mesh_document()
        with_material(document, {"extensions": {"KHR_materials_clearcoat": {"clearcoatFactor": 1.0}}})
        document["extensionsUsed"].append("KHR_materials_clearcoat")
        pictures, told = self.pictures(self.write(document, buffer))
        self.assertIn("KHR_materials_clearcoat is not supported (clear coats are not drawn)", told)
        self.assertIn("materials[0]", told)
        for method, rows in pictures.items():
            self.assert_within(rows, lambda *pixel: plate.lit_bounds(plate.footprint(*pixel)), method)


def neighbourhood(rows, column, row):
    """What a pixel of the same smooth picture may have, its samples elsewhere: what the pixels about it have."""
    values = [pixel[0] for pixels in rows[max(row - 1, 0):row + 2] for pixel in pixels[max(column - 1, 0):column + 2]]
    # Half of their range is what samples at a pixel's edge differ by from those at its centre.
    slack = 0.5 * (max(values) - min(values))
    return min(values) - slack, max(values) + slack


if __name__ == "__main__":
    unittest.main()
