#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Files whose names are not UTF-8, as old archives unpack them: they are read and written. Results for machines,
which can hold UTF-8 alone, show U+FFFD where the name has something else."""
import json
import os
import unittest

import gltf_scene
from cli_case import SMALL, CliCase, cheap_compare

SCENE, PICTURE = os.fsdecode(b"caf\xe9.glb"), os.fsdecode(b"caf\xe9.png")
SHOWN_SCENE, SHOWN_PICTURE = "caf\ufffd.glb", "caf\ufffd.png"


class OddNames(CliCase):
    def setUp(self):
        super().setUp()
        try:
            (self.scratch / SCENE).write_bytes(gltf_scene.glb_bytes(*gltf_scene.mesh_document()))
        except (OSError, UnicodeError):
            self.skipTest("file names are UTF-8 here")

    def test_info(self):
        self.assertEqual(self.json_of("info", SCENE)["scene"], SHOWN_SCENE)

    def test_render_and_diff(self):
        values = self.json_of("render", SCENE, "-o", PICTURE, *SMALL)
        self.assertEqual((values["scene"], values["image"]), (SHOWN_SCENE, SHOWN_PICTURE))
        self.assertTrue((self.scratch / PICTURE).is_file())
        values = self.json_of("diff", PICTURE, PICTURE)
        self.assertEqual((values["reference"], values["test"]), (SHOWN_PICTURE, SHOWN_PICTURE))
        self.assertEqual(values["metrics"]["max"], 0.0)

    def test_compare(self):
        values = self.json_of("compare", SCENE, "-o", "report", *cheap_compare(), "--methods", "trace,cube-map")
        self.assertEqual(values["scene"], SHOWN_SCENE)
        self.assertIn(SHOWN_SCENE, values["command"])
        self.assertEqual(self.load("report/compare.json"), values)
        self.assertIn(SHOWN_SCENE, (self.scratch / "report/report.html").read_text(encoding="utf-8"))

    def test_trade(self):
        done = self.succeed("trade", SCENE, "-o", "out", *SMALL, "--methods", "trace", "--most-spp", "2",
                            "--reference-spp", "2", "--json", "-",
                            environment={"XDG_CACHE_HOME": str(self.scratch / "cache")})
        self.assertEqual(json.loads(done.stdout)["scene"], SHOWN_SCENE)
        self.assertEqual(self.load("out/trade.json")["scene"], SHOWN_SCENE)
        self.assertIn(SHOWN_SCENE, (self.scratch / "out/trade.html").read_text(encoding="utf-8"))


if __name__ == "__main__":
    unittest.main()
