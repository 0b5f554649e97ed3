#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Bent reflectors in a washroom: taps, a kettle, a ring, a fender, a ball; smooth chrome and worn metal."""

import math
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import glb  # noqa: E402
import lamps  # noqa: E402
import things  # noqa: E402
from placing import Stage, room  # noqa: E402
from shapes import Patch  # noqa: E402
from solids import (arc, ball, bar, bent, curve, pillow, pipe, rounded_box, surface, torus,  # noqa: E402
                    turned, warped)

HALF_X, HEIGHT, HALF_Z = 1.6, 2.5, 1.5
COUNTER_TOP, COUNTER_DEPTH, COUNTER_X = 0.86, 0.56, 1.30    # along the back wall, COUNTER_X to either side
BASIN_X, BASIN_Z, BASIN_RADIUS = 0.42, -1.21, 0.20
CAMERA, TARGET, VERTICAL_FOV = (0.28, 1.48, 0.55), (-0.06, 1.13, -1.30), 50.0


def add_room(stage):
    scene, paint = stage.scene, stage.paint
    looks = {"floor": "dark tiles", "ceiling": "ceiling", "back": "tiles", "right": "tiles", "front": "sand wall",
             "left": "teal wall"}
    room(stage, HALF_X, HEIGHT, HALF_Z, looks, 0.8)
    tube = lamps.tube_lamp(scene, paint, "tube", "white", "tube", 1.2)
    stage.put("tube", tube, -0.1, HEIGHT, -0.75)
    pendant = lamps.pendant_lamp(scene, paint, "pendant", "brass", "black rubber", "enamel red", "bulb", 0.55)
    stage.put("pendant", pendant, -1.05, HEIGHT, 0.25)
    # What the reflectors show of the side that the camera does not see.
    window = things.framed(scene, paint, "window", "white", "window", 1.0, 1.1)
    stage.put("window", window, 0.6, 1.55, HALF_Z, 180)
    picture = things.framed(scene, paint, "picture", "black steel", "abstract", 0.6, 0.6, 0.6)
    stage.put("picture", picture, -HALF_X, 1.5, 0.1, 90)
    towel_rail(stage)


def towel_rail(stage):
    """On the back wall: a bent bar, and a towel that hangs over it."""
    scene, paint = stage.scene, stage.paint
    bar = pipe(bent([(-0.35, 0, 0), (-0.35, 0, 0.09), (0.35, 0, 0.09), (0.35, 0, 0)], 0.03, 4), 0.009, 14, caps=False)
    roses = Patch()
    for x in (-0.35, 0.35):
        roses.add(turned([(0.0, 0.0), (0.028, 0.0), (0.028, 0.006), (0.010, 0.012)], 24).turned("x", 90).moved(x, 0, 0))

    radius = 0.0105
    half = math.pi * radius / 2
    # Up the back, half around the bar, down the front.
    lengths = [-0.42 + 0.07 * k for k in range(6)] + [half * (k / 4 - 1) for k in range(9)]
    lengths += [0.07 * k for k in range(1, 8)]

    def cloth_at(u, v):
        length = lengths[round(v * (len(lengths) - 1))]
        x = 0.34 * (u - 0.5)
        if abs(length) <= half:
            angle = length / radius
            return (x, radius * math.cos(angle), 0.09 + radius * math.sin(angle))
        side = 1 if length > 0 else -1
        # Folds grow downwards.
        fold = 0.010 * (1 + math.sin(math.tau * 3 * u)) * min(1.0, (abs(length) - half) / 0.3)
        return (x, half - abs(length), 0.09 + side * (radius + fold))

    cloth = surface(18, len(lengths) - 1, cloth_at, (3.0, 8.0), crease=80)
    mesh = scene.mesh("towel rail", [(paint["chrome"], Patch().add(bar, roses)), (paint["towel"], cloth)])
    stage.put("towel rail", mesh, -0.86, 1.80, -HALF_Z)


def add_counter(stage):
    """A stone slab on a body of wood, against the back wall and along it."""
    scene, paint = stage.scene, stage.paint
    middle = -HALF_Z + COUNTER_DEPTH / 2
    body = rounded_box(2 * COUNTER_X - 0.06, COUNTER_TOP - 0.04, COUNTER_DEPTH - 0.05, 0.004, 1, grain=0.8)
    slab = rounded_box(2 * COUNTER_X, 0.04, COUNTER_DEPTH, 0.006, 2, grain=0.6)
    knobs = Patch()
    for k in range(4):
        knob = turned([(0.0, 0.0), (0.007, 0.0), (0.007, 0.010), *arc(0.012, -60, 90, 3, (0.002, 0.022))], 12)
        knobs.add(knob.turned("x", 90).moved(-0.9 + 0.6 * k, 0.62, middle + COUNTER_DEPTH / 2 - 0.05))
    mesh = scene.mesh("counter", [(paint["walnut"], body.moved(0, 0, middle - 0.025)),
                                  (paint["stone"], slab.moved(0, COUNTER_TOP - 0.04, middle)),
                                  (paint["chrome"], knobs)])
    scene.node("counter", mesh=mesh)


