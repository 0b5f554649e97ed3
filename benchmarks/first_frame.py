#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Time from process start to the first finished frame, and the share of pipeline compilation.

Usage: first_frame.py PROGRAM SCENE [--runs N] [--json FILE]

Each run is a process of its own that renders one sample per pixel at 512x384. Runs are made with the driver's cache of
compiled kernels switched off (the first run a user sees) and on (every later run). Medians are printed.
"""
import argparse
import json
import os
import statistics
import subprocess
import tempfile
import time


def run_once(program, scene, folder, reflection, cached):
    environment = dict(os.environ)
    if not cached:
        # Mesa's and NVIDIA's switches; other drivers ignore them.
        environment["MESA_SHADER_CACHE_DISABLE"] = "true"
        environment["__GL_SHADER_DISK_CACHE"] = "0"
    start = time.perf_counter()
    result = subprocess.run(
        [program, "render", scene, "-o", os.path.join(folder, "frame.png"), "--spp", "1", "--reflection", reflection,
         "--map-spp", "1", "--json", "-"],
        env=environment, check=True, capture_output=True)
    wall = time.perf_counter() - start
    report = json.loads(result.stdout)
    return {"wall_seconds": wall, "first_frame_seconds": report["first_frame_seconds"],
            "compile_seconds": report["compile_seconds"], "prepare_seconds": report["prepare_seconds"],
            "frame_seconds": report["frame_seconds"]}


def measure(program, scene, folder, reflection, cached, runs):
    if cached:
        run_once(program, scene, folder, reflection, cached)
    rows = [run_once(program, scene, folder, reflection, cached) for _ in range(runs)]
    return {key: statistics.median(row[key] for row in rows) for key in rows[0]}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("scene")
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--json")
    arguments = parser.parse_args()
    report = {}
    with tempfile.TemporaryDirectory() as folder:
        for reflection in ("trace", "polygon-map"):
            for cached in (False, True):
                name = f"direct/{reflection}, kernels {'cached' if cached else 'compiled'}"
                figures = measure(arguments.program, arguments.scene, folder, reflection, cached, arguments.runs)
                report[name] = figures
                share = 100 * figures["compile_seconds"] / figures["first_frame_seconds"]
                print(f"{name}: first frame after {figures['first_frame_seconds']:.2f} s, of that compilation "
                      f"{figures['compile_seconds']:.2f} s ({share:.0f} %), maps {figures['prepare_seconds']:.2f} s, "
                      f"frame {figures['frame_seconds']:.2f} s; whole process {figures['wall_seconds']:.2f} s")
    if arguments.json:
        with open(arguments.json, "w", encoding="utf-8") as file:
            json.dump(report, file, indent=2)
            file.write("\n")


if __name__ == "__main__":
    main()
