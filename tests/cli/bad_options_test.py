#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Command lines that cannot be meant: exit code 2, with the option, the value and what would be right."""
import re
import unittest

import gltf_scene
from cli_case import INPUT, USAGE, CliCase

SUBCOMMANDS = ("compare", "render", "trade", "info", "diff", "devices")


class BadOptions(CliCase):
    """How refusals are asked for; the tests are in classes of their own, each an entry of ctest."""

    def setUp(self):
        super().setUp()
        (self.scratch / "scene.glb").write_bytes(gltf_scene.glb_bytes(*gltf_scene.mesh_document()))

    def refuse(self, words, *arguments):
        with self.subTest(arguments=" ".join(arguments)):
            self.fail_with(USAGE, words, *arguments)

    def refuse_picture_option(self, option, values, *words):
        """`render` refuses each of the values, and `compare` and `trade` the first."""
        for value in values:
            self.refuse((value, *words), "render", "scene.glb", "-o", "picture.exr", option, value)
        for name in ("compare", "trade"):
            given = "--most-spp" if (name, option) == ("trade", "--spp") else option
            told = [given if word == option else word for word in words]
            self.refuse((values[0], *told), name, "scene.glb", "-o", "folder", given, values[0])


class BadNumbers(BadOptions):
    def test_sizes(self):
        sizes = ("0x0", "100000x100000", "64", "64x", "x48", "-64x48", "64x48x2", "64X48", "6.5x4", "16385x1",
                 "")
        self.refuse_picture_option("--size", sizes, "--size", "from 1 to 16384", "512x384")
        self.refuse(("'0x0'", "from 1 to 16384"), "info", "scene.glb", "--size", "0x0")

    def test_whole_numbers(self):
        most = 2**32 - 1
        for option, lowest, highest in (("--spp", 1, 2**24), ("--depth", 0, 1000000),
                                        ("--map-spp", 1, 65536), ("--light-spp", 1, 256), ("--seed", 0, most)):
            values = (str(lowest - 1), str(highest + 1), "many", "1.5", "nan")
            self.refuse_picture_option(option, values, option, f"{lowest} to {highest}")
        for value in ("1", str(2**24 + 1)):
            for name in ("compare", "trade"):
                self.refuse(("--reference-spp", value, "2 to 16777216"),
                            name, "scene.glb", "--reference-spp", value)
        for name in ("compare", "trade"):
            self.refuse(("'soon'", "5min"), name, "scene.glb", "--reference-time", "soon")
            self.refuse(("--reference-spp",), name, "scene.glb", "--reference-time", "2s", "--reference-spp", "8")

    def test_map_sizes(self):
        values = ("0", "4097", "-1", "many", "1.5", "nan", "fit ", "Fit", "fit:8")
        self.refuse_picture_option("--map-size", values, "--map-size", "1 to 4096", "or fit")
        self.refuse(("--map-size", "1 to 4096"), "info", "scene.glb", "--map-size", "4097")

    def test_real_numbers(self):
        stops = ("61", "-60.5", "nan", "inf", "bright")
        self.refuse_picture_option("--exposure", stops, "--exposure", "-60 to 60")
        self.refuse(("--exposure", "-60 to 60"), "diff", "a.png", "b.png", "--exposure", "nan")
        lengths = ("0", "-1", "nan", "inf", "long")
        self.refuse_picture_option("--polygon-edge", lengths, "--polygon-edge", "1e-06 to 1e+09")
        self.refuse_picture_option("--polygon-error", (*lengths, "91"), "--polygon-error", "0.001 to 90")
        for value in ("0", "-1", "nan", "inf", "low"):
            self.refuse(("--noise", value, "1e-07 to 1e+06"),
                        "render", "scene.glb", "-o", "picture.exr", "--noise", value)
        for value in ("-0.1", "nan", "inf", "low"):
            self.refuse(("--error", value, "0 to"), "trade", "scene.glb", "--error", value)
            self.refuse(("--fail-above", value, "0 to"), "compare", "scene.glb", "--fail-above", value)
            self.refuse(("--fail-above", value, "0 to"), "diff", "a.png", "b.png", "--fail-above", value)

    def test_tolerances(self):
        values = ("-1", "2000000", "nan", "inf", "%", "5 %", "%5", "5%%", "0%", "0.001%", "101%", "-5%", "nan%",
                  "5percent")
        for value in values:
            self.refuse((f"'{value}'", "--tolerance", "0 to 1e+06", "0.01% to 100%"),
                        "render", "scene.glb", "-o", "picture.exr", f"--tolerance={value}")
        self.refuse_picture_option("--tolerance", ("5px", "1e7"), "--tolerance", "0 to 1e+06", "0.01% to 100%")

    def test_times(self):
        for value in ("0s", "-1s", "nan", "inf", "1h", "soon", "1 s", "1e999s"):
            self.refuse((f"'{value}'", "positive time such as 33ms"),
                        "render", "scene.glb", "-o", "picture.exr", "--time", value)
            self.refuse((f"'{value}'", "positive time such as 33ms"), "trade", "scene.glb", "--within", value)

    def test_points(self):
        points = ("1,2", "1,2,3,4", "1,2,x", "1;2;3", "0,nan,0", "0,0,inf")
        self.refuse_picture_option("--capture-point", points, "X,Y,Z in metres")