def basin_and_tap(stage):
    """A hollow bowl of copper on the counter, and a tap that arches over it."""
    scene, paint = stage.scene, stage.paint
    outside = [(r, y) for r, y in curve([(0.07, 0.0), (0.13, 0.03), (0.185, 0.09), (0.205, 0.15)], 8)]
    inside = [(r, y) for r, y in curve([(0.197, 0.15), (0.177, 0.095), (0.12, 0.042), (0.03, 0.022)], 8)]
    bowl = turned([(0.0, 0.0), *outside, (0.202, 0.153), *inside], 44, (4.0, 1.0), 50)
    drain = turned([(0.031, 0.0215), (0.026, 0.026), (0.012, 0.023), (0.0, 0.026)], 20)
    mesh = scene.mesh("basin", [(paint["copper"], bowl), (paint["chrome"], drain)])
    stage.put("basin", mesh, BASIN_X, COUNTER_TOP, BASIN_Z)
    base = turned([(0.0, 0.0), (0.032, 0.0), (0.032, 0.008), (0.022, 0.016), (0.020, 0.12), (0.017, 0.13), (0.0, 0.13)],
                  28)
    neck = [(0.0, 0.12, 0.0), (0.0, 0.20, 0.0), (0.0, 0.26, 0.0),
            *[(0.0, 0.26 + y, 0.085 - x) for x, y in arc(0.085, 0, 160, 14)[1:]]]
    spout = pipe(neck, lambda t: 0.0125, 16)
    mouth = turned([(0.0125, -0.02), (0.0145, -0.018), (0.0145, 0.018), (0.0125, 0.02)], 20)
    mouth = mouth.turned("x", -20).moved(0, neck[-1][1] - 0.004, neck[-1][2] + 0.001)
    lever = pipe(curve([(0.018, 0.09, 0.0), (0.05, 0.10, 0.0), (0.10, 0.135, 0.01)], 8), lambda t: 0.007 + 0.003 * t, 12)
    tap = scene.mesh("tap", [(paint["chrome"], Patch().add(base, spout, mouth, lever))])
    stage.put("tap", tap, BASIN_X, COUNTER_TOP, -HALF_Z + 0.07, -8)


def kettle(stage):
    """A body turned on the lathe, a tapering spout, a bail of bent tube."""
    scene, paint = stage.scene, stage.paint
    profile = curve([(0.088, 0.004), (0.108, 0.05), (0.095, 0.11), (0.055, 0.150), (0.044, 0.158)], 14)
    body = turned([(0.0, 0.0), (0.084, 0.0), *profile, (0.044, 0.163), (0.034, 0.172), (0.0, 0.176)], 36, (3.0, 1.0), 50)
    knob = turned([(0.005, 0.174), (0.006, 0.186), *arc(0.012, -60, 90, 6, (0.004, 0.198))], 20, crease=60)
    spout = pipe(curve([(0.085, 0.055, 0), (0.135, 0.08, 0), (0.150, 0.13, 0), (0.185, 0.158, 0)], 12),
                 lambda t: 0.022 - 0.010 * t, 16)
    bail = pipe(bent([(-0.075, 0.135, 0), (-0.10, 0.27, 0), (0.10, 0.27, 0), (0.075, 0.135, 0)], 0.06, 6), 0.0055, 12)
    grip = pipe([(-0.045, 0.27, 0), (0.0, 0.27, 0), (0.045, 0.27, 0)], 0.011, 14)
    mesh = scene.mesh("kettle", [(paint["chrome"], Patch().add(body, spout, bail)),
                                 (paint["black rubber"], Patch().add(knob, grip))])
    stage.put("kettle", mesh, -0.34, COUNTER_TOP, -1.22, -152)


