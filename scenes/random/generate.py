#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A room of random size that stands askew, with random furniture, walls, lamps and materials: nobody arranged it."""

import argparse
import math
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import fittings  # noqa: E402
import glb  # noqa: E402
import lamps  # noqa: E402
import seats  # noqa: E402
import things  # noqa: E402
from paints import METAL, PICTURES, PLASTIC  # noqa: E402
from placing import Stage, lean, room, skirting  # noqa: E402
from solids import ball, rounded_box, torus  # noqa: E402

DEFAULT_SEED = 1
CELL = 0.95                     # metres of floor for each piece of furniture
FILLED = 0.7                    # share of the cells that get one
WOODS = ("wood", "walnut", "oak floor", "black steel", "white")
FABRICS = ("grey fabric", "mustard fabric", "rust fabric", "teal fabric", "towel")
WALLS = ("plaster", "warm plaster", "plum wall", "teal wall", "sand wall", "tiles", "white")
FLOORS = ("oak floor", "dull floor", "dark tiles", "stone", "grey carpet", "tiles")
LOOKS = ("worn metal", "brushed metal", "rusted metal", "stone", "wood", "tiles")
PROFILE = [(0.05, 0.0), (0.075, 0.06), (0.08, 0.14), (0.045, 0.26), (0.030, 0.33), (0.05, 0.39)]


class Draw:
    """Random choices for one scene."""

    def __init__(self, stage):
        self.stage = stage
        self.count = 0

    def share(self):
        return self.stage.draw()

    def between(self, low, high):
        return low + (high - low) * self.stage.draw()

    def one_of(self, choices):
        return choices[int(len(choices) * self.stage.draw())]

    def name(self, kind):
        self.count += 1
        return f"{kind} {self.count}"

    def finish(self):
        """A material for a thing: one that has a name, or a random one, a quarter of them metal."""
        if self.share() < 0.5:
            return self.one_of((*PLASTIC, *METAL, *LOOKS))
        name = self.name("material")
        roughness = self.one_of((0.0, 0.05, 0.1, 0.2, 0.3, 0.5, 0.5, 0.5, 0.7, 1.0))
        metallic = 1.0 if self.share() < 0.25 else 0.0
        self.stage.paint.plain(name, tuple(0.03 + 0.85 * self.share() for _ in range(3)), roughness, metallic)
        return name


def small_thing(stage, draw):
    """Something that stands on a table: its mesh, and how high its origin lies above what it stands on."""
    scene, paint = stage.scene, stage.paint
    radius = draw.between(0.04, 0.10)
    makers = {
        "cup": lambda n: (things.cup(scene, paint, n, draw.finish(), "coffee"), 0.0),
        "bowl": lambda n: (things.bowl(scene, paint, n, draw.finish(), radius + 0.03), 0.0),
        "vase": lambda n: (things.vase(scene, paint, n, draw.finish(), PROFILE), 0.0),
        "ball": lambda n: (scene.mesh(n, [(paint[draw.finish()], ball(radius))]), radius),
        "table lamp": lambda n: (lamps.table_lamp(scene, paint, n, draw.finish(), "shade cloth", "bulb"), 0.0),
        "screen": lambda n: (fittings.screen(scene, paint, n, "graphite", draw.one_of(("dashboard", "document"))), 0.0),
        "laptop": lambda n: (fittings.laptop(scene, paint, n, draw.finish(), "keys", "document"), 0.0),
    }
    kind = draw.one_of(tuple(makers))
    name = draw.name(kind)
    return (name, *makers[kind](name))


def put_on(stage, draw, x, z, top, reach):
    for side in (-1, 1):
        name, mesh, lift = small_thing(stage, draw)
        stage.put(name, mesh, x + side * reach * draw.between(0.3, 0.9), top + lift, z + reach * draw.between(-0.4, 0.4),
                  360 * draw.share())


def add_piece(stage, draw, x, z):
    """A piece of furniture, or a thing, on the floor."""
    scene, paint = stage.scene, stage.paint
    yaw = 360 * draw.share()
    size = draw.between(0.12, 0.32)
    makers = {
        "office chair": lambda n: seats.office_chair(scene, paint, n, draw.one_of(FABRICS), "graphite", draw.finish()),
        "chair": lambda n: seats.tube_chair(scene, paint, n, draw.one_of(FABRICS), draw.finish()),
        "armchair": lambda n: seats.sofa(scene, paint, n, draw.one_of(FABRICS), draw.one_of(WOODS), 0.9, 1),
        "stool": lambda n: seats.stool(scene, paint, n, draw.one_of(WOODS), draw.finish()),
        "table": lambda n: fittings.table(scene, paint, n, draw.one_of(WOODS), draw.finish(), 0.9, 0.6),
        "round table": lambda n: fittings.round_table(scene, paint, n, draw.finish(), draw.finish()),
        "cabinet": lambda n: fittings.cabinet(scene, paint, n, draw.one_of(WOODS), draw.finish(), "steel", 0.9, 0.55, 0.4),
        "partition": lambda n: fittings.partition(scene, paint, n, draw.one_of(FABRICS), "black steel", 0.8, 1.2),
        "plant": lambda n: things.potted_plant(scene, paint, n, draw.finish(), "soil", "leaf", stage.draw),
        "floor lamp": lambda n: lamps.floor_lamp(scene, paint, n, draw.finish(), "shade cloth", "bulb"),
        "block": lambda n: scene.mesh(n, [(paint[draw.finish()], rounded_box(size, 2 * size, size, 0.02, 2))]),
        "ball": lambda n: scene.mesh(n, [(paint[draw.finish()], ball(size, 36, 18))]),
        "ring": lambda n: scene.mesh(n, [(paint[draw.finish()], torus(size, size / 4))]),
    }
    kind = draw.one_of(tuple(makers))
    name = draw.name(kind)
    lift = {"ball": size, "ring": size / 4}.get(kind, 0.0)
    stage.put(name, makers[kind](name), x, lift, z, yaw)
    if kind in ("table", "cabinet", "round table"):
        put_on(stage, draw, x, z, {"table": 0.74, "cabinet": 0.55, "round table": 0.46}[kind], 0.25)


