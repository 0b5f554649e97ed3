#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""An office as an exporter writes it: smooth furniture, textures, default dielectrics, screens that shine."""

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
from solids import ball, rounded_box, torus  # noqa: E402

HALF_X, HEIGHT, HALF_Z = 3.0, 3.0, 2.0      # the room: 6 x 3 x 4 metres
BALL_RADIUS = 0.3
MIRROR_WIDTH, MIRROR_HEIGHT, MIRROR_X, MIRROR_Y = 2.84, 1.40, 0.20, 1.60
CAMERA, TARGET, VERTICAL_FOV = (2.70, 1.60, 1.75), (-0.42, 0.92, -0.90), 55.0
DESK_TOP = 0.74
SEED = 1996
# Workstation, x, z, facing, fabric, place and turn of the chair, whether that is a mirror image, the screen.
PLACES = (("1", -0.48, 0.47, 0, "mustard fabric", (0.12, 0.66), 204, False, "dashboard"),
          ("2", -1.80, 0.47, 0, "rust fabric", (-0.05, 0.62), 162, False, "document"),
          ("3", -0.48, -0.27, 180, "mustard fabric", (0.02, 0.72), 152, True, "document"),
          ("4", -1.80, -0.27, 180, "rust fabric", (0.06, 0.66), 215, False, "dashboard"))


def add_room(stage):
    scene, paint = stage.scene, stage.paint
    looks = {"floor": "grey carpet", "ceiling": "ceiling", "back": "plaster", "right": "plaster", "front": "plaster",
             "left": "teal wall"}
    room(stage, HALF_X, HEIGHT, HALF_Z, looks)
    skirting(stage, "skirting", HALF_X, HALF_Z, ("back", "left", "right"))
    panel = lamps.panel_lamp(scene, paint, "ceiling panel", "aluminium", "panel")
    for i in range(8):
        stage.put(f"ceiling panel {i + 1}", panel, -2.1 + 1.4 * (i % 4), HEIGHT, -0.9 if i < 4 else 0.9)


def add_wall_objects(stage):
    scene, paint = stage.scene, stage.paint
    mirror = things.framed(scene, paint, "mirror", "graphite", "mirror", MIRROR_WIDTH, MIRROR_HEIGHT, 1.2)
    stage.put("mirror", mirror, MIRROR_X, MIRROR_Y, -HALF_Z)
    picture = things.framed(scene, paint, "picture", "walnut", "landscape", 1.35, 0.90)
    stage.put("picture on the wall", picture, -HALF_X, 1.62, -0.35, 90)
    stage.put("door", fittings.door(scene, paint, "door", "wood", "white", "steel"), -0.55, 0, HALF_Z, 180)
    clock = things.wall_clock(scene, paint, "clock", "black steel", "dial", "graphite")
    stage.put("clock", clock, 0.55, 2.05, HALF_Z, 180)
    board = rounded_box(1.8, 1.1, 0.02, 0.005, 1, grain=1.0).moved(0, -0.55, 0.01)
    tray = box((-0.4, -0.60, 0), (0.4, -0.58, 0.07), grain=0.5)
    stage.put("whiteboard", scene.mesh("whiteboard", [(paint["white"], board), (paint["aluminium"], tray)]),
              HALF_X, 1.55, 0.2, -90)


def add_workstations(stage):
    """Two by two desks back to back, a cable behind each. The third chair is a mirror image of the first."""
    scene, paint = stage.scene, stage.paint
    desk = fittings.table(scene, paint, "desk", "wood", "black steel", 1.30, 0.72)
    screens = {kind: fittings.screen(scene, paint, f"screen {kind}", "graphite", kind, 0.53, 0.31)
               for kind in ("dashboard", "document")}
    keyboard = fittings.keyboard(scene, paint, "keyboard", "graphite", "keys")
    mouse = fittings.mouse(scene, paint, "mouse", "graphite")
    cup = things.cup(scene, paint, "cup", "porcelain", "coffee")
    chairs = {fabric: seats.office_chair(scene, paint, f"chair {fabric}", fabric, "black rubber", "aluminium")
              for fabric in ("mustard fabric", "rust fabric")}
    cord = things.cable(scene, paint, "cord", "black rubber", [
        (-0.08, DESK_TOP + 0.004, -0.24), (-0.09, DESK_TOP + 0.006, -0.34), (-0.10, 0.725, -0.366), (-0.14, 0.40, -0.35),
        (-0.24, 0.08, -0.34), (-0.34, 0.004, -0.26), (-0.50, 0.004, -0.22)])
    for number, x, z, facing, fabric, (chair_x, chair_z), turn, mirrored, kind in PLACES:
        place = stage.put(f"workstation {number}", None, x, 0, z, facing)
        stage.put(f"desk {number}", desk, 0, 0, 0, 0, None, place)
        stage.put(f"screen {number}", screens[kind], -0.08, DESK_TOP, -0.16, 6, None, place)
        stage.put(f"keyboard {number}", keyboard, -0.06, DESK_TOP, 0.16, 2, None, place)
        stage.put(f"mouse {number}", mouse, 0.26, DESK_TOP, 0.17, 12, None, place)
        stage.put(f"cord {number}", cord, 0, 0, 0, 0, None, place)
        if number in "14":
            stage.put(f"cup {number}", cup, 0.42, DESK_TOP, -0.05, 70 + 50 * int(number), None, place)
        stage.put(f"chair {number}", chairs[fabric], chair_x, 0, chair_z, turn, None, place,
                  (-1, 1, 1) if mirrored else None)


