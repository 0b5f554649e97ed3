#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Rooms that chance furnished look the same drawn by hybrid, and lit from the light kept on surfaces, as they do traced.

UTSURI_RANDOM_SEEDS chooses the rooms, such as "1-10"; each takes one to three minutes.
"""
import math
import os
import subprocess
import sys
import unittest

import picture_file
from cli_case import TIMEOUT_SECONDS, CliCase

DEFAULT_SEEDS = "4"  # luminous plates, and a tube in its housing: light kept there was wrong once
WIDTH, HEIGHT, BLOCK = 128, 96, 32
# Bounds on errors of means over blocks of pixels and over the picture, as shares of the latter.
MOST_BLOCK_ERROR, MOST_ERROR = 0.03, 0.01
DEVIATIONS = 4.5  # of the noise, by which means may differ further: that happens by chance in one of 1e5
REFERENCE_SAMPLES, SAMPLES = 128, 16


class Pair:
    """Two pictures that differ in their seeds: their mean and what of it is noise."""

    def __init__(self, pictures):
        self.pictures = [[[sum(pixel) / 3 for pixel in row] for row in rows] for _, _, rows in pictures]

    def over(self, pixels):
        """The mean over some pixels, and its standard error: pixels' errors are independent."""
        first, second = ([picture[y][x] for x, y in pixels] for picture in self.pictures)
        squares = sum((a - b) ** 2 for a, b in zip(first, second))
        return (sum(first) + sum(second)) / (2 * len(pixels)), math.sqrt(squares) / (2 * len(pixels))


def block_at(left, top, width=BLOCK, height=BLOCK):
    return [(x, y) for y in range(top, top + height) for x in range(left, left + width)]


class RandomScenes(CliCase):
    def pair(self, scene, samples, *options):
        pictures = []
        for seed in ("1", "2"):
            path = self.scratch / "picture.exr"
            self.succeed("render", scene, "-o", path, "--size", f"{WIDTH}x{HEIGHT}", "--spp", str(samples // 2),
                         "--seed", seed, *options)
            pictures.append(picture_file.read_exr(path))
        return Pair(pictures)

    def expect_equal(self, pair, reference):
        whole, _ = reference.over(block_at(0, 0, WIDTH, HEIGHT))
        self.assertGreater(whole, 0.0)
        places = [(f"the block at {left}, {top}", block_at(left, top), MOST_BLOCK_ERROR)
                  for top in range(0, HEIGHT, BLOCK) for left in range(0, WIDTH, BLOCK)]
        for name, pixels, most in [*places, ("the whole", block_at(0, 0, WIDTH, HEIGHT), MOST_ERROR)]:
            mean, noise = pair.over(pixels)
            expected, reference_noise = reference.over(pixels)
            with self.subTest(place=name):
                allowed = most * whole + DEVIATIONS * math.hypot(noise, reference_noise)
                self.assertLessEqual(abs(mean - expected), allowed, f"{mean / whole} instead of {expected / whole} wholes")

    def look_the_same(self, seed):
        scene = self.scratch / "room.glb"
        subprocess.run([sys.executable, self.scenes / "random/generate.py", "--seed", str(seed), "--out", scene], check=True,
                       timeout=TIMEOUT_SECONDS)
        traced = self.pair(scene, REFERENCE_SAMPLES, "--reflection", "trace")
        for name, samples, options in (("hybrid", SAMPLES, ("--reflection", "hybrid")),
                                       ("kept light", 2 * SAMPLES, ("--reflection", "trace", "--kept-light"))):
            with self.subTest(method=name):
                self.expect_equal(self.pair(scene, samples, *options), traced)


def chosen_seeds():
    first, _, last = os.environ.get("UTSURI_RANDOM_SEEDS", DEFAULT_SEEDS).partition("-")
    return range(int(first), int(last or first) + 1)


for chosen in chosen_seeds():
    setattr(RandomScenes, f"test_seed_{chosen}", lambda self, seed=chosen: self.look_the_same(seed))


if __name__ == "__main__":
    unittest.main()
