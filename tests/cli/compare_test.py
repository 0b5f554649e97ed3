#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`utsuri compare`: the files it leaves, compare.json, thresholds, subsets of the methods."""
import json
import pathlib
import tempfile
import unittest

import picture_file
from cli_case import DIFFERENCE, USAGE, CliCase, cheap_compare

METHODS = ["direct/trace", "direct/polygon-map", "direct/sphere-map", "direct/cube-map", "direct/proxy-map",
           "direct/distance-map", "direct/planar", "direct/hybrid"]
TOP_FIELDS = {"schema": int, "utsuri": str, "scene": str, "device": dict, "width": int, "height": int,
              "seed": int, "light": str, "reference": dict, "methods": list}
RESULT_FIELDS = {"name": str, "light": str, "reflection": str, "settings": dict, "prepare_seconds": float,
                 "frame_seconds": float, "gpu_seconds": float, "peak_bytes": int, "rays": int,
                 "traced_fraction": float, "nonfinite": int, "image": str}
METRICS = ("mse", "rel_mse", "mape", "psnr", "ssim", "flip", "max", "p999")


def named_files(values):
    """The files that a compare.json names, with the display images beside the .exr files."""
    names = {"compare.json", "report.html"}
    for result in [values["reference"], *values["methods"]]:
        names |= {result["image"], str(pathlib.Path(result["image"]).with_suffix(".png"))}
        names |= {result["error_map"]} if "error_map" in result else set()
        errors = result.get("reflection_errors", {})
        names |= {errors[kind]["image"] for kind in ("predicted", "measured", "traced") if kind in errors}
    return names


class Compare(CliCase):
    def assert_fields(self, values, fields):
        for name, kind in fields.items():
            self.assertIsInstance(values[name], (int, float) if kind is float else kind, name)

    def compare(self, name, *options, **samples):
        return self.json_of("compare", self.scene(name), "-o", "report", *cheap_compare(**samples), *options)


