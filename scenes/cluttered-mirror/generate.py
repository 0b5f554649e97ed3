# SPDX-License-Identifier: Apache-2.0
"""A hall with a wall mirror and clutter right in front of it: rods, leaves, boxes, a chair."""

import pathlib
import random
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import furniture  # noqa: E402
import glb  # noqa: E402
import shapes  # noqa: E402
import textures  # noqa: E402
from furniture import GAP  # noqa: E402

HALF_X, HEIGHT, HALF_Z = 2.2, 2.8, 2.2              # the room, metres
MIRROR_WIDTH, MIRROR_HEIGHT, MIRROR_Y, MIRROR_GAP = 2.6, 1.7, 1.35, 0.015
REFLECTANCE = (0.95, 0.95, 0.95)
LAMP_LUMINANCE = (3000.0, 2850.0, 2600.0)           # cd/m2
CAMERA, TARGET, VERTICAL_FOV = (1.10, 1.60, 1.75), (-0.10, 1.02, -1.90), 50.0
SEED = 11

MATTE = {"wall": (0.76, 0.72, 0.64), "accent wall": (0.44, 0.16, 0.13), "ceiling": (0.84, 0.84, 0.82),
         "graphite": (0.045, 0.045, 0.05), "steel": (0.22, 0.23, 0.25), "mustard": (0.72, 0.42, 0.06),
         "teal": (0.06, 0.30, 0.33), "rust": (0.55, 0.16, 0.07), "plum": (0.24, 0.08, 0.17),
         "cream": (0.80, 0.76, 0.66), "cardboard": (0.46, 0.30, 0.17), "tape": (0.74, 0.64, 0.44),
         "bamboo": (0.62, 0.48, 0.20), "terracotta": (0.60, 0.25, 0.13), "soil": (0.06, 0.04, 0.03),
         "leaf": (0.10, 0.33, 0.08)}


def add_room(scene, paint):
    x, y, z = HALF_X, HEIGHT, HALF_Z
    surfaces = (
        ("floor", "wood", [(-x, 0, z), (x, 0, z), (x, 0, -z), (-x, 0, -z)], (2 * x / 0.8, 2 * z / 0.8)),
        ("ceiling", "ceiling", [(-x, y, -z), (x, y, -z), (x, y, z), (-x, y, z)], (1, 1)),
        ("mirror wall", "wall", [(-x, 0, -z), (x, 0, -z), (x, y, -z), (-x, y, -z)], (1, 1)),
        ("right wall", "wall", [(x, 0, -z), (x, 0, z), (x, y, z), (x, y, -z)], (1, 1)),
        ("door wall", "accent wall", [(x, 0, z), (-x, 0, z), (-x, y, z), (x, y, z)], (1, 1)),
        ("left wall", "wall", [(-x, 0, z), (-x, 0, -z), (-x, y, -z), (-x, y, z)], (1, 1)))
    for name, material, corners, repeat in surfaces:
        scene.node(name, mesh=scene.mesh(name, [(paint[material], shapes.quad(*corners, repeat=repeat))]))
    pendant = furniture.pendant(scene, paint, length=1.5, width=0.25, drop=0.40)
    for name, along in (("pendant at the mirror", -0.8), ("pendant at the door", 1.1)):
        scene.node(name, mesh=pendant, at=(0, y, along))


def add_framed(scene, paint, name, material, width, height, place, turn):
    """A picture or a mirror, upright, in a frame."""
    w, h = width / 2, height / 2
    hung = scene.node(f"{name} on the wall", at=place, rotation=glb.turn_y(turn))
    pane = shapes.quad((-w, -h, 0), (w, -h, 0), (w, h, 0), (-w, h, 0))
    scene.node(name, parent=hung, at=(0, 0, MIRROR_GAP), mesh=scene.mesh(name, [(paint[material], pane)]))
    rim = furniture.frame(width, height, 0.05, 0.035, 0.005)
    scene.node(f"{name} frame", parent=hung, mesh=scene.mesh(f"{name} frame", [(paint["graphite"], rim)]))


def rod(foot, tip, radius):
    """A thin stick between two points, open at its ends."""
    return shapes.tube([foot, tip], lambda t: radius, 6)


def bamboo(draw):
    """Rods of 9 mm that stand on y = 0 and lean about."""
    rods = shapes.Patch()
    for i in range(14):
        x, z = 0.32 * (i / 13 - 0.5) + 0.02 * draw(), 0.10 * (draw() - 0.5)
        tip = (x * 1.9 + 0.10 * (draw() - 0.5), 1.55 + 0.35 * draw(), z + 0.08 * (draw() - 0.5))
        rods.add(rod((x, GAP, z), tip, 0.0045 + 0.002 * draw()))
    return rods


def coat_stand():
    """1.75 m high, with pegs all around."""
    stand = shapes.Patch().add(shapes.cylinder(0.016, 0.05, 1.75, 8),
                               shapes.lathe([(0.20, GAP), (0.20, 0.02), (0.03, 0.05)], 16))
    for i, height in enumerate((1.45, 1.50, 1.55, 1.60, 1.65, 1.70)):
        peg = rod((0.014, height, 0), (0.13, height + 0.07, 0), 0.007)
        stand.add(peg.turned("y", 60 * i + 10))
    return stand


