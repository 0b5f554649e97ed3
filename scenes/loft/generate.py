#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A loft of about 20,000 triangles: textured, lacquered boards, a mirror on a wall of 8 m, one that leans askew."""

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
from shapes import Patch, box  # noqa: E402
from solids import ball, rounded_box  # noqa: E402

HALF_X, HEIGHT, HALF_Z = 4.0, 3.1, 2.5
CAMERA, TARGET, VERTICAL_FOV = (3.45, 1.62, 2.10), (-0.95, 0.92, -1.20), 55.0
TABLE = (-0.55, 1.05, 7.0)              # x, z, degrees
CHAIRS = ((-0.40, -0.56, 4), (0.42, -0.60, -9), (-0.36, 0.60, 172), (0.45, 0.55, 190))
PARTITION = (-3.02, 1.62, 100.0)
BALL_RADIUS = 0.27
SEED = 2019


def add_room(stage):
    scene, paint = stage.scene, stage.paint
    looks = {"floor": "oak floor", "ceiling": "ceiling", "back": "plaster", "right": "warm plaster",
             "front": "teal wall", "left": "plaster"}
    room(stage, HALF_X, HEIGHT, HALF_Z, looks, 1.6)
    skirting(stage, "skirting", HALF_X, HALF_Z)
    beam = scene.mesh("beam", [(paint["walnut"], rounded_box(0.14, 0.20, 2 * HALF_Z, 0.012, 1, grain=0.8))])
    for k, x in enumerate((-2.6, 0.0, 2.6)):
        stage.put(f"beam {k + 1}", beam, x, HEIGHT - 0.20, 0)
    window = things.framed(scene, paint, "window", "white", "window", 1.9, 1.6, 1.5)
    stage.put("window", window, -HALF_X, 1.75, -0.35, 90)
    bars = Patch().add(box((-0.015, -0.8, -0.011), (0.015, 0.8, 0.011), grain=0.5),
                       box((-0.95, 0.20, -0.009), (0.95, 0.23, 0.009), grain=0.5))
    stage.put("window bars", scene.mesh("window bars", [(paint["white"], bars)]), -HALF_X + 0.018, 1.75, -0.35, 90)
    stage.put("door", fittings.door(scene, paint, "door", "walnut", "white", "brass"), 1.9, 0, HALF_Z, 180)


def add_lamps(stage):
    scene, paint = stage.scene, stage.paint
    pendant = lamps.pendant_lamp(scene, paint, "pendant", "brass", "black rubber", "enamel green", "bulb", 1.15)
    x, z, yaw = TABLE
    for k, along in enumerate((-0.42, 0.42)):
        turn = math.radians(yaw)
        stage.put(f"pendant {k + 1}", pendant, x + along * math.cos(turn), HEIGHT, z - along * math.sin(turn))
    tube = lamps.tube_lamp(scene, paint, "tube", "aluminium", "tube", 1.2, 0.35)
    stage.put("tube over the desk", tube, 1.15, HEIGHT, -1.75, 4)
    panel = lamps.panel_lamp(scene, paint, "panel", "aluminium", "panel", 1.2, 0.3)
    stage.put("panel", panel, -1.3, HEIGHT, -1.2, 90)
    standing = lamps.floor_lamp(scene, paint, "floor lamp", "brass", "shade cloth", "bulb")
    stage.put("floor lamp", standing, -3.62, 0, -2.12, 20)


def add_dining_table(stage):
    scene, paint = stage.scene, stage.paint
    x, z, yaw = TABLE
    place = scene.node("dining", at=(x, 0, z), rotation=glb.turn_y(yaw))
    top = 0.74
    stage.put("dining table", fittings.table(scene, paint, "dining table", "wood", "black steel", 1.7, 0.85), 0, 0, 0,
              0, None, place)
    chair = seats.tube_chair(scene, paint, "chair", "mustard fabric", "steel")
    for k, (cx, cz, turn) in enumerate(CHAIRS):
        stage.put(f"chair {k + 1}", chair, cx, 0, cz, turn, None, place)
    cup = things.cup(scene, paint, "cup", "porcelain", "coffee")
    for k, (cx, cz, turn) in enumerate(((-0.35, -0.22, 200), (0.40, 0.20, 40))):
        stage.put(f"cup {k + 1}", cup, cx, top, cz, turn, None, place)
    bowl = stage.put("bowl", things.bowl(scene, paint, "bowl", "blue glaze", 0.15), 0.02, top, 0.02, 0, None, place)
    apple = things.apple(scene, paint, "apple", "apple", "stalk")
    for k, (ax, ay, az, turn) in enumerate(((-0.042, 0.0125, -0.022, 0), (0.042, 0.0125, -0.028, 130),
                                            (0.002, 0.0115, 0.045, 250))):
        stage.put(f"apple {k + 1}", apple, ax, ay, az, turn, None, bowl)
    vase = things.vase(scene, paint, "vase", "red glaze", [
        (0.035, 0.0), (0.062, 0.05), (0.066, 0.11), (0.036, 0.19), (0.022, 0.24), (0.034, 0.28)], 20, 8)
    stage.put("vase", vase, -0.55, top, 0.16, 0, None, place)