class CompareOffice(Compare):
    """One run of all methods, looked at from many sides."""

    @classmethod
    def setUpClass(cls):
        cls.holder = tempfile.TemporaryDirectory(prefix="utsuri_compare_")
        cls.addClassCleanup(cls.holder.cleanup)
        cls.done = None

    def setUp(self):
        super().setUp()
        self.scratch = pathlib.Path(self.holder.name)
        if self.done is None:
            type(self).done = self.succeed("compare", self.scene("office-lambert"), "-o", "report", *cheap_compare(),
                                           "--seed", "5", "--json", "copy.json")
        self.values = self.load("report/compare.json")

    def test_files(self):
        present = {path.name for path in (self.scratch / "report").iterdir()}
        self.assertEqual(present, named_files(self.values))
        self.assert_no_partial_files()

    def test_pictures(self):
        for name in named_files(self.values):
            path = self.scratch / "report" / name
            if path.suffix == ".png":
                self.assertEqual(picture_file.read_png(path)[:2], (64, 48), name)
            elif path.suffix == ".exr":
                self.assertEqual(picture_file.read_exr_header(path)[:2], (64, 48), name)

    def test_json_option_writes_the_same(self):
        self.assertEqual(self.load("copy.json"), self.values)

    def test_top_level(self):
        self.assert_fields(self.values, TOP_FIELDS)
        expected = {"schema": 1, "scene": str(self.scene("office-lambert")), "width": 64, "height": 48, "seed": 5,
                    "light": "direct", "kept_light": False, "triangles": 3692, "interrupted": False, "notes": []}
        self.assertEqual({name: self.values[name] for name in expected}, expected)
        self.assertEqual(sorted(self.values["device"]), ["api", "driver", "name"])
        self.assertTrue(self.values["command"].startswith("utsuri compare "))
        self.assertTrue(0 < self.values["reflective_pixels"] < 64 * 48)

    def test_reference(self):
        reference = self.values["reference"]
        self.assert_fields(reference, RESULT_FIELDS)
        self.assertEqual(reference["name"], "direct/trace")
        self.assertEqual(reference["settings"]["samples"], 4)
        self.assertGreater(reference["noise"], 0.0)
        self.assertNotIn("metrics", reference)

    def test_methods(self):
        self.assertEqual([result["name"] for result in self.values["methods"]], METHODS)
        for result in self.values["methods"]:
            with self.subTest(method=result["name"]):
                self.assert_fields(result, {**RESULT_FIELDS, "error_map": str})
                self.assertEqual(result["name"], f"{result['light']}/{result['reflection']}")
                self.assertEqual(result["settings"]["samples"], 2)
                self.assertEqual(result["nonfinite"], 0)
                if result["reflection"] == "trace":
                    self.assertGreaterEqual(result["rays"], 64 * 48 * 2)
                elif result["reflection"] == "hybrid":
                    self.assertEqual(result["rays"] > 0, result["traced_fraction"] > 0.0)
                else:
                    self.assertEqual(result["rays"], 0, "a drawn frame traces nothing")
                for name in ("frame_seconds", "gpu_seconds", "peak_bytes"):
                    self.assertGreater(result[name], 0, name)
                self.assertLessEqual(result["gpu_seconds"], result["frame_seconds"])

    def test_traced_fraction(self):
        fractions = {result["reflection"]: result["traced_fraction"] for result in self.values["methods"]}
        traced = next(result for result in self.values["methods"] if result["reflection"] == "trace")
        # Where rough surfaces face each other chains are cut now and then.
        self.assertAlmostEqual(fractions.pop("trace") + traced["truncated_fraction"], 1.0, places=9)
        self.assertLessEqual(traced["truncated_fraction"], 0.01)
        self.assertGreater(fractions.pop("hybrid"), 0.0)
        self.assertEqual(set(fractions.values()), {0.0})

    def test_maps(self):
        for result in self.values["methods"]:
            traces = result["reflection"] == "trace"
            self.assertEqual("map_size" in result["settings"], not traces)
            self.assertEqual(result["prepare_rays"] == 0, traces)
            if not traces:
                self.assertEqual((result["settings"]["map_size"], result["settings"]["map_samples"]), (16, 1))

    def test_metrics(self):
        for result in self.values["methods"]:
            reflective = self.values["reflective_pixels"]
            for group, pixels in (("metrics", 64 * 48), ("metrics_reflective", reflective)):
                metrics = result[group]
                self.assertEqual(sorted(metrics), sorted([*METRICS, "pixels", "nonfinite"]))
                self.assertEqual((metrics["pixels"], metrics["nonfinite"]), (pixels, 0))
                for name in ("mse", "rel_mse", "mape", "max"):
                    self.assertGreater(metrics[name], 0.0, name)
                self.assertLessEqual(metrics["p999"], metrics["max"])
                self.assertTrue(0.0 < metrics["flip"] < 1.0)
                self.assertTrue(-1.0 < metrics["ssim"] < 1.0)

    def test_metrics_agree_with_diff(self):
        for result in self.values["methods"]:
            metrics = self.json_of("diff", "report/reference.exr", f"report/{result['image']}")["metrics"]
            # The files hold float32, which is what was measured.
            self.assertAlmostEqual(metrics["rel_mse"], result["metrics"]["rel_mse"],
                                   delta=1e-9 * result["metrics"]["rel_mse"])

    def test_text(self):
        for words in (*METHODS, "relMSE", "reflective pixels", "report/report.html", "noise"):
            self.assertIn(words, self.done.stdout)

    def test_report_holds_its_data(self):
        text = (self.scratch / "report/report.html").read_text(encoding="utf-8")
        for method in METHODS:
            self.assertIn(method, text)


