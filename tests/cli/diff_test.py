#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`utsuri diff`: metrics with known values, exit codes, error maps."""
import unittest

import picture_file
from cli_case import DIFFERENCE, INPUT, CliCase

# image/metrics.h: added to the denominators of the relative metrics.
EPSILON = 0.01


class Diff(CliCase):
    def setUp(self):
        super().setUp()
        for name, level in (("black.png", 0), ("white.png", 255)):
            picture_file.write_grey_png(self.scratch / name, 24, 16, level)
        picture_file.write_grey_png(self.scratch / "wide.png", 25, 16, 0)

    def test_equal(self):
        done = self.succeed("diff", "white.png", "white.png", "--fail-above", "0")
        self.assertIn("white.png against white.png", done.stdout)
        metrics = self.json_of("diff", "white.png", "white.png")["metrics"]
        expected = {"mse": 0.0, "rel_mse": 0.0, "mape": 0.0, "psnr": None, "flip": 0.0, "max": 0.0,
                    "p999": 0.0, "pixels": 24 * 16, "nonfinite": 0}
        self.assertEqual({name: metrics[name] for name in expected}, expected)
        self.assertAlmostEqual(metrics["ssim"], 1.0, places=6)

    def test_black_and_white(self):
        metrics = self.json_of("diff", "black.png", "white.png")["metrics"]
        for name, value in (("mse", 1.0), ("max", 1.0), ("p999", 1.0), ("rel_mse", 1 / EPSILON),
                            ("mape", 1 / EPSILON), ("psnr", 0.0)):
            self.assertAlmostEqual(metrics[name], value, delta=1e-6 * max(1.0, value), msg=name)
        self.assertGreater(metrics["flip"], 0.9)  # nothing differs more than black and white

    def test_threshold(self):
        for metric, value in (("rel_mse", 1 / EPSILON), ("mse", 1.0), ("max", 1.0)):
            arguments = ("diff", "black.png", "white.png", "--metric", metric, "--fail-above")
            self.succeed(*arguments, str(0.99 * value), code=DIFFERENCE)
            self.succeed(*arguments, str(1.01 * value))
        # Without a threshold any difference is a success.
        self.succeed("diff", "black.png", "white.png")

    def test_sizes_that_differ(self):
        self.fail_with(INPUT, ("24", "25", "16"), "diff", "black.png", "wide.png")

    def test_error_map(self):
        self.succeed("diff", "black.png", "white.png", "--error-map", "map.png")
        width, height, rows = picture_file.read_png(self.scratch / "map.png")
        self.assertEqual((width, height), (24, 16))
        self.assertGreater(max(rows), 0)
        self.assert_no_partial_files()

    def test_files_that_are_no_pictures(self):
        (self.scratch / "text.png").write_text("not a picture", encoding="utf-8")
        (self.scratch / "cut.png").write_bytes((self.scratch / "white.png").read_bytes()[:60])
        (self.scratch / "folder.png").mkdir()
        for name in ("text.png", "cut.png", "folder.png", "nowhere.png"):
            with self.subTest(name=name):
                self.fail_with(INPUT, (name,), "diff", "black.png", name)
                self.fail_with(INPUT, (name,), "diff", name, "black.png")

    def test_quiet(self):
        done = self.succeed("diff", "black.png", "white.png", "--quiet")
        self.assertEqual((done.stdout, done.stderr), ("", ""))


if __name__ == "__main__":
    unittest.main()
