#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`utsuri trade`: its files, its numbers, and what --within and --error choose; `utsuri render` by the same
choice, measured once and kept."""
import json
import pathlib
import re
import shlex
import tempfile
import unittest

from cli_case import USAGE, CliCase

PICTURE = ("--size", "32x24", "--map-size", "8", "--map-spp", "1", "--light-spp", "1")
SWEEP = ("--most-spp", "4", "--reference-spp", "16")
METRICS = ("rel_mse", "mse", "mape", "flip", "p999", "max")
KEPT = re.compile(r"trade-[0-9a-f]{16}\.json")


def front_of(runs, seconds, error):
    """Indices of the runs that no other beats, by the definition."""
    points = [(seconds(run), error(run)) for run in runs]
    beaten = [any(a <= x and b <= y and (a, b) != (x, y) for a, b in points) for x, y in points]
    kept = [i for i, point in enumerate(points) if not beaten[i] and points.index(point) == i]
    return sorted(kept, key=lambda i: points[i])


class Trade(CliCase):
    """Every test has a cache of its own, and the choice of what is swept."""

    def setUp(self):
        super().setUp()
        self.cache = self.scratch / "cache"
        self.environment = {"XDG_CACHE_HOME": str(self.cache)}

    def trade(self, *options, **more):
        return self.succeed("trade", self.scene("office-lambert"), "-o", "out", *PICTURE, *SWEEP, *options,
                            environment=self.environment, **more)

    def kept_files(self):
        return sorted((self.cache / "utsuri").iterdir()) if self.cache.exists() else []


class TradeOffice(Trade):
    """One trade of a method of each kind, looked at from many sides."""

    @classmethod
    def setUpClass(cls):
        cls.holder = tempfile.TemporaryDirectory(prefix="utsuri_trade_")
        cls.addClassCleanup(cls.holder.cleanup)
        cls.done = None

    def setUp(self):
        super().setUp()
        self.scratch = pathlib.Path(self.holder.name)
        self.cache = self.scratch / "cache"
        self.environment = {"XDG_CACHE_HOME": str(self.cache)}
        if self.done is None:
            type(self).done = self.trade("--methods", "trace,polygon-map,planar,hybrid", "--within", "10min",
                                         "--json", "copy.json")
        self.values = self.load("out/trade.json")

    def test_files(self):
        self.assertEqual({path.name for path in (self.scratch / "out").iterdir()}, {"trade.json", "trade.html"})
        self.assert_no_partial_files()
        self.assertEqual([bool(KEPT.fullmatch(path.name)) for path in self.kept_files()], [True])

    def test_json_option_writes_the_same_and_the_choice(self):
        copy = self.load("copy.json")
        choice = copy.pop("choice")
        self.assertEqual(copy, self.values)
        least = min(self.values["runs"], key=lambda run: (run["errors"]["rel_mse"], run["frame_seconds"]))
        self.assertEqual(choice["error"], least["errors"]["rel_mse"])
        self.assertEqual(choice["command"], least["command"])
        self.assertIn(least["command"], self.done.stdout)

    def test_runs(self):
        runs = self.values["runs"]
        names = {method["name"] for method in runs}
        self.assertIn("direct/trace", names)
        self.assertIn("direct/polygon-map", names)
        for options in {tuple(run["options"]) for run in runs}:
            own = [run for run in runs if tuple(run["options"]) == options]
            self.assertEqual([run["settings"]["samples"] for run in own], [1, 2, 4])
            times = [run["frame_seconds"] for run in own]
            self.assertGreater(times[-1], times[0])
            for run in own:
                self.assertGreater(run["peak_bytes"], 0)
                self.assertEqual(run["nonfinite"], 0)
                self.assertEqual(run["prepare_seconds"] > 0.0, run["reflection"] != "trace")

    def test_errors_are_measurements_less_the_noise(self):
        noise, least = self.values["noise"], self.values["least_errors"]
        self.assertAlmostEqual(noise["mse"], self.values["reference"]["noise_mse"], delta=1e-4 * noise["mse"])
        for run in self.values["runs"]:
            for name in METRICS:
                subtracted = noise[name] if name in ("mse", "rel_mse") else 0.0
                expected = max(run["metrics"][name] - subtracted, least[name])
                self.assertAlmostEqual(run["errors"][name], expected, delta=1e-12 * expected)

    def test_fronts(self):
        runs = self.values["runs"]
        for time, seconds in (("frame", lambda run: run["frame_seconds"]),
                              ("with_preparation", lambda run: run["frame_seconds"] + run["prepare_seconds"])):
            for pixels, errors in (("all", "errors"), ("reflective", "errors_reflective")):
                for name in METRICS:
                    front = self.values["fronts"][time][pixels][name]
                    self.assertEqual(front, front_of(runs, seconds, lambda run: run[errors][name]))

    def test_commands_make_the_pictures_that_were_measured(self):
        for index in (0, len(self.values["runs"]) - 1):
            run = self.values["runs"][index]
            words = shlex.split(run["command"])
            self.assertEqual(words[0], "utsuri")
            result = self.scratch / "result.json"
            self.succeed(*words[1:], "--json", result)
            values = json.loads(result.read_text(encoding="utf-8"))
            self.assertEqual(values["samples"], run["settings"]["samples"])
            self.assertEqual(values["reflection"], run["reflection"])
            self.assertEqual((values["width"], values["height"]), (32, 24))
            self.assertEqual(values["rays"], run["rays"])


class Choice(Trade):
    def test_narrow_sweeps(self):
        self.trade("--methods", "trace")
        runs = self.load("out/trade.json")["runs"]
        self.assertEqual([run["options"] for run in runs], [["--reflection", "trace"]] * 3)

    def test_nothing_fits(self):
        done = self.trade("--methods", "trace", "--within", "1e-9ms", code=USAGE)
        self.assertRegex(done.stderr, r"within 1e-9ms: the fastest takes .*; allow at least that")
        self.assertTrue((self.scratch / "out/trade.json").is_file(), "what was measured is kept all the same")
        done = self.trade("--methods", "trace", "--error", "0", code=USAGE)
        self.assertRegex(done.stderr, r"relMSE at most 0: the noise of the reference hides errors below")
        values = self.load("out/trade.json")
        least = min(run["errors"]["mse"] for run in values["runs"])
        hidden = values["least_errors"]["mse"]
        self.assertGreater(least, hidden)
        between = str(0.5 * (least + hidden))
        done = self.trade("--methods", "trace", "--metric", "mse", "--error", between, code=USAGE)
        self.assertRegex(done.stderr, r"MSE at most .*: the least found is .*; allow at least that")

    def test_settings_that_cannot_be_are_told(self):
        too_fine = ("--polygon-edge", "1e-6", "--json", "result.json")
        done = self.trade("--methods", "trace,polygon-map", *too_fine)
        values = self.load("result.json")
        self.assertEqual({run["name"] for run in values["runs"]}, {"direct/trace"})
        swept = [failure["options"][2:] for failure in values["failed"]]
        self.assertEqual(swept, [["--map-size", "2"], ["--map-size", "8"], ["--map-size", "fit"],
                                 ["--map-size", "8", "--probes", "4"]])
        for failure in values["failed"]:
            self.assertIn("use a larger --polygon-edge", failure["message"])
            self.assertIn(f"{' '.join(failure['options'])} is missing: {failure['message']}", done.stdout)
        self.trade("--methods", "polygon-map", *too_fine, code=USAGE)
        self.assertEqual(self.load("result.json")["runs"], [])


class TradeReference(Trade):
    """The reference, where nobody says how good it is to be."""

    def test_takes_the_samples_that_the_least_error_needs(self):
        # Light kept on surfaces has little noise, and a reference of ten times the samples too much to tell its error.
        self.succeed("trade", self.scene("spheres"), "-o", "out", "--size", "32x24", "--map-size", "8", "--map-spp", "1",
                     "--most-spp", "2", "--methods", "trace,hybrid", environment=self.environment)
        values = self.load("out/trade.json")
        reference = values["reference"]
        self.assertGreater(reference["settings"]["samples"], 20)
        least = min(run["metrics"]["mse"] for run in values["runs"])
        self.assertLessEqual(reference["noise_mse"], 0.1 * least)
        self.assertAlmostEqual(values["noise"]["mse"], reference["noise_mse"], delta=1e-4 * reference["noise_mse"])


class RenderByChoice(Trade):
    """`render --within` and `--error` measure once, and again when what they kept is of no use."""

    def render(self, *options, **more):
        return self.succeed("render", self.small_scene(), "-o", "picture.exr", *PICTURE, *options,
                            environment=self.environment, **more)

    def small_scene(self):
        path = self.scratch / "cornell.glb"
        if not path.exists():
            path.write_bytes(self.scene("cornell").read_bytes())
        return path

    def test_takes_what_trade_kept(self):
        self.succeed("trade", self.small_scene(), "-o", "out", *PICTURE, environment=self.environment)
        runs = self.load("out/trade.json")["runs"]
        (kept,) = self.kept_files()
        text = kept.read_text(encoding="utf-8")
        for wish in (("--within", "10min"), ("--error", "1e6", "--metric", "flip")):
            done = self.render(*wish, "--json", "result.json")
            self.assertNotIn("measuring", done.stderr)
            self.assertRegex(done.stdout, r"chosen: direct/\S+ .*--spp \d+, expected \S+ \S+, frame ")
            values = self.load("result.json")
            choice = values["choice"]
            run = next(run for run in runs if run["options"] == choice["options"] and
                       run["settings"]["samples"] == choice["samples"])
            self.assertEqual(choice["error"], run["errors"][choice["metric"]])
            self.assertEqual(choice["frame_seconds"], run["frame_seconds"])
            self.assertEqual((values["reflection"], values["samples"]),
                             (run["reflection"], run["settings"]["samples"]))
        self.assertEqual(min(run["frame_seconds"] for run in runs), choice["frame_seconds"])
        self.assertEqual(kept.read_text(encoding="utf-8"), text)
        # What is of no use is measured again.
        kept.write_text(text[:1000], encoding="utf-8")
        self.assertIn("measuring", self.render("--error", "1e6").stderr)
        again = json.loads(kept.read_text(encoding="utf-8"))
        self.assertEqual(again["key"], json.loads(text)["key"])
        self.assertEqual(len(again["trade"]["runs"]), len(runs))
        self.assertEqual(self.kept_files(), [kept])

    def test_without_a_place_to_keep(self):
        (self.scratch / "file").write_text("in the way", encoding="utf-8")
        self.environment = {"XDG_CACHE_HOME": str(self.scratch / "file")}
        done = self.render("--error", "1e6")
        self.assertIn("the trade is not kept for later", done.stderr)
        self.assertTrue((self.scratch / "picture.exr").is_file())

    def test_what_a_choice_decides_cannot_be_given(self):
        for choice in (("--within", "33ms"), ("--error", "0.01")):
            for fixed in (("--reflection", "trace"), ("--spp", "4"), ("--time", "1s"), ("--noise", "0.1")):
                with self.subTest(choice=choice, fixed=fixed):
                    self.fail_with(USAGE, (choice[0], fixed[0], "excludes"), "render", self.scene("cornell"),
                                   "-o", "picture.exr", *choice, *fixed, environment=self.environment)
        self.fail_with(USAGE, ("--error", "--within", "excludes"), "render", self.scene("cornell"), "-o",
                       "picture.exr", "--within", "33ms", "--error", "1", environment=self.environment)
        self.assertEqual(self.kept_files(), [])


if __name__ == "__main__":
    unittest.main()
