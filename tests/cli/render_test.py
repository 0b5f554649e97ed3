#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`utsuri render`: files, samples, seeds, what is printed and what is written for machines."""
import math
import unittest

import picture_file
from cli_case import SMALL, USAGE, CliCase

AOV_CHANNELS = {
    "depth": ["depth.Z"],
    "position": ["position.X", "position.Y", "position.Z"],
    "normal": ["normal.X", "normal.Y", "normal.Z"],
    "geometric-normal": ["geometricNormal.X", "geometricNormal.Y", "geometricNormal.Z"],
    "albedo": ["albedo.R", "albedo.G", "albedo.B"],
    "uv": ["uv.U", "uv.V"],
    "triangle": ["triangle.I"],
    "instance": ["instance.I"],
    "material": ["material.I"],
    "reflective": ["reflective.I"],
}
MAPS = ("--map-size", "16", "--map-spp", "1", "--light-spp", "2")


class Render(CliCase):
    def render(self, output, *options):
        """JSON of a render of the Cornell box, whose area light makes every sample random."""
        return self.json_of("render", self.scene("cornell"), "-o", output, *SMALL, *options)

    def bytes_of(self, output, *options):
        self.render(output, *options)
        return (self.scratch / output).read_bytes()


class RenderFiles(Render):
    def test_exr(self):
        values = self.render("picture.exr", "--spp", "3")
        width, height, channels, texts = picture_file.read_exr_header(self.scratch / "picture.exr")
        self.assertEqual((width, height), (16, 12))
        self.assertEqual(sorted(channels), ["B", "G", "R"])
        self.assertEqual(texts["utsuri:method"], "direct/trace")
        self.assertEqual(texts["utsuri:samples"], "3")
        self.assertEqual(values["samples"], 3)
        self.assert_no_partial_files()

    def test_all_aovs(self):
        self.render("picture.exr", "--aov", ",".join(AOV_CHANNELS))
        _, _, channels, _ = picture_file.read_exr_header(self.scratch / "picture.exr")
        self.assertEqual(sorted(channels), sorted(sum(AOV_CHANNELS.values(), ["R", "G", "B"])))
        # The radiance is the same with and without its companions.
        self.render("plain.exr")
        self.assertEqual(self.json_of("diff", "plain.exr", "picture.exr")["metrics"]["max"], 0.0)

    def test_one_aov(self):
        self.render("picture.exr", "--aov", "depth")
        _, _, channels, _ = picture_file.read_exr_header(self.scratch / "picture.exr")
        self.assertEqual(sorted(channels), ["B", "G", "R", "depth.Z"])

    def test_png(self):
        self.render("picture.png")
        width, height, rows = picture_file.read_png(self.scratch / "picture.png")
        self.assertEqual((width, height), (16, 12))
        self.assertGreater(len(set(rows)), 2)
        self.assert_no_partial_files()

    def test_exposure_of_png(self):
        dark, bright = (sum(self.bytes_of(f"{stops}.png", "--exposure", stops)) for stops in ("-60", "60"))
        self.assertLess(dark, bright)
        # A stop more or less changes a display image, but not the light in an .exr.
        self.assertEqual(self.bytes_of("a.exr", "--exposure", "1"), self.bytes_of("b.exr", "--exposure", "2"))

    def test_json(self):
        values = self.render("picture.exr", "--spp", "2", "--seed", "7", "--depth", "5")
        expected = {"image": "picture.exr", "light": "direct", "reflection": "trace", "width": 16,
                    "height": 12, "seed": 7, "specular_depth": 5, "kept_light": False, "samples": 2, "nonfinite": 0}
        self.assertEqual({name: values[name] for name in expected}, expected)
        self.assertEqual(sorted(values["device"]), ["api", "driver", "name"])
        # Every sample follows a ray from the camera, and one to the light where that hits something.
        self.assertGreaterEqual(values["rays"], 16 * 12 * 2)
        for name in ("frame_seconds", "gpu_seconds", "first_frame_seconds", "peak_bytes", "noise"):
            self.assertGreater(values[name], 0, name)

    def test_json_file(self):
        done = self.succeed("render", self.scene("cornell"), "-o", "picture.exr", *SMALL,
                            "--json", "result.json")
        self.assertIn("picture.exr", done.stdout)
        self.assertEqual(self.load("result.json")["samples"], 16)
        self.assert_no_partial_files()

    def test_quiet(self):
        arguments = ("render", self.scene("cornell"), "-o", "picture.exr", *SMALL)
        quiet = self.succeed(*arguments, "--quiet")
        self.assertEqual((quiet.stdout, quiet.stderr), ("", ""))
        loud = self.succeed(*arguments)
        self.assertIn("picture.exr: 16 samples", loud.stdout)

    def test_cameras(self):
        by_index, by_name = (self.bytes_of("picture.exr", "--camera", camera) for camera in ("0", "camera"))
        self.assertEqual(by_index, by_name)
        self.assertEqual(by_index, self.bytes_of("picture.exr"))

    def test_writes_over_an_older_picture(self):
        (self.scratch / "picture.png").write_bytes(b"old")
        self.render("picture.png")
        picture_file.read_png(self.scratch / "picture.png")
        self.assertEqual(self.files(), ["picture.png"])


