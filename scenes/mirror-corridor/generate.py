# SPDX-License-Identifier: Apache-2.0
"""A corridor between two facing mirrors, with objects and a patterned floor."""

import math
import pathlib
import random
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import furniture  # noqa: E402
import glb  # noqa: E402
import png  # noqa: E402
import shapes  # noqa: E402
import textures  # noqa: E402
from furniture import GAP  # noqa: E402

HALF_X, HEIGHT, HALF_Z = 1.3, 2.7, 4.0              # the corridor runs along z, metres
MIRROR_BOTTOM, MIRROR_TOP, MIRROR_END = 0.20, 2.40, 3.6
MIRROR_GAP = 0.02                                   # between a mirror and its wall
REFLECTANCE = (0.90, 0.93, 0.91)                    # silvered glass: far reflections turn green
LAMP_LUMINANCE = (3200.0, 3050.0, 2750.0)           # cd/m2
CAMERA, TARGET, VERTICAL_FOV = (0.62, 1.55, 3.1), (-0.75, 1.10, 0.2), 58.0
SEED = 7

MATTE = {"wall": (0.70, 0.66, 0.58), "end wall": (0.16, 0.30, 0.38), "ceiling": (0.84, 0.84, 0.82),
         "graphite": (0.045, 0.045, 0.05), "stone": (0.68, 0.64, 0.58), "red": (0.66, 0.12, 0.07),
         "yellow": (0.80, 0.56, 0.08), "blue": (0.08, 0.20, 0.50), "cream": (0.80, 0.76, 0.66),
         "terracotta": (0.60, 0.25, 0.13), "soil": (0.06, 0.04, 0.03), "leaf": (0.10, 0.33, 0.08),
         "steel": (0.22, 0.23, 0.25)}


def floor_tiles():
    """A pale octagon with dark squares at its corners and a coloured diamond in its middle."""
    size = 64
    picture = png.Picture(size, size, [(222, 214, 198), (52, 50, 54), (176, 84, 52), (150, 142, 130)])

    def colour_at(x, y):
        across, up = abs(x - 31.5), abs(y - 31.5)
        if across + up > 48:
            return 1
        if across > 30 or up > 30 or 46 < across + up:
            return 3
        return 2 if across + up < 13 else 0

    picture.paint(colour_at)
    return picture.encode()


def add_corridor(scene, paint):
    x, y, z = HALF_X, HEIGHT, HALF_Z
    surfaces = (
        # A repeat of the floor's picture is 0.65 m: four tiles across.
        ("floor", "tiles", [(-x, 0, z), (x, 0, z), (x, 0, -z), (-x, 0, -z)], (4, round(2 * z / 0.65))),
        ("ceiling", "ceiling", [(-x, y, -z), (x, y, -z), (x, y, z), (-x, y, z)], (1, 1)),
        ("far end", "end wall", [(-x, 0, -z), (x, 0, -z), (x, y, -z), (-x, y, -z)], (1, 1)),
        ("right wall", "wall", [(x, 0, -z), (x, 0, z), (x, y, z), (x, y, -z)], (1, 1)),
        ("near end", "end wall", [(x, 0, z), (-x, 0, z), (-x, y, z), (x, y, z)], (1, 1)),
        ("left wall", "wall", [(-x, 0, z), (-x, 0, -z), (-x, y, -z), (-x, y, z)], (1, 1)))
    for name, material, corners, repeat in surfaces:
        scene.node(name, mesh=scene.mesh(name, [(paint[material], shapes.quad(*corners, repeat=repeat))]))
    pendant = furniture.pendant(scene, paint, length=1.3, width=0.16, drop=0.30)
    for i in range(4):
        scene.node(f"pendant {i + 1}", mesh=pendant, at=(0, y, -3.0 + 2.0 * i), rotation=glb.turn_y(90))


def add_mirrors(scene, paint):
    width, height = 2 * MIRROR_END, MIRROR_TOP - MIRROR_BOTTOM
    w, h = width / 2, height / 2
    pane = shapes.quad((-w, -h, 0), (w, -h, 0), (w, h, 0), (-w, h, 0))
    glass = scene.mesh("mirror", [(paint["mirror"], pane)])
    rim = scene.mesh("mirror frame", [(paint["graphite"], furniture.frame(width, height, 0.04, 0.03, 0.005))])
    for side, x, turn in (("left", -HALF_X, 90), ("right", HALF_X, -90)):
        place = scene.node(f"{side} wall's mirror", at=(x + math.copysign(GAP, -x), MIRROR_BOTTOM + h, 0),
                           rotation=glb.turn_y(turn))
        scene.node(f"{side} mirror", parent=place, mesh=glass, at=(0, 0, MIRROR_GAP))
        scene.node(f"{side} frame", parent=place, mesh=rim)