class CompareOthers(Compare):
    def test_scene_without_reflective_pixels(self):
        values = self.compare("cornell")
        self.assertEqual(values["reflective_pixels"], 0)
        for result in values["methods"]:
            metrics = result["metrics_reflective"]
            self.assertEqual({name: metrics[name] for name in METRICS}, dict.fromkeys(METRICS))
            self.assertEqual(metrics["pixels"], 0)
        # Without mirrors all maps draw the same picture, and nothing is captured.
        errors = {result["metrics"]["mse"] for result in values["methods"] if result["reflection"] != "trace"}
        self.assertEqual(len(errors), 1)

    def test_threshold(self):
        arguments = ("compare", self.scene("cornell"), "-o", "report", *cheap_compare(), "--methods", "trace")
        done = self.succeed(*arguments, "--fail-above", "0", code=DIFFERENCE)
        self.assertRegex(done.stderr, r"direct/trace: relMSE \S+ is above 0")
        self.succeed(*arguments, "--fail-above", "1e9")

    def test_methods_subset(self):
        values = self.compare("spheres", "--methods", "sphere-map,trace")
        names = [result["name"] for result in values["methods"]]
        self.assertEqual(names, ["direct/sphere-map", "direct/trace"])
        self.assertEqual({path.name for path in (self.scratch / "report").iterdir()}, named_files(values))

    def test_finished_methods_outlive_one_that_fails(self):
        # The maps of the office's two mirrors at this size.
        needed = 2 * 6 * (4096 + 2) ** 2 * 12
        listed = self.json_of("devices")
        device = listed["devices"][listed["chosen"]]
        if device["storage_range_bytes"] >= needed:
            self.skipTest(f"{device['name']} can hold the largest maps there are")
        done = self.succeed("compare", self.scene("office-lambert"), "-o", "report", "--size", "64x48", "--spp", "2",
                            "--reference-spp", "2", "--map-size", "4096", "--methods", "polygon-map,trace",
                            code=USAGE)
        self.assertRegex(done.stderr, "direct/polygon-map: .*--map-size may be at most")
        values = self.load("report/compare.json")
        self.assertEqual([result["name"] for result in values["methods"]], ["direct/trace"])
        self.assertEqual([failure["name"] for failure in values["failed"]], ["direct/polygon-map"])
        self.assertFalse(values["interrupted"])

    def test_predictions(self):
        methods = ("--methods", "trace,polygon-map,planar,hybrid")
        plain = self.compare("curved-mirror", *methods)
        values = self.compare("curved-mirror", *methods, "--predictions")
        self.assertEqual({path.name for path in (self.scratch / "report").iterdir()}, named_files(values))
        trace, polygon_map, planar, hybrid = values["methods"]
        self.assertNotIn("reflection_errors", trace)
        self.assertNotIn("reflection_errors", planar)
        errors = polygon_map["reflection_errors"]
        self.assertNotIn("traced", errors)
        # Where an object begins, centres of pixels and samples beside them differ.
        self.assertAlmostEqual(errors["pixels"], values["reflective_pixels"], delta=0.1 * values["reflective_pixels"])
        self.assertLess(errors["measured"]["median"], errors["predicted"]["median"])
        self.assertLess(errors["exceeded"], 0.01)
        chosen = hybrid["reflection_errors"]
        self.assertTrue(0 < chosen["traced"]["pixels"] < chosen["pixels"])
        self.assertLessEqual(chosen["predicted"]["p95"], hybrid["settings"]["tolerance"])
        # What predictions take is no part of what the methods take.
        for with_them, without in zip(values["methods"], plain["methods"]):
            for name in ("rays", "prepare_rays", "peak_bytes", "metrics"):
                self.assertEqual(with_them[name], without[name], name)
            self.assertNotIn("reflection_errors", without)

    def test_reference_takes_the_samples_that_the_least_error_needs(self):
        picture = ("--size", "64x48", "--spp", "2", "--map-size", "16", "--map-spp", "1", "--light-spp", "2")
        values = self.json_of("compare", self.scene("cornell"), "--methods", "trace", *picture)
        reference = values["reference"]
        least = min(method["metrics"]["mse"] for method in values["methods"])
        self.assertLessEqual(reference["noise_mse"], 0.1 * least)
        # An exact method's error is its noise: 9 times its samples leave a tenth of what both make together.
        self.assertGreaterEqual(reference["settings"]["samples"], 18)
        # No time for more than tells how long a sample takes: what cannot be told is named.
        done = self.succeed("compare", self.scene("cornell"), "--methods", "trace", *picture,
                            "--reference-time", "1e-6s", "-o", "short")
        self.assertIn("It is more than a tenth of the MSE of direct/trace", done.stdout)
        short = json.loads((self.scratch / "short/compare.json").read_text())
        self.assertEqual(short["reference"]["settings"]["samples"], 2)

    def test_odd_reference_becomes_even(self):
        values = self.compare("cornell", "--methods", "trace", reference_samples=3)
        self.assertEqual(values["reference"]["settings"]["samples"], 4)

    def test_same_seed_same_errors(self):
        first, second = (self.compare("cornell", "--methods", "trace", "--seed", "9") for _ in range(2))
        self.assertEqual(first["methods"][0]["metrics"], second["methods"][0]["metrics"])
        other = self.compare("cornell", "--methods", "trace", "--seed", "10")
        self.assertNotEqual(first["methods"][0]["metrics"], other["methods"][0]["metrics"])

    def test_reference_has_samples_of_its_own(self):
        # As many samples and the same seed: without seeds of its own the reference would equal the method.
        values = self.compare("cornell", "--methods", "trace", samples=4)
        self.assertGreater(values["methods"][0]["metrics"]["mse"], 0.0)

    def test_default_folder(self):
        self.succeed("compare", self.scene("cornell"), *cheap_compare(), "--methods", "trace", "--quiet")
        self.assertTrue((self.scratch / "compare-cornell/compare.json").is_file())

    def test_quiet(self):
        done = self.succeed("compare", self.scene("cornell"), *cheap_compare(), "--methods", "trace",
                            "--quiet")
        self.assertEqual((done.stdout, done.stderr), ("", ""))

    def test_notes_are_kept(self):
        notes = self.compare("cornell", "--methods", "trace")["notes"]
        self.assertEqual(notes, self.json_of("info", self.scene("cornell"))["notes"])


if __name__ == "__main__":
    unittest.main()
