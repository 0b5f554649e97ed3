#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`utsuri devices`, `utsuri info` and the help texts."""
import re
import unittest

from cli_case import CliCase

SUBCOMMANDS = ("compare", "render", "info", "diff", "devices")
# Options without a default: they ask for something that else does not happen.
WITHOUT_DEFAULT = {"--help", "--quiet", "--json", "--fail-above", "--time", "--noise", "--aov", "--error-map",
                   "--within", "--error", "--predictions", "--kept-light"}
UNITS = {"--size": "pixels", "--exposure": "stops", "--capture-point": "metres", "--map-size": "Texels",
         "--map-spp": "per texel", "--spp": "per pixel", "--reference-spp": "per pixel", "--time": "500ms"}
# As counted by the scenes' own generators.
TRIANGLES = {"cornell": 38, "office-lambert": 3692, "spheres": 20494}


def option_entries(text):
    """The help of each option by its long name: its line with the lines that go on with it."""
    entries, name = {}, None
    for line in text.splitlines():
        start = re.match(r"  (?:-\w,)?(--[\w-]+)", line)
        if start:
            name = start.group(1)
            entries[name] = line
        elif name and line.startswith(" " * 10):
            entries[name] += " " + line.strip()
        else:
            name = None
    return entries


class Queries(CliCase):
    def test_devices(self):
        done = self.succeed("devices")
        values = self.json_of("devices")
        self.assertLess(values["chosen"], len(values["devices"]))
        for index, device in enumerate(values["devices"]):
            self.assertEqual(device["index"], index)
            self.assertIn(f"{index}: {device['name']} ({device['kind']})", done.stdout)
            self.assertRegex(device["api"], r"^1\.\d+\.\d+$")
            for name in ("driver", "memory_bytes", "storage_range_bytes", "subgroup_size"):
                self.assertTrue(device[name], name)
        chosen = values["devices"][values["chosen"]]
        self.assertEqual(chosen["missing"], [])
        by_name = self.json_of("devices", "--device", chosen["name"].upper())
        self.assertEqual(by_name["chosen"], values["chosen"])
        self.assertEqual(self.succeed("devices", "--quiet").stdout, "")

    def test_info_text(self):
        text = self.succeed("info", self.scene("office-lambert")).stdout
        for words in ("size [m]", "triangles                 3692 in", "0: camera", "emissive triangles",
                      "chrome ball", "mirror", "unbounded", "memory predicted at 512x384, maps of 256"):
            self.assertIn(words, text)

    def test_info_json(self):
        for name, triangles in TRIANGLES.items():
            values = self.json_of("info", self.scene(name))
            self.assertEqual(values["triangles"], triangles)
            self.assertEqual(values["cameras"], ["camera"])
            self.assertEqual(values["notes"] == [], name != "cornell")  # which has no normals
        self.assertEqual(values["requires"]["punctual_lights"], 2)

    def test_info_tells_what_is_required(self):
        cornell = self.json_of("info", self.scene("cornell"))["requires"]
        expected = {"emissive_triangles": 2, "punctual_lights": 0, "environment": False, "textures": False,
                    "glossy": False, "mirror": False, "reflective_instances": [], "specular_depth": 0}
        self.assertEqual(cornell, expected)
        office = self.json_of("info", self.scene("office-lambert"))["requires"]
        self.assertEqual(office["emissive_triangles"], 16)
        self.assertEqual(sorted(office["reflective_instances"]), ["chrome ball", "mirror"])
        self.assertIsNone(office["specular_depth"])

    def test_info_predicts_memory(self):
        small = self.json_of("info", self.scene("office-lambert"), "--size", "64x48")["predicted_bytes"]
        large = self.json_of("info", self.scene("office-lambert"), "--size", "640x480")["predicted_bytes"]
        self.assertEqual(large["film"], 100 * small["film"])
        self.assertEqual(large["drawing"], 100 * small["drawing"])
        self.assertEqual(large["scene"], small["scene"])
        self.assertGreater(small["light"], 0)
        self.assertEqual(large["light"], small["light"])
        tetrahedron = self.json_of("info", self.scene("office-lambert"), "--polyhedron", "tetrahedron")["predicted_bytes"]
        cube = self.json_of("info", self.scene("office-lambert"))["predicted_bytes"]
        film = 48 * 258 * 258  # of one map
        self.assertEqual((tetrahedron["polygon_maps"] - film) * 6, (cube["polygon_maps"] - film) * 4)
        coarse = self.json_of("info", self.scene("office-lambert"), "--map-size", "64")["predicted_bytes"]
        self.assertGreater(coarse["distances"], 0)
        self.assertGreater(cube["distances"], coarse["distances"])

    def test_info_predicts_no_maps_without_specular_lobes(self):
        predicted = self.json_of("info", self.scene("cornell"))["predicted_bytes"]
        self.assertEqual(predicted["polygon_maps"], 0)
        self.assertEqual(predicted["glossy_maps"], 0)
        self.assertEqual(predicted["distances"], 0)
        self.assertGreater(self.json_of("info", self.scene("office-lambert"))["predicted_bytes"]["glossy_maps"], 0)

    def test_version_and_help(self):
        self.assertRegex(self.succeed("--version").stdout, r"^utsuri \d+\.\d+\.\d+\n$")
        text = self.succeed("--help").stdout
        for words in (*SUBCOMMANDS, "Exit codes: 0 success", "130 interrupted", "UTSURI_DEVICE"):
            self.assertIn(words, text)

    def test_help_lists_defaults_and_units(self):
        for name in SUBCOMMANDS:
            text = self.succeed(name, "--help").stdout
            entries = option_entries(text)
            for common in ("--device", "--quiet", "--json"):
                self.assertIn(common, entries, name)
            for option, entry in entries.items():
                with self.subTest(subcommand=name, option=option):
                    has_default = re.search(r"=\S+|\[[^\]]+\]$|REQUIRED", entry) is not None
                    self.assertTrue(has_default or option in WITHOUT_DEFAULT, entry)
                    if option in UNITS:
                        self.assertIn(UNITS[option], entry)


if __name__ == "__main__":
    unittest.main()
