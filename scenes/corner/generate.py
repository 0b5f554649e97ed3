#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The corner of a room where things touch: boxes, leaning boards, a thin partition, a hut of thin walls."""

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
from placing import Stage, lean, room, skirting  # noqa: E402
from shapes import Patch  # noqa: E402
from solids import ball, bar, rounded_box, smoothed  # noqa: E402

HALF_X, HEIGHT, HALF_Z = 1.7, 2.5, 1.6      # the room; the corner is at -x, -z
# The whole scene stands askew: neither walls nor floor are parallel to an axis of the world.
ASKEW_AXIS, ASKEW_DEGREES = (0.25, 1.0, 0.15), 37.0
CAMERA, TARGET, VERTICAL_FOV = (1.30, 1.45, 1.42), (-0.55, 0.72, -0.85), 58.0
HUT_WIDTH, HUT_DEPTH, HUT_HEIGHT, HUT_PITCH, HUT_WALL = 0.62, 0.70, 0.36, 32.0, 0.010
DOOR_WIDTH, DOOR_HEIGHT = 0.22, 0.26


def wall_face(points, thickness):
    """A flat wall: the polygon at z = 0, seen from +z, and the same `thickness` behind; edges are left open."""
    patch = Patch()
    patch.polygon([(x, y, 0.0) for x, y in points], [(x, -y) for x, y in points])
    patch.polygon([(x, y, -thickness) for x, y in points[::-1]], [(x, -y) for x, y in points[::-1]])
    return patch


def gable(door):
    """The end wall of the hut; with `door` there is a way in."""
    half, rise = HUT_WIDTH / 2, HUT_WIDTH / 2 * math.tan(math.radians(HUT_PITCH))
    roof = [(half, HUT_HEIGHT), (0.0, HUT_HEIGHT + rise), (-half, HUT_HEIGHT)]
    if not door:
        return wall_face([(-half, 0.0), (half, 0.0), *roof], HUT_WALL)
    w, h, t = DOOR_WIDTH / 2, DOOR_HEIGHT, HUT_WALL
    wall = wall_face([(-half, 0.0), (-w, 0.0), (-w, h), (-half, h)], t)
    wall.add(wall_face([(w, 0.0), (half, 0.0), (half, h), (w, h)], t))
    # From the top, so that the corners of the door are corners of this part, too.
    wall.add(wall_face([roof[1], roof[2], (-half, h), (-w, h), (w, h), (half, h), roof[0]], t))
    for a, b in (((-w, 0.0), (-w, h)), ((-w, h), (w, h)), ((w, h), (w, 0.0))):
        wall.polygon([(*a, -t), (*b, -t), (*b, 0.0), (*a, 0.0)], [(0, 0), (1, 0), (1, t), (0, t)])
    return wall


def hut(stage):
    """Walls and roof 1 cm thick; dark inside but for what falls through the door."""
    half, deep = HUT_WIDTH / 2, HUT_DEPTH / 2
    walls = gable(True).moved(0, 0, deep)
    walls.add(gable(False).turned("y", 180).moved(0, 0, -deep))
    side = wall_face([(-deep, 0.0), (deep, 0.0), (deep, HUT_HEIGHT), (-deep, HUT_HEIGHT)], HUT_WALL)
    walls.add(side.turned("y", 90).moved(half, 0, 0), side.turned("y", -90).moved(-half, 0, 0))
    pitch = math.radians(HUT_PITCH)
    over, lift = 0.06, HUT_WALL / math.cos(pitch)
    ridge = HUT_HEIGHT + half * math.tan(pitch)
    eave = (half + over, HUT_HEIGHT - over * math.tan(pitch))
    roof = Patch()
    for side in (1, -1):
        outline = [(side * eave[0], eave[1]), (side * eave[0], eave[1] + lift), (0.0, ridge + lift), (0.0, ridge)]
        outline = outline if side > 0 else outline[::-1]
        z = deep + over
        roof.polygon([(x, y, z) for x, y in outline], [(x, -y) for x, y in outline])
        roof.polygon([(x, y, -z) for x, y in outline[::-1]], [(x, -y) for x, y in outline[::-1]])
        for (xa, ya), (xb, yb) in zip(outline, outline[1:] + outline[:1]):
            if xa or xb:
                roof.polygon([(xa, ya, z), (xa, ya, -z), (xb, yb, -z), (xb, yb, z)],
                             [(0, z), (0, -z), (1, -z), (1, z)])
    return stage.scene.mesh("hut", [(stage.paint["teal wall"], smoothed(walls)),
                                    (stage.paint["enamel red"], smoothed(roof))])


def add_room(stage):
    looks = {"floor": "dull floor", "ceiling": "ceiling", "back": "plaster", "right": "plum wall",
             "front": "sand wall", "left": "plaster"}
    room(stage, HALF_X, HEIGHT, HALF_Z, looks, 1.6)
    skirting(stage, "skirting", HALF_X, HALF_Z, ("right", "front"))
    scene, paint = stage.scene, stage.paint
    stage.put("panel", lamps.panel_lamp(scene, paint, "panel", "aluminium", "panel", 0.9, 0.3), 0.25, HEIGHT, -0.2, 12)
    stage.put("tube", lamps.tube_lamp(scene, paint, "tube", "white", "tube", 0.9), -0.35, HEIGHT, 1.0, -20)
    stage.put("sconce", lamps.wall_lamp(scene, paint, "sconce", "brass", "shade cloth", "small bulb"),
                -HALF_X, 1.55, 0.35, 90)