def add_walls(stage, draw, half_x, height, half_z):
    """Something on each wall, flush with it; a board that leans on one."""
    scene, paint = stage.scene, stage.paint
    for turn, away, along in ((0, half_z, half_x), (90, half_x, half_z), (180, half_z, half_x), (-90, half_x, half_z)):
        side, up = draw.between(-0.5, 0.5) * along, draw.between(1.2, 1.6)
        content = draw.one_of(("mirror", "gold mirror", "window", *PICTURES))
        name = draw.name("framed")
        mesh = things.framed(scene, paint, name, draw.one_of(WOODS), content, draw.between(0.4, 1.0), draw.between(0.4, 0.9))
        c, s = math.cos(math.radians(turn)), math.sin(math.radians(turn))
        stage.put(name, mesh, side * c - away * s, up, -side * s - away * c, turn)
    board = scene.mesh("board", [(paint[draw.one_of(WOODS)], rounded_box(0.24, 1.6, 0.02, 0.003, 1, grain=0.8))])
    y, out = lean(1.6, 0.02, 12, 0.003)
    stage.put("board", board, draw.between(-0.8, 0.8) * half_x, y, -half_z + out, 0, ((1, 0, 0), -12))


def add_lamps(stage, draw, half_x, height, half_z):
    """Two to four at the ceiling and the walls: no room is dark."""
    scene, paint = stage.scene, stage.paint
    for _ in range(2 + int(3 * draw.share())):
        x, z = draw.between(-0.7, 0.7) * half_x, draw.between(-0.7, 0.7) * half_z
        kind = draw.one_of(("panel", "tube", "pendant", "sconce"))
        name, yaw = draw.name(kind), 360 * draw.share()
        if kind == "panel":
            mesh = lamps.panel_lamp(scene, paint, name, draw.finish(), "panel", draw.between(0.4, 1.0), 0.3)
            stage.put(name, mesh, x, height, z, yaw)
        elif kind == "tube":
            stage.put(name, lamps.tube_lamp(scene, paint, name, "white", "tube", 0.9), x, height, z, yaw)
        elif kind == "pendant":
            mesh = lamps.pendant_lamp(scene, paint, name, draw.finish(), "black rubber", draw.finish(), "bulb", 0.5)
            stage.put(name, mesh, x, height, z, yaw)
        else:
            mesh = lamps.wall_lamp(scene, paint, name, draw.finish(), "shade cloth", "small bulb")
            stage.put(name, mesh, -half_x, 1.7, z, 90)


def build(seed=DEFAULT_SEED):
    stage = Stage(f"Random room {seed}", seed)
    draw = Draw(stage)
    half_x, height, half_z = draw.between(1.4, 2.6), draw.between(2.3, 3.2), draw.between(1.4, 2.6)
    axis = (draw.between(-1, 1), draw.between(0.2, 1), draw.between(-1, 1))
    stage.root = stage.scene.node("room askew", rotation=glb.turn(axis, 360 * draw.share()))
    looks = {wall: draw.one_of(WALLS) for wall in ("back", "right", "front", "left")}
    room(stage, half_x, height, half_z, {"floor": draw.one_of(FLOORS), "ceiling": "ceiling", **looks}, 1.6)
    skirting(stage, draw.finish(), half_x, half_z)
    add_walls(stage, draw, half_x, height, half_z)
    add_lamps(stage, draw, half_x, height, half_z)
    columns, rows = int(2 * half_x / CELL), int(2 * half_z / CELL)
    for i in range(columns):
        for j in range(rows):
            near_eye = i >= columns - 1 and j >= rows - 1
            if draw.share() < FILLED and not near_eye:
                add_piece(stage, draw, (i + 0.5 - columns / 2) * CELL, (j + 0.5 - rows / 2) * CELL)
    stage.look((half_x - 0.25, draw.between(1.2, 2.0), half_z - 0.25),
               (draw.between(-0.5, 0.1) * half_x, draw.between(0.5, 1.0), draw.between(-0.5, 0.1) * half_z),
               draw.between(50, 75))
    return stage.scene


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=pathlib.Path, required=True, help="file to write")
    parser.add_argument("--seed", type=int, default=DEFAULT_SEED, help="another seed makes another room (default: %(default)s)")
    arguments = parser.parse_args()
    arguments.out.write_bytes(build(arguments.seed).encode())


if __name__ == "__main__":
    main()
