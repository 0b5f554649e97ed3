#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Every scene of the scenes folder renders by every method, without a sample that is not finite, and none is black."""
import math
import subprocess
import sys
import unittest

import picture_file
from cli_case import TIMEOUT_SECONDS, CliCase, environment_path

SAMPLES, WIDTH, HEIGHT = 4, 32, 24
SETTINGS = ("--size", f"{WIDTH}x{HEIGHT}", "--spp", str(SAMPLES), "--reference-spp", "2", "--map-size", "16",
            "--map-spp", "2", "--light-spp", "2", "--light-points", "20000")
# The scene of a million triangles is made to measure, and here it is small.
LEAST_TRIANGLES = 50000


class Scenes(CliCase):
    """Has a test for each of the kept scenes, see below."""

    def render(self, path, methods=None):
        # Filling the light of a scene takes seconds: a comparison shares it among the methods.
        methods = methods or self.reflections()
        values = self.json_of("compare", path, "-o", "report", "--methods", ",".join(methods), *SETTINGS)
        self.assertEqual(values["failed"], [])
        self.assertEqual([result["reflection"] for result in values["methods"]], methods)
        for result in values["methods"]:
            with self.subTest(method=result["name"]):
                self.assertEqual(result["nonfinite"], 0)
                self.assertEqual(result["settings"]["samples"], SAMPLES)
                if result["reflection"] == "trace":
                    self.assertGreater(result["rays"], WIDTH * HEIGHT * SAMPLES)
                self.check_picture(self.scratch / "report" / result["image"])

    def check_picture(self, path):
        width, height, rows = picture_file.read_exr(path)
        self.assertEqual((width, height), (WIDTH, HEIGHT))
        values = [value for row in rows for pixel in row for value in pixel]
        self.assertTrue(all(math.isfinite(value) and value >= 0.0 for value in values))
        # All scenes are lit rooms, or stages that fill most of the view.
        self.assertGreater(sum(value > 0.0 for value in values), len(values) / 2)

    def test_generated_scene(self):
        path = self.scratch / "million.glb"
        subprocess.run([sys.executable, self.scenes / "million/generate.py", "--out", path,
                        "--triangles", str(LEAST_TRIANGLES)], check=True, timeout=TIMEOUT_SECONDS)
        self.assertGreaterEqual(self.json_of("info", path)["triangles"], LEAST_TRIANGLES)
        self.render(path)

    def test_kept_scenes_have_tests(self):
        kept = {"chrome", "cluttered-mirror", "cornell", "corner", "curved-mirror", "dielectric", "loft",
                "mirror-cornell", "mirror-corridor", "office", "office-lambert", "spheres"}
        self.assertGreaterEqual({path.stem for path in kept_scenes()}, kept)


def kept_scenes():
    return sorted(environment_path("UTSURI_SCENES").glob("*/*.glb"))


# Most of the time goes into compiling kernels: what is particular to these shows in three methods.
FEW_METHODS = {stem: ["trace", "cube-map", "hybrid"] for stem in ("chrome", "corner", "dielectric", "loft")}

for scene in kept_scenes():
    setattr(Scenes, f"test_{scene.stem}",
            lambda self, path=scene: self.render(path, FEW_METHODS.get(path.stem)))


if __name__ == "__main__":
    unittest.main()
