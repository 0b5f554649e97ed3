#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Every scene of the scenes folder renders by every method, without a sample that is not finite."""
import subprocess
import sys
import unittest

from cli_case import TIMEOUT_SECONDS, CliCase

SETTINGS = ("--size", "32x24", "--spp", "4", "--map-size", "16", "--map-spp", "2", "--light-spp", "2")
# The scene of a million triangles is made to measure, and here it is small.
LEAST_TRIANGLES = 50000


class Scenes(CliCase):
    def render(self, path, reflection):
        values = self.json_of("render", path, "-o", "picture.exr", "--reflection", reflection, *SETTINGS)
        self.assertEqual(values["nonfinite"], 0)
        self.assertEqual(values["samples"], 4)
        if reflection == "trace":
            self.assertGreater(values["rays"], 32 * 24 * 4)

    def test_kept_scenes(self):
        paths = sorted(self.scenes.glob("*/*.glb"))
        self.assertGreaterEqual({path.stem for path in paths},
                                {"cluttered-mirror", "cornell", "curved-mirror", "mirror-cornell",
                                 "mirror-corridor", "office", "spheres"})
        for path in paths:
            # Filling the light of a scene takes seconds; one method does for all that share it.
            for reflection in ("trace", "proxy-map"):
                with self.subTest(scene=path.stem, reflection=reflection):
                    self.render(path, reflection)

    def test_generated_scene(self):
        path = self.scratch / "million.glb"
        subprocess.run([sys.executable, self.scenes / "million/generate.py", "--out", path,
                        "--triangles", str(LEAST_TRIANGLES)], check=True, timeout=TIMEOUT_SECONDS)
        self.assertGreaterEqual(self.json_of("info", path)["triangles"], LEAST_TRIANGLES)
        self.render(path, "trace")


if __name__ == "__main__":
    unittest.main()
