# SPDX-License-Identifier: Apache-2.0
"""Base of the tests of odd scenes: every method renders them, and its pictures are held against what is right."""
import math

import gltf_scene
import picture_file
from cli_case import SMALL, CliCase

SAMPLES = 16
# Maps of 16 texels are enough for every code path.
SETTINGS = (*SMALL, "--spp", str(SAMPLES), "--reference-spp", "2", "--map-size", "16", "--map-spp", "1", "--light-spp", "2")
MIRROR = {"pbrMetallicRoughness": {"metallicFactor": 1.0, "roughnessFactor": 0.0}}
# Of pictures whose pixels are all equal: a few roundings of float32.
ROUNDING = 1e-6


def with_material(document, material):
    document["materials"] = [material]
    document["meshes"][0]["primitives"][0]["material"] = 0
    return document


class OddCase(CliCase):
    def write(self, document, buffer=b""):
        return gltf_scene.write_gltf(self.scratch / "odd.gltf", document, buffer)

    def pictures(self, path):
        """({method: rows of pixels}, standard error) of every method; no sample is left out and all pixels are finite."""
        done = self.succeed("compare", path, "-o", "report", *SETTINGS)
        values = self.load("report/compare.json")
        self.assertEqual([result["reflection"] for result in values["methods"]], self.reflections())
        self.assertEqual(values["failed"], [])
        pictures = {}
        for result in values["methods"]:
            self.assertEqual(result["nonfinite"], 0, result["name"])
            width, height, rows = picture_file.read_exr(self.scratch / "report" / result["image"])
            self.assertEqual((width, height), (16, 12))
            self.assertTrue(all(math.isfinite(value) for row in rows for pixel in row for value in pixel))
            pictures[result["reflection"]] = rows
        return pictures, done.stderr

    def assert_uniform(self, pictures, radiance):
        """Every pixel of every method has a radiance."""
        for method, rows in pictures.items():
            worst = max(abs(value - radiance) for row in rows for pixel in row for value in pixel)
            self.assertLessEqual(worst, ROUNDING * radiance, method)

    def assert_within(self, rows, bounds, method):
        """Every pixel is within the bounds of its footprint, and grey."""
        height, width = len(rows), len(rows[0])
        for row, pixels in enumerate(rows):
            for column, pixel in enumerate(pixels):
                least, most = bounds(column, row, width, height)
                for value in pixel:
                    self.assertTrue(least <= value <= most,
                                    f"{method}, pixel {column} {row}: {value} is not in [{least}, {most}]")

    def check_notes(self, path, told, note, triangles):
        """`info` tells a note that a run told, and `triangles` of them are left."""
        self.assertIn(f"note: {note}\n", told)
        values = self.json_of("info", path)
        self.assertIn(note, values["notes"])
        self.assertEqual(values["triangles"], triangles)