def shaving_mirror(stage):
    """Hollow, on an arm from the back wall: near things upright and large, the room upside down."""
    scene, paint = stage.scene, stage.paint
    dish = turned([(0.0, 0.0), *[(r, 0.9 * r * r) for r in (0.02 * k for k in range(1, 7))]], 40, (2.0, 2.0), 60)
    rim = torus(0.122, 0.005, 40, 8).moved(0, 0.013, 0)
    back = turned([(0.122, 0.010), (0.11, 0.002), (0.05, -0.006), (0.0, -0.008)][::-1], 40, (2.0, 1.0), 60)
    head = [part.turned("x", 90) for part in (dish.moved(0, 0.002, 0), Patch().add(rim, back))]
    mesh = scene.mesh("shaving mirror", [(paint["mirror"], head[0]), (paint["chrome"], head[1])])
    stage.put("shaving mirror", mesh, -0.10, 1.38, -HALF_Z + 0.150, 14)
    path = curve([(0, 0, 0.144), (0.03, -0.01, 0.10), (0.0, -0.02, 0.05), (-0.05, -0.02, 0.0)], 12)
    rose = turned([(0.0, 0.0), (0.03, 0.0), (0.03, 0.008), (0.0, 0.012)], 24).turned("x", 90).moved(-0.05, -0.02, 0)
    arm = scene.mesh("mirror arm", [(paint["chrome"], Patch().add(pipe(path, 0.006, 10), rose))])
    stage.put("mirror arm", arm, -0.10, 1.38, -HALF_Z)


def add_reflectors(stage):
    scene, paint = stage.scene, stage.paint
    top, rear = COUNTER_TOP, -HALF_Z
    globe = scene.mesh("chrome ball", [(paint["chrome"], ball(0.10, 36, 18))])
    stage.put("chrome ball", globe, 0.03, top + 0.10, -1.08)
    urn = things.vase(scene, paint, "gold vase", "gold mirror", [
        (0.06, 0.0), (0.10, 0.05), (0.125, 0.14), (0.09, 0.25), (0.045, 0.32), (0.042, 0.36), (0.07, 0.41)], 36, 18)
    stage.put("gold vase", urn, -0.92, top, -1.20)
    ring = scene.mesh("ring", [(paint["chrome"], torus(0.12, 0.028, 44, 14))])
    # Leans on the wall: the lowest point of the bar on the slab, the rearmost on the wall.
    tilt = math.radians(72)
    reach, lift = 0.12 * math.cos(tilt) + 0.028, 0.12 * math.sin(tilt) + 0.028
    stage.put("ring", ring, -0.62, top + lift, rear + reach, 0, ((1, 0, 0), 72))
    wave = surface(40, 10, lambda u, v: (0.44 * (u - 0.5), 0.30 * v, 0.05 * math.sin(math.tau * u)), (3.0, 2.0), crease=80)
    sheet = scene.mesh("bent sheet", [(paint["brushed metal"], wave)])
    stage.put("bent sheet", sheet, 0.98, top, rear + 0.17, -24)
    can = things.vase(scene, paint, "rusted can", "rusted metal", [
        (0.085, 0.0), (0.085, 0.08), (0.086, 0.16), (0.092, 0.22)], 24, 6, 0.003)
    stage.put("rusted can", can, 0.86, top, -1.06)
    tray = scene.mesh("tray", [(paint["worn metal"], warped(
        rounded_box(0.34, 0.008, 0.20, 0.0035, 1, (10, 0, 10)),
        lambda x, y, z: (x, y + 0.35 * max(0.0, abs(x) - 0.12) ** 1.5 + 0.5 * max(0.0, abs(z) - 0.06) ** 1.5, z), 60))])
    stage.put("tray", tray, -0.58, top, -1.06, 12)


def add_colours(stage):
    """What the reflectors show: small things of strong colours, near them."""
    scene, paint = stage.scene, stage.paint
    top = COUNTER_TOP
    for name, glaze, x, z, yaw, raised in (("red cup", "red glaze", -0.62, -1.08, 40, 0.008),
                                           ("blue cup", "blue glaze", 0.66, -1.02, -150, 0.0)):
        stage.put(name, things.cup(scene, paint, name, glaze), x, top + raised, z, yaw)
    soap = scene.mesh("soap", [(paint["yellow plastic"], pillow(0.085, 0.022, 0.055, 0.010, 0.006))])
    stage.put("soap", soap, 0.16, top, -1.00, 33)
    bottle = things.vase(scene, paint, "bottle", "green glaze", [
        (0.032, 0.0), (0.034, 0.06), (0.034, 0.13), (0.016, 0.165), (0.013, 0.20), (0.016, 0.21)], 20, 10)
    stage.put("bottle", bottle, 0.12, top, -1.36)
    brush = scene.mesh("brush", [(paint["yellow plastic"], bar((0, 0, 0), (0, 0.18, 0), 0.004))])
    stage.put("brush", brush, 0.652, top + 0.014, -1.01, 0, ((0.5, 0, 1), 14))


def build():
    stage = Stage("Chrome")
    for add in (add_room, add_counter, basin_and_tap, kettle, shaving_mirror, add_reflectors, add_colours):
        add(stage)
    stage.look(CAMERA, TARGET, VERTICAL_FOV)
    return stage.scene


if __name__ == "__main__":
    glb.generator_main(build, HERE / "chrome.glb")