class BadRanges(BadOptions):
    def test_every_number_has_a_range_and_tells_it(self):
        """Found in the help, so that no option is forgotten."""
        arguments = {"render": ("scene.glb", "-o", "picture.exr"), "compare": ("scene.glb", "-o", "folder"),
                     "trade": ("scene.glb", "-o", "folder"),
                     "info": ("scene.glb",), "diff": ("a.png", "b.png"), "devices": ()}
        found = set()
        for name in SUBCOMMANDS:
            for line in self.succeed(name, "--help").stdout.splitlines():
                option = re.match(r" +(?:-\w,)?(--[\w-]+) (?:UINT|INT|FLOAT)\b(.*)", line)
                if not option:
                    continue
                bounds = re.search(r"in \[(\S+) - ([^]]+)\]", option[2])
                self.assertTrue(bounds, f"{name} {option[1]}: the help does not tell its range")
                found.add((name, option[1]))
                lowest, highest = map(float, bounds.groups())
                below, above = lowest - max(1.0, abs(lowest)), 2 * max(1.0, highest)
                for value in (f"{below:.0f}", f"{above:.0f}", "nan"):
                    self.refuse((option[1], value, " to ".join(bounds.groups())),
                                name, *arguments[name], option[1], value)
        self.assertGreaterEqual(found, {("render", "--spp"), ("render", "--noise"), ("compare", "--map-spp"),
                                        ("compare", "--fail-above"), ("diff", "--exposure")})


class BadWords(BadOptions):
    def test_no_or_unknown_subcommand(self):
        self.refuse(("subcommand is required",))
        self.refuse(("'paint'", *SUBCOMMANDS), "paint")

    def test_unknown_option(self):
        for name in SUBCOMMANDS:
            arguments = {"diff": ("scene.glb", "scene.glb"), "devices": ()}.get(name, ("scene.glb",))
            needed = ("-o", "picture.exr") if name == "render" else ()
            self.refuse(("--sharpness", "--help"), name, *arguments, *needed, "--sharpness")

    def test_missing_arguments(self):
        for name in ("compare", "render", "trade", "info"):
            self.refuse(("scene is required",), name)
        self.refuse(("test is required",), "diff", "a.png")
        self.refuse(("--output is required",), "render", "scene.glb")

    def test_names(self):
        self.refuse_picture_option("--light", ("candle",), "'candle'", "direct")
        self.refuse(("'magic'", "trace, polygon-map, sphere-map, cube-map, proxy-map, distance-map, planar, hybrid"),
                    "render", "scene.glb", "-o", "picture.exr", "--reflection", "magic")
        for methods in ("magic", "trace,magic", "direct/magic"):
            self.refuse(("magic'", "trace, polygon-map, sphere-map, cube-map, proxy-map, distance-map, planar, hybrid"),
                        "compare", "scene.glb", "--methods", methods)
            self.refuse(("magic'",), "trade", "scene.glb", "--methods", methods)
        self.refuse(("empty list",), "compare", "scene.glb", "--methods", "")
        self.refuse(("trace is listed twice",), "compare", "scene.glb", "--methods", "trace,hybrid,trace")
        self.refuse(("'smell'", "depth, position, normal"),
                    "render", "scene.glb", "-o", "picture.exr", "--aov", "depth,smell")
        self.refuse(("--metric", "psnr", "rel_mse"), "trade", "scene.glb", "--metric", "psnr")
        self.refuse(("--metric", "psnr", "rel_mse"), "diff", "a.png", "b.png", "--metric", "psnr")

    def test_polyhedra(self):
        self.refuse_picture_option("--polyhedron", ("sphere", "cube2", ""), "dodecahedron", "file of planes")

    def test_proxies(self):
        def refuse(text, *words):
            path = self.scratch / "proxy.txt"
            path.write_text(text, encoding="utf-8")
            for command in (("render", self.scene("office-lambert"), "-o", "picture.exr"),
                            ("compare", self.scene("office-lambert"), "-o", "folder")):
                self.fail_with(INPUT, ("read proxy", "proxy.txt", *words), *command, "--proxy", path)

        self.fail_with(INPUT, ("read proxy", "nowhere.txt", "cannot be opened"),
                       "render", self.scene("office-lambert"), "-o", "picture.exr", "--proxy", "nowhere.txt")
        box = "1 0 0 4\n-1 0 0 0\n0 1 0 3\n0 -1 0 0\n0 0 1 5\n"
        refuse(box + "0 0 -1\n", "line 6", "four numbers", "distance along it from the world's origin")
        refuse(box + "0 0 0 0\n", "line 6", "not zero")
        refuse("1 0 0 4\n", "1 planes", "a proxy has 4 to 32")
        refuse(box, "enclose nothing", "normals that point out of the proxy")
        refuse(box + "0 0 -1 -6\n", "enclose nothing")
        refuse(box + "0 0 -1 0\n1 0 0 9\n", "line 7", "bounds no face")

    def test_cameras(self):
        self.refuse_picture_option("--camera", ("1", "-1", "back"), "choose camera", "0: front")

    def test_output_names(self):
        for name in ("picture.jpg", "picture", "picture.exr.tmp", "."):
            self.refuse((f"'{name}'", ".exr or .png"), "render", "scene.glb", "-o", name)
        self.refuse(("'picture.png'", "only .exr files hold them"),
                    "render", "scene.glb", "-o", "picture.png", "--aov", "depth")
        self.refuse(("'map.exr'", ".png"), "diff", "a.png", "b.png", "-o", "map.exr")


if __name__ == "__main__":
    unittest.main()