def add_seating(stage):
    scene, paint = stage.scene, stage.paint
    sofa = stage.put("sofa", seats.sofa(scene, paint, "sofa", "teal fabric", "walnut"), -2.30, 0, -HALF_Z + 0.46)
    pillow = seats.throw_pillow(scene, paint, "pillow", "rust fabric")
    stage.put("pillow", pillow, -0.52, 0.690, -0.085, 0, ((1, 0, 0.3), 62), sofa)
    rug = scene.mesh("rug", [(paint["rug"], rounded_box(2.0, 0.008, 1.3, 0.0038, 1, grain=2.0))])
    stage.put("rug", rug, -2.20, 0, -0.88, -6)
    table = fittings.round_table(scene, paint, "round table", "walnut", "black steel")
    stage.put("round table", table, -2.15, 0.008, -0.92, 30)
    stage.put("book on the table", things.book(scene, paint, "flat book", "blue book", "paper", (0.026, 0.24, 0.17)),
              -2.12, 0.468 + 0.013, -0.80, 40, ((0, 0, 1), 90))
    plant = things.potted_plant(scene, paint, "plant", "terracotta", "soil", "leaf", stage.draw)
    stage.put("plant", plant, -3.40, 0, 0.10)
    globe = scene.mesh("chrome ball", [(paint["chrome"], ball(BALL_RADIUS))])
    stage.put("chrome ball", globe, 0.25, BALL_RADIUS, -0.75)


def add_mirrors(stage):
    """One hangs on the long wall; the other leans against a partition that is parallel to no wall."""
    scene, paint = stage.scene, stage.paint
    hung = things.framed(scene, paint, "wall mirror", "walnut", "mirror", 1.25, 1.15)
    stage.put("wall mirror", hung, -0.45, 1.52, -HALF_Z)
    x, z, yaw = PARTITION
    place = scene.node("partition with a mirror", at=(x, 0, z), rotation=glb.turn_y(yaw))
    screen = fittings.partition(scene, paint, "partition", "grey fabric", "black steel", 1.3, 1.75)
    stage.put("partition", screen, 0, 0, 0, 0, None, place)
    # The moulding reaches 40 mm beyond the glass; its back is the plane z = 0 of the mirror's own frame.
    tall, tilt = 1.45, 9.0
    y, away = lean(tall + 0.08, 0.0, tilt)
    leaning = things.framed(scene, paint, "leaning mirror", "brass", "mirror", 0.62, tall)
    up = (tall / 2 + 0.04)
    t = math.radians(tilt)
    stage.put("leaning mirror", leaning, 0.05, y + up * math.cos(t), 0.0125 + away - up * math.sin(t), 0,
              ((1, 0, 0), -tilt), place)


def add_sideboard(stage):
    scene, paint = stage.scene, stage.paint
    stage.put("sideboard", fittings.cabinet(scene, paint, "sideboard", "walnut", "white", "brass"), -0.45, 0,
              -HALF_Z + 0.215)
    urn = things.vase(scene, paint, "urn", "green glaze", [
        (0.05, 0.0), (0.10, 0.07), (0.11, 0.15), (0.07, 0.24), (0.045, 0.28), (0.06, 0.31)], 22, 8)
    stage.put("urn", urn, -0.86, 0.55, -HALF_Z + 0.20)
    can = things.vase(scene, paint, "rusted can", "rusted metal", [
        (0.07, 0.0), (0.07, 0.06), (0.071, 0.13), (0.075, 0.18)], 18, 4, 0.003)
    stage.put("rusted can", can, 0.0, 0.55, -HALF_Z + 0.22)
    volume = things.book(scene, paint, "upright book", "green book", "paper", (0.035, 0.25, 0.18))
    stage.put("upright book", volume, -0.30, 0.55, -HALF_Z + 0.20, 4)
    picture = things.framed(scene, paint, "painting", "brass", "abstract", 0.80, 0.80)
    stage.put("painting", picture, -2.30, 1.72, -HALF_Z)
    clock = things.wall_clock(scene, paint, "clock", "black steel", "dial", "graphite")
    stage.put("clock", clock, 0.66, 2.10, -HALF_Z)
    view = things.framed(scene, paint, "landscape", "walnut", "landscape", 1.2, 0.8)
    stage.put("landscape", view, -1.0, 1.6, HALF_Z, 180)


