#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A room in which every surface is a default dielectric, from a perfect polish to fully rough, and nothing is metal."""

import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import fittings  # noqa: E402
import glb  # noqa: E402
import lamps  # noqa: E402
import seats  # noqa: E402
import things  # noqa: E402
from placing import Stage, room, skirting  # noqa: E402
from solids import ball, rounded_box, torus  # noqa: E402

HALF_X, HEIGHT, HALF_Z = 1.9, 2.6, 1.8
CAMERA, TARGET, VERTICAL_FOV = (1.42, 1.48, 1.62), (-0.32, 0.72, -0.72), 55.0
# Linear base colour and roughness. "default" is what a modeller leaves.
PLAIN = {
    "default": ((0.80, 0.80, 0.80), 0.5), "floor": ((0.34, 0.20, 0.11), 0.25), "blue wall": ((0.16, 0.30, 0.46), 0.5),
    "ceiling": ((0.80, 0.80, 0.80), 0.5), "polished black": ((0.015, 0.015, 0.018), 0.0), "ivory": ((0.75, 0.66, 0.48), 0.1),
    "orange": ((0.80, 0.30, 0.04), 0.3), "sage": ((0.32, 0.42, 0.26), 0.5), "brown": ((0.16, 0.08, 0.04), 0.4),
    "clay": ((0.50, 0.24, 0.15), 1.0), "linen": ((0.62, 0.58, 0.50), 0.75), "billiard red": ((0.45, 0.02, 0.02), 0.0),
}
ROUGHNESS_ROW = (0.0, 0.1, 0.25, 0.5, 0.75, 1.0)
ROW_RADIUS, ROW_STEP = 0.095, 0.225
SEED = 1927


def add_room(stage):
    scene, paint = stage.scene, stage.paint
    looks = {"floor": "floor", "ceiling": "ceiling", "back": "default", "right": "default", "front": "sage",
             "left": "blue wall"}
    room(stage, HALF_X, HEIGHT, HALF_Z, looks)
    skirting(stage, "default", HALF_X, HALF_Z)
    panel = lamps.panel_lamp(scene, paint, "panel", "default", "panel", 1.2, 0.4)
    stage.put("panel", panel, 0.15, HEIGHT, -0.25, 8)
    stage.put("floor lamp", lamps.floor_lamp(scene, paint, "floor lamp", "brown", "linen", "bulb"), -1.55, 0, -1.45)
    stage.put("window", things.framed(scene, paint, "window", "default", "window", 1.0, 1.2), HALF_X, 1.5, 0.2, -90)
    stage.put("picture", things.framed(scene, paint, "picture", "brown", "abstract", 0.7, 0.7), -HALF_X, 1.55, -0.35, 90)
    stage.put("clock", things.wall_clock(scene, paint, "clock", "orange", "dial", "brown"), -0.62, 1.95, -HALF_Z)


def add_row(stage):
    """A sideboard against the back wall; on it balls that differ by their roughness alone."""
    scene, paint = stage.scene, stage.paint
    body = fittings.cabinet(scene, paint, "sideboard", "brown", "default", "ivory", 1.6, 0.62, 0.42)
    x, z, top = 0.55, -HALF_Z + 0.225, 0.62
    stage.put("sideboard", body, x, 0, z)
    for k, roughness in enumerate(ROUGHNESS_ROW):
        name = f"roughness {roughness}"
        paint.plain(name, (0.10, 0.32, 0.30), roughness)
        mesh = scene.mesh(name, [(paint[name], ball(ROW_RADIUS))])
        stage.put(name, mesh, x + (k - 2.5) * ROW_STEP, top + ROW_RADIUS, z + 0.04)
    stage.put("tall vase", things.vase(scene, paint, "tall vase", "ivory", [
        (0.05, 0.0), (0.075, 0.06), (0.08, 0.14), (0.045, 0.26), (0.030, 0.33), (0.05, 0.39)]), x + 0.70, top, z - 0.12)


def add_furniture(stage):
    scene, paint = stage.scene, stage.paint
    stage.put("armchair", seats.sofa(scene, paint, "armchair", "sage", "brown", 1.0, 1), -1.16, 0, -0.82, 52)
    table = fittings.round_table(scene, paint, "round table", "polished black", "default")
    stage.put("round table", table, -0.26, 0, -0.52, 10)
    stage.put("bowl", things.bowl(scene, paint, "bowl", "ivory", 0.13), -0.33, 0.46, -0.60)
    stage.put("cup", things.cup(scene, paint, "cup", "orange", "coffee"), -0.13, 0.46, -0.36, -60)
    book = things.book(scene, paint, "book", "blue book", "paper", (0.024, 0.22, 0.15))
    stage.put("book", book, -0.42, 0.46 + 0.012, -0.38, 30, ((0, 0, 1), 90))
    plant = things.potted_plant(scene, paint, "plant", "clay", "soil", "leaf", stage.draw)
    stage.put("plant", plant, 1.34, 0, -0.98)


def add_floor_objects(stage):
    """Smooth things that touch the floor, and the floor shows them."""
    scene, paint = stage.scene, stage.paint
    for name, look, radius, x, z in (("large ball", "billiard red", 0.24, 0.40, -0.30),
                                     ("small ball", "ivory", 0.10, 0.83, 0.12)):
        stage.put(name, scene.mesh(name, [(paint[look], ball(radius, 36, 18))]), x, radius, z)
    stage.put("ring", scene.mesh("ring", [(paint["orange"], torus(0.17, 0.045))]), -0.32, 0.045, 0.38)
    block = scene.mesh("block", [(paint["default"], rounded_box(0.26, 0.26, 0.26, 0.05, 3))])
    stage.put("block", block, -0.98, 0, 0.25, 24)
    rug = scene.mesh("rug", [(paint["linen"], rounded_box(1.3, 0.010, 0.9, 0.0045))])
    stage.put("rug", rug, -0.25, 0.0, 1.15, -8)


def build():
    stage = Stage("Dielectric", SEED)
    for name, (colour, roughness) in PLAIN.items():
        stage.paint.plain(name, colour, roughness)
    for add in (add_room, add_row, add_furniture, add_floor_objects):
        add(stage)
    stage.look(CAMERA, TARGET, VERTICAL_FOV)
    return stage.scene


if __name__ == "__main__":
    glb.generator_main(build, HERE / "dielectric.glb")
