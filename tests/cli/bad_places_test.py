#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Outputs that cannot be written (exit code 3) and devices that cannot be used (exit code 4)."""
import pathlib
import sys
import unittest

import gltf_scene
from cli_case import DEVICE, INPUT, SMALL, CliCase

NO_DRIVER = {"VK_DRIVER_FILES": "/nonexistent", "VK_ICD_FILENAMES": "/nonexistent"}
# Nobody can create a file here, not even the superuser.
KERNEL_FOLDER = pathlib.Path("/proc")


class BadPlaces(CliCase):
    def setUp(self):
        super().setUp()
        (self.scratch / "scene.glb").write_bytes(gltf_scene.glb_bytes(*gltf_scene.mesh_document()))

    def refuse_picture(self, output, *words):
        with self.subTest(output=output):
            # So many samples would take hours: the place is tried before the work.
            self.fail_with(INPUT, words, "render", "scene.glb", "-o", output, "--spp", 2**24)

    def refuse_folder(self, folder, *words):
        with self.subTest(folder=folder):
            self.fail_with(INPUT, (folder, *words), "compare", "scene.glb", "-o", folder, "--spp", 2**24)

    def test_folder_that_is_missing(self):
        self.refuse_picture("nowhere/picture.exr", "'nowhere/picture.exr'", "create it or choose another")

    def test_folder_that_is_a_file(self):
        self.refuse_picture("scene.glb/picture.exr", "'scene.glb/picture.exr'", "'scene.glb' is not a folder")
        self.refuse_folder("scene.glb")
        self.refuse_folder("scene.glb/report")

    @unittest.skipUnless(KERNEL_FOLDER.is_dir(), "this system has no folder that refuses everybody")
    def test_folder_that_refuses(self):
        self.refuse_picture(str(KERNEL_FOLDER / "picture.exr"), f"'{KERNEL_FOLDER}'", "permission denied")
        self.refuse_folder(str(KERNEL_FOLDER / "report"))

    def test_picture_that_is_a_folder(self):
        (self.scratch / "taken.exr").mkdir()
        self.refuse_picture("taken.exr", "'taken.exr'", "expected a file name")

    def test_error_map_and_json(self):
        self.succeed("render", "scene.glb", "-o", "picture.png", *SMALL)
        self.fail_with(INPUT, ("nowhere/map.png", "nowhere"),
                       "diff", "picture.png", "picture.png", "-o", "nowhere/map.png")
        done = self.run_program("info", "scene.glb", "--quiet", "--json", "nowhere/info.json")
        self.assert_exit(done, INPUT)
        self.assertIn("nowhere/info.json", done.stderr)

    def test_no_driver(self):
        # With and without the validation layer: the loader fails at different points.
        for validation in ("0", "1"):
            environment = {**NO_DRIVER, "UTSURI_VALIDATION": validation}
            words = ("no Vulkan driver is installed", "mesa-vulkan-drivers")
            with self.subTest(validation=validation):
                self.fail_with(DEVICE, words, "devices", environment=environment)
                self.fail_with(DEVICE, words, "render", "scene.glb", "-o", "picture.exr",
                               environment=environment)
                self.fail_with(DEVICE, words, "compare", "scene.glb", "-o", "folder", environment=environment)

    @unittest.skipUnless(sys.platform == "linux", "other systems look for the loader elsewhere")
    def test_no_loader(self):
        # What the program finds first under the loader's names is none.
        for name in ("libvulkan.so", "libvulkan.so.1"):
            (self.scratch / name).write_text("no library")
        self.fail_with(DEVICE, ("connect to Vulkan", "loader cannot be loaded", "libvulkan1"), "devices",
                       environment={"LD_LIBRARY_PATH": str(self.scratch)})

    def test_scenes_and_pictures_need_no_device(self):
        self.succeed("render", "scene.glb", "-o", "picture.png", *SMALL)
        self.succeed("info", "scene.glb", environment=NO_DRIVER)
        self.succeed("diff", "picture.png", "picture.png", environment=NO_DRIVER)

    def test_unknown_device(self):
        listed = self.json_of("devices")["devices"][0]["name"]
        for device in ("no such device", "99"):
            with self.subTest(device=device):
                words = (f"'{device}'", "give an index or a part of one name", listed)
                self.fail_with(DEVICE, words, "devices", "--device", device)
                self.fail_with(DEVICE, words, "render", "scene.glb", "-o", "picture.exr", "--device", device)
                self.fail_with(DEVICE, words, "compare", "scene.glb", "-o", "folder", "--device", device)
                self.fail_with(DEVICE, words, "devices", environment={"UTSURI_DEVICE": device})


if __name__ == "__main__":
    unittest.main()