def pedestal(scene, paint):
    """0.9 m high, on y = 0."""
    base = shapes.box((-0.17, GAP, -0.17), (0.17, 0.08, 0.17), skip=("-y",))
    shaft = shapes.cylinder(0.12, 0.08, 0.84, 16, caps=False)
    slab = shapes.box((-0.16, 0.84, -0.16), (0.16, 0.90, 0.16))
    return scene.mesh("pedestal", [(paint["stone"], shapes.Patch().add(base, shaft, slab))])


def add_objects(scene, paint, draw):
    """Objects in turn along both mirrors, every one of another shape and colour."""
    stand = pedestal(scene, paint)
    cone = shapes.lathe([(0.15, GAP), (0.0, 0.42)], 24)
    ball = shapes.icosphere(0.15, 2).moved(0, 0.15 + GAP, 0)
    cube = shapes.box((-0.13, GAP, -0.13), (0.13, 0.26, 0.13), skip=("-y",)).turned("y", 30)
    for name, patch, colour, x, z in (("cone", cone, "red", -0.95, 0.55),
                                      ("ball", ball, "yellow", 0.95, -0.45),
                                      ("cube", cube, "blue", -0.95, -1.75)):
        scene.node(f"pedestal of the {name}", mesh=stand, at=(x, 0, z))
        scene.node(name, mesh=scene.mesh(name, [(paint[colour], patch)]), at=(x, 0.90, z))
    scene.node("plant", mesh=furniture.plant(scene, paint, draw), at=(0.85, 0, -2.6))
    scene.node("bench", mesh=bench(scene, paint), at=(0.98, 0, -1.5), rotation=glb.turn_y(90))
    width, height = 1.35, 0.90
    picture = scene.node("picture on the far end", at=(0, 1.55, -HALF_Z + GAP))
    w, h = width / 2, height / 2
    view = shapes.quad((-w, -h, 0), (w, -h, 0), (w, h, 0), (-w, h, 0))
    scene.node("picture", parent=picture, at=(0, 0, 0.012),
               mesh=scene.mesh("picture", [(paint["landscape"], view)]))
    scene.node("picture frame", parent=picture, mesh=scene.mesh(
        "picture frame", [(paint["cream"], furniture.frame(width, height, 0.04, 0.03, 0.005))]))
    scene.node("door", mesh=furniture.door(scene, paint), at=(0, 0, HALF_Z), rotation=glb.turn_y(180))


def bench(scene, paint):
    """1.2 m long along x, on y = 0."""
    seat = shapes.box((-0.6, 0.40, -0.18), (0.6, 0.44, 0.18), grain=0.6)
    legs = shapes.Patch()
    for x in (-0.5, 0.46):
        legs.add(shapes.box((x, GAP, -0.15), (x + 0.04, 0.40 - GAP, 0.15), skip=("-y", "+y")))
    return scene.mesh("bench", [(paint["wood"], seat), (paint["graphite"], legs)])


def build():
    scene = glb.Glb("Corridor of mirrors", "Written for Utsuri")
    draw = random.Random(SEED).random
    paint = {name: scene.matte(name, colour) for name, colour in MATTE.items()}
    for name, picture, wrap in (("tiles", floor_tiles(), glb.REPEAT),
                                ("wood", textures.wood(draw), glb.REPEAT),
                                ("landscape", textures.landscape(), glb.CLAMP_TO_EDGE)):
        paint[name] = scene.matte(name, (1.0, 1.0, 1.0), scene.texture(name, picture, wrap=wrap))
    paint["mirror"] = scene.metal("mirror", REFLECTANCE)
    paint["lamp"] = scene.emitter("lamp", LAMP_LUMINANCE)
    add_corridor(scene, paint)
    add_mirrors(scene, paint)
    add_objects(scene, paint, draw)
    scene.node("camera", camera=scene.camera("camera", VERTICAL_FOV, 4 / 3), at=CAMERA,
               rotation=glb.look_rotation([t - c for t, c in zip(TARGET, CAMERA)]))
    return scene


if __name__ == "__main__":
    glb.generator_main(build, pathlib.Path(__file__).with_name("mirror-corridor.glb"))