def add_boxes(stage):
    """A carton in the very corner, one on it, one that leans, balls in the gaps."""
    scene, paint = stage.scene, stage.paint
    x, z = -HALF_X, -HALF_Z
    big = scene.mesh("carton", [(paint["carton"], rounded_box(0.52, 0.42, 0.46, 0.006, 2))])
    stage.put("carton", big, x + 0.26, 0, z + 0.23)
    small = scene.mesh("small carton", [(paint["carton"], rounded_box(0.34, 0.24, 0.28, 0.005, 1))])
    stage.put("carton on it", small, x + 0.28, 0.42, z + 0.22, 21)
    crate = scene.mesh("crate", [(paint["wood"], rounded_box(0.36, 0.30, 0.30, 0.004, 1, grain=0.5))])
    stage.put("crate", crate, x + 0.36, 0, z + 0.78, 28)
    board = scene.mesh("board", [(paint["walnut"], rounded_box(0.24, 1.75, 0.02, 0.003, 1, grain=0.8))])
    y, away = lean(1.75, 0.02, 13, 0.003)
    stage.put("board on the left wall", board, x + away, y, z + 1.12, 90, ((1, 0, 0), -13))
    rod = scene.mesh("rod", [(paint["brass"], bar((0, 0, 0), (0, 2.0, 0), 0.006, 12))])
    y, away = lean(2.0, 0.012, 7)
    stage.put("rod on the back wall", rod, x + 0.64, y, z + away, 0, ((1, 0, 0), -7))
    for name, glaze, radius, place in (("red ball", "red glaze", 0.11, (x + 0.11, z + 0.57)),
                                       ("blue ball", "blue glaze", 0.075, (x + 0.68, z + 1.02))):
        mesh = scene.mesh(name, [(paint[glaze], ball(radius))])
        stage.put(name, mesh, place[0], radius, place[1])


def add_desk(stage):
    """Against the back wall, with a mirror and a picture above it."""
    scene, paint = stage.scene, stage.paint
    x, top, rear = 0.45, 0.74, -HALF_Z
    stage.put("desk", fittings.table(scene, paint, "desk", "wood", "black steel", 1.3, 0.6), x, 0, rear + 0.3)
    stage.put("laptop", fittings.laptop(scene, paint, "laptop", "aluminium", "keys", "dashboard"),
                x - 0.05, top, rear + 0.28, -12)
    stage.put("cup", things.cup(scene, paint, "cup", "porcelain", "coffee"), x + 0.30, top, rear + 0.38, -50)
    stage.put("desk lamp", lamps.desk_lamp(scene, paint, "desk lamp", "black steel", "enamel green", "small bulb"),
                x - 0.50, top, rear + 0.20, 4)
    volume = things.book(scene, paint, "book", "red book", "paper", (0.034, 0.24, 0.17))
    y, away = lean(0.24, 0.034, 16)
    stage.put("book on the wall", volume, x + 0.52, top + y, rear + away, 90, ((0, 0, 1), -16))
    thin = things.book(scene, paint, "thin book", "blue book", "paper", (0.022, 0.21, 0.15))
    stage.put("book that lies", thin, x + 0.44, top + 0.011, rear + 0.42, 24, ((0, 0, 1), 90))
    mirror = things.framed(scene, paint, "mirror", "walnut", "mirror", 0.62, 0.78)
    stage.put("mirror on the wall", mirror, x - 0.02, 1.48, rear)
    picture = things.framed(scene, paint, "picture", "black steel", "abstract", 0.40, 0.40, 0.5)
    stage.put("picture, hung askew", picture, -HALF_X, 1.62, -0.85, 90, ((0, 0, 1), 2.5))
    drop = [(x - 0.50, top + 0.004, rear + 0.07), (x - 0.52, top + 0.006, rear + 0.02), (x - 0.60, 0.72, rear + 0.006),
            (x - 0.68, 0.35, rear + 0.010), (x - 0.70, 0.06, rear + 0.03), (x - 0.64, 0.004, rear + 0.14),
            (x - 0.50, 0.004, rear + 0.18)]
    stage.put("cable", things.cable(scene, paint, "cable", "black rubber", drop), 0, 0, 0)


def add_floor_objects(stage):
    scene, paint = stage.scene, stage.paint
    screen = fittings.partition(scene, paint, "partition", "grey fabric", "black steel", 0.95, 1.15)
    stage.put("partition", screen, -1.13, 0, 0.62, -24)
    stage.put("hut", hut(stage), 0.10, 0, -0.18, 33)
    lone = scene.mesh("ball in the hut", [(paint["yellow plastic"], ball(0.07, 20, 10))])
    stage.put("ball in the hut", lone, 0.12, 0.07, -0.30)
    stage.put("stool", seats.stool(scene, paint, "stool", "wood", "steel"), 1.02, 0, -0.42, 15)
    stage.put("vase", things.vase(scene, paint, "vase", "green glaze", [
        (0.045, 0.0), (0.075, 0.05), (0.085, 0.11), (0.055, 0.19), (0.032, 0.235), (0.046, 0.27)]),
        1.02, 0.609, -0.42)


def build():
    stage = Stage("Corner")
    stage.root = stage.scene.node("corner", rotation=glb.turn(ASKEW_AXIS, ASKEW_DEGREES))
    for add in (add_room, add_boxes, add_desk, add_floor_objects):
        add(stage)
    stage.look(CAMERA, TARGET, VERTICAL_FOV)
    return stage.scene


if __name__ == "__main__":
    glb.generator_main(build, HERE / "corner.glb")