def add_bookshelf(stage):
    """Seen in the mirror only. The last book of each board leans on its row."""
    scene, paint = stage.scene, stage.paint
    mesh, tops = fittings.shelf(scene, paint, "bookshelf", "wood", "black steel", 1.37, 2.0, 0.30)
    place = stage.put("bookshelf", mesh, -2.05, 0, HALF_Z - 0.16, 180)
    sizes = {"red book": (0.060, 0.30, 0.20), "blue book": (0.045, 0.33, 0.22), "green book": (0.075, 0.28, 0.19),
             "cream book": (0.050, 0.31, 0.21)}
    books = {cloth: things.book(scene, paint, cloth, cloth, "paper", size) for cloth, size in sizes.items()}
    tilt = 10
    c, s = math.cos(math.radians(tilt)), math.sin(math.radians(tilt))
    for level, y in enumerate(tops[:-1]):
        x = -0.66
        for k in range(10 + 3 * (level % 2)):
            cloth = list(sizes)[int(4 * stage.draw())]
            thick = sizes[cloth][0]
            stage.put(f"book {level + 1}.{k + 1}", books[cloth], x + thick / 2, y, 0.03 * stage.draw(), 0, None, place)
            x += thick + 0.001
        thick, tall, _ = sizes["cream book"]
        stage.put(f"leaning book {level + 1}", books["cream book"], x + tall * s + thick / 2 * c, y + thick / 2 * s, 0, 0,
                  ((0, 0, 1), tilt), place)


def add_ball(stage):
    """A chrome ball in a ring on a cabinet with drawers."""
    scene, paint = stage.scene, stage.paint
    top, bar, ring = 0.60, 0.015, 0.115
    cabinet = rounded_box(0.46, top - 0.03, 0.46, 0.005, 1, grain=0.6).moved(0, 0.03, 0)
    foot = box((-0.21, 0.0, -0.21), (0.21, 0.03, 0.21), grain=0.5)
    fronts = Patch()
    for i in range(3):
        fronts.add(rounded_box(0.43, 0.17, 0.016, 0.004, 1, grain=0.5).moved(0, 0.05 + 0.18 * i, 0.238))
    holder = torus(ring, bar, 24, 8).moved(0, top + bar, 0)
    mesh = scene.mesh("ball stand", [(paint["wood"], cabinet), (paint["white"], fronts),
                                     (paint["graphite"], Patch().add(foot, holder))])
    place = stage.put("ball stand", mesh, 0.50, 0, 0.10, 90)
    rest = top + bar + math.sqrt((BALL_RADIUS + bar) ** 2 - ring ** 2)
    globe = scene.mesh("chrome ball", [(paint["chrome"], ball(BALL_RADIUS, 36, 18))])
    stage.put("chrome ball", globe, 0, rest, 0, 0, None, place)


def add_loose_objects(stage):
    scene, paint = stage.scene, stage.paint
    top = 0.60
    board = fittings.cabinet(scene, paint, "sideboard", "wood", "white", "steel", 1.5, top, 0.40)
    stage.put("sideboard", board, 0.15, 0, -HALF_Z + 0.215)
    lamp = lamps.table_lamp(scene, paint, "lamp", "black steel", "worn metal", "small bulb")
    stage.put("rough metal lamp", lamp, -0.35, top, -HALF_Z + 0.23)
    bottom = top
    for cloth, (thick, tall, deep), turn in (("red book", (0.040, 0.30, 0.22), 8), ("cream book", (0.030, 0.26, 0.20), -14),
                                             ("green book", (0.045, 0.22, 0.16), 20)):
        mesh = things.book(scene, paint, f"{cloth} that lies", cloth, "paper", (thick, tall, deep))
        stage.put(f"{cloth} that lies", mesh, 0.62 + tall / 2, bottom + thick / 2, -HALF_Z + 0.22, turn, ((0, 0, 1), 90))
        bottom += thick
    vase = things.vase(scene, paint, "vase", "blue glaze", [
        (0.04, 0.0), (0.065, 0.05), (0.07, 0.11), (0.04, 0.19), (0.026, 0.23), (0.04, 0.27)], 24, 10)
    stage.put("vase", vase, 0.05, top, -HALF_Z + 0.20)
    bin_ = things.vase(scene, paint, "waste bin", "worn metal", [(0.12, 0.0), (0.135, 0.18), (0.15, 0.36)], 28, 4, 0.004)
    stage.put("rough metal bin", bin_, 1.20, 0, -0.75)
    plant = things.potted_plant(scene, paint, "plant", "terracotta", "soil", "leaf", stage.draw, 14, 0.95)
    stage.put("plant", plant, -2.36, 0, -1.40)
    folder = scene.mesh("portfolio", [(paint["green glaze"], rounded_box(0.42, 0.55, 0.02, 0.003))])
    y, away = lean(0.55, 0.02, 12, 0.003)
    stage.put("portfolio on the wall", folder, 1.75, y, -HALF_Z + 0.014 + away, 0, ((1, 0, 0), -12))


def build():
    stage = Stage("Office", SEED)
    for add in (add_room, add_wall_objects, add_workstations, add_bookshelf, add_ball, add_loose_objects):
        add(stage)
    stage.look(CAMERA, TARGET, VERTICAL_FOV)
    return stage.scene


if __name__ == "__main__":
    glb.generator_main(build, HERE / "office.glb")