class RenderSamples(Render):
    def test_seeds(self):
        for name in ("picture.exr", "picture.png"):
            first = self.bytes_of(name, "--seed", "3")
            self.assertEqual(self.bytes_of(name, "--seed", "3"), first)
            self.assertNotEqual(self.bytes_of(name, "--seed", "4"), first)

    def test_default_samples(self):
        self.assertEqual(self.render("picture.exr")["samples"], 16)

    def test_time(self):
        for time in ("1ms", "0.2s"):
            values = self.render("picture.exr", "--time", time)
            self.assertGreaterEqual(values["samples"], 1)
        # The number of samples may still bound a run that has time left.
        self.assertEqual(self.render("picture.exr", "--time", "5min", "--spp", "3")["samples"], 3)

    def test_noise(self):
        wanted = 0.5
        values = self.render("picture.exr", "--noise", str(wanted))
        self.assertLessEqual(values["noise"], wanted)
        self.assertEqual(values["samples"] % 2, 0)
        # The estimate is right within a factor of two, so four times the noise takes fewer samples.
        self.assertLess(self.render("picture.exr", "--noise", str(4 * wanted))["samples"], values["samples"])
        bounded = self.render("picture.exr", "--noise", "1e-7", "--spp", "4")
        self.assertEqual(bounded["samples"], 4)
        self.assertGreater(bounded["noise"], 1e-7)

    def test_noise_of_an_odd_number_of_samples_is_unknown(self):
        self.assertIsNone(self.render("picture.exr", "--spp", "1")["noise"])
        self.assertIsNone(self.render("picture.exr", "--spp", "3")["noise"])
        self.assertTrue(math.isfinite(self.render("picture.exr", "--spp", "2")["noise"]))


class RenderMaps(Render):
    def test_errors_of_reflections(self):
        names = ["predicted.parallax", "predicted.interpolation", "predicted.texel", "predicted.pixels",
                 "measured.angle", "measured.pixels", "measured.distance", "measured.seen"]
        self.json_of("render", self.scene("spheres"), "-o", "picture.exr", *SMALL, "--reflection", "proxy-map", *MAPS,
                     "--aov", "predicted,measured")
        _, _, channels, _ = picture_file.read_exr_header(self.scratch / "picture.exr")
        self.assertEqual(sorted(channels), sorted(["R", "G", "B", *names]))

    def test_traced_pixels(self):
        self.json_of("render", self.scene("spheres"), "-o", "picture.exr", *SMALL, "--reflection", "hybrid", *MAPS,
                     "--aov", "traced")
        _, _, channels, _ = picture_file.read_exr_header(self.scratch / "picture.exr")
        self.assertEqual(sorted(channels), ["B", "G", "R", "traced.I"])
        for reflection in ("trace", "proxy-map"):
            self.fail_with(USAGE, (f"direct/{reflection}", "--reflection hybrid"), "render", self.scene("cornell"),
                           "-o", "none.exr", *SMALL, *MAPS, "--reflection", reflection, "--aov", "traced")

    def test_given_proxy(self):
        (self.scratch / "proxy.txt").write_text("1 0 0 9\n-1 0 0 9\n0 1 0 9\n0 -1 0 9\n0 0 1 9\n1 0 -1 9\n",
                                                encoding="utf-8")
        arguments = ("render", self.scene("office-lambert"), *SMALL, *MAPS, "--spp", "2", "--reflection", "proxy-map")
        self.json_of(*arguments, "-o", "fitted.exr")
        self.json_of(*arguments, "-o", "given.exr", "--proxy", "proxy.txt")
        self.assertGreater(self.json_of("diff", "fitted.exr", "given.exr")["metrics"]["max"], 0.0)

    def test_maps_with_the_same_seed(self):
        for reflection in ("polygon-map", "sphere-map", "cube-map", "proxy-map", "distance-map", "planar", "hybrid"):
            arguments = ("render", self.scene("spheres"), *SMALL, *MAPS, "--spp", "2",
                         "--reflection", reflection)
            for name in ("first.exr", "second.exr"):
                self.assertEqual(self.json_of(*arguments, "-o", name)["reflection"], reflection)
            first, second = ((self.scratch / name).read_bytes() for name in ("first.exr", "second.exr"))
            self.assertEqual(first, second)


if __name__ == "__main__":
    unittest.main()