def add_desk(stage):
    scene, paint = stage.scene, stage.paint
    top = 0.74
    place = scene.node("desk place", at=(1.20, 0, -HALF_Z + 0.36))
    stage.put("desk", fittings.table(scene, paint, "desk", "wood", "steel", 1.4, 0.70), 0, 0, 0, 0, None, place)
    display = fittings.screen(scene, paint, "screen", "graphite", "dashboard")
    stage.put("screen", display, -0.10, top, -0.12, 8, None, place)
    stage.put("keyboard", fittings.keyboard(scene, paint, "keyboard", "graphite", "keys"), -0.06, top, 0.16, 3, None,
              place)
    stage.put("mouse", fittings.mouse(scene, paint, "mouse", "graphite"), 0.26, top, 0.15, 14, None, place)
    lamp = lamps.desk_lamp(scene, paint, "desk lamp", "black steel", "enamel red", "small bulb")
    stage.put("desk lamp", lamp, 0.52, top, -0.10, 196, None, place)
    chair = seats.office_chair(scene, paint, "desk chair", "grey fabric", "black rubber", "aluminium")
    stage.put("desk chair", chair, 0.02, 0, 0.62, 200, None, place)
    cord = [(0.50, top + 0.004, -0.19), (0.49, top + 0.006, -0.30), (0.47, 0.735, -0.354), (0.42, 0.40, -0.34),
            (0.30, 0.10, -0.335), (0.24, 0.004, -0.25), (0.36, 0.004, -0.14)]
    stage.put("cord", things.cable(scene, paint, "cord", "black rubber", cord), 0, 0, 0, 0, None, place)


def add_shelf(stage):
    """Seen from the eye in mirrors only. Books stand, and the last of each row leans on its neighbours."""
    scene, paint = stage.scene, stage.paint
    mesh, tops = fittings.shelf(scene, paint, "shelf", "wood", "black steel")
    place = stage.put("shelf", mesh, 2.95, 0, -HALF_Z + 0.16)
    kinds = [things.book(scene, paint, f"{tone} book", f"{tone} book", "paper", size) for tone, size in
             (("red", (0.040, 0.24, 0.17)), ("blue", (0.030, 0.27, 0.19)), ("green", (0.052, 0.22, 0.16)),
              ("cream", (0.036, 0.25, 0.18)))]
    sizes = ((0.040, 0.24), (0.030, 0.27), (0.052, 0.22), (0.036, 0.25))
    for level, y in enumerate(tops[:-1]):
        x = -0.58
        for k in range(6 + 2 * (level % 2)):
            kind = int(4 * stage.draw())
            thick, tall = sizes[kind]
            stage.put(f"book {level + 1}.{k + 1}", kinds[kind], x + thick / 2, y, 0.02 * stage.draw(), 0, None, place)
            x += thick + 0.001
        # Tilted about z so that its upper left edge touches the row, its lower right edge the board.
        tilt = math.radians(11)
        thick, tall = sizes[3]
        c, s = math.cos(tilt), math.sin(tilt)
        stage.put(f"leaning book {level + 1}", kinds[3], x + tall * s + thick / 2 * c, y + thick / 2 * s, 0.0, 0,
                  ((0, 0, 1), 11), place)


def build():
    stage = Stage("Loft", SEED)
    for add in (add_room, add_lamps, add_dining_table, add_seating, add_mirrors, add_sideboard, add_desk, add_shelf):
        add(stage)
    stage.look(CAMERA, TARGET, VERTICAL_FOV)
    return stage.scene


if __name__ == "__main__":
    glb.generator_main(build, HERE / "loft.glb")