def clothes_horse(width, height, depth):
    """A drying rack: two frames that lean together, and bars between them."""
    rack = shapes.Patch()
    for side in (-1, 1):
        for x in (-width / 2, width / 2):
            rack.add(rod((x, GAP, side * depth / 2), (x, height, side * 0.02), 0.008))
        for level in range(6):
            t = 0.25 + 0.72 * level / 5
            y, z = height * t, side * (depth / 2 * (1 - t) + 0.02 * t)
            rack.add(rod((-width / 2, y, z), (width / 2, y, z), 0.004))
    return rack


def carton(width, height, depth):
    """A box on y = 0 and the tape across its top, by material."""
    w, d = width / 2, depth / 2
    body = shapes.box((-w, GAP, -d), (w, height, d), skip=("-y",))
    top = height + GAP
    tape = shapes.quad((-w, top, 0.025), (w, top, 0.025), (w, top, -0.025), (-w, top, -0.025))
    return body, tape


def add_cartons(scene, paint):
    """Two stacks; every carton a gap above the one below."""
    for i, (x, y, z, size, turn) in enumerate((
            (-1.30, 0.0, -1.55, (0.55, 0.38, 0.42), 12), (-1.28, 0.38, -1.56, (0.42, 0.30, 0.36), -9),
            (-1.32, 0.68, -1.54, (0.30, 0.22, 0.26), 25), (-0.72, 0.0, -1.42, (0.36, 0.28, 0.30), -22),
            (1.62, 0.0, -1.05, (0.50, 0.44, 0.44), 8), (1.60, 0.44, -1.08, (0.36, 0.26, 0.30), -16))):
        body, tape = carton(*size)
        scene.node(f"carton {i + 1}", at=(x, y, z), rotation=glb.turn_y(turn), mesh=scene.mesh(
            f"carton {i + 1}", [(paint["cardboard"], body), (paint["tape"], tape)]))


def add_clutter(scene, paint, draw):
    add_cartons(scene, paint)
    for name, patch, colour, place, turn in (
            ("bamboo", bamboo(draw), "bamboo", (0.62, 0, -1.95), 0),
            ("coat stand", coat_stand(), "steel", (-0.35, 0, -1.72), 0),
            ("clothes horse", clothes_horse(0.75, 0.95, 0.5), "cream", (0.15, 0, -1.35), 14)):
        scene.node(name, at=place, rotation=glb.turn_y(turn), mesh=scene.mesh(name, [(paint[colour], patch)]))
    scene.node("plant", mesh=furniture.plant(scene, paint, draw), at=(1.22, 0, -1.72))
    scene.node("chair", mesh=furniture.chair(scene, paint, "mustard"), at=(0.62, 0, -0.95),
               rotation=glb.turn_y(35))
    scene.node("book stack", mesh=furniture.book_stack(scene, paint), at=(-0.72, 0.28, -1.42))


def add_far_side(scene, paint, draw):
    """What is seen in the mirror past the clutter."""
    scene.node("door", mesh=furniture.door(scene, paint), at=(0.65, 0, HALF_Z), rotation=glb.turn_y(180))
    scene.node("bookshelf", mesh=furniture.bookshelf(scene, paint, draw), at=(-1.15, 0, HALF_Z - 0.01),
               rotation=glb.turn_y(180))
    add_framed(scene, paint, "picture", "landscape", 1.35, 0.90, (-HALF_X + GAP, 1.60, 0.1), 90)


def build():
    scene = glb.Glb("Clutter before a mirror", "Written for Utsuri")
    draw = random.Random(SEED).random
    paint = {name: scene.matte(name, colour) for name, colour in MATTE.items()}
    for name, picture, wrap in (("wood", textures.wood(draw), glb.REPEAT),
                                ("landscape", textures.landscape(), glb.CLAMP_TO_EDGE)):
        paint[name] = scene.matte(name, (1.0, 1.0, 1.0), scene.texture(name, picture, wrap=wrap))
    paint["mirror"] = scene.metal("mirror", REFLECTANCE)
    paint["lamp"] = scene.emitter("lamp", LAMP_LUMINANCE)
    add_room(scene, paint)
    add_framed(scene, paint, "mirror", "mirror", MIRROR_WIDTH, MIRROR_HEIGHT,
               (0.0, MIRROR_Y, -HALF_Z + GAP), 0)
    add_clutter(scene, paint, draw)
    add_far_side(scene, paint, draw)
    scene.node("camera", camera=scene.camera("camera", VERTICAL_FOV, 4 / 3), at=CAMERA,
               rotation=glb.look_rotation([t - c for t, c in zip(TARGET, CAMERA)]))
    return scene


if __name__ == "__main__":
    glb.generator_main(build, pathlib.Path(__file__).with_name("cluttered-mirror.glb"))
