# SPDX-License-Identifier: Apache-2.0
"""An office of about 3,500 triangles, pure Lambert, with a plane mirror, a chrome ball and rough metal."""

import math
import pathlib
import random
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import furniture  # noqa: E402
import glb  # noqa: E402
import shapes  # noqa: E402
import textures  # noqa: E402
from furniture import GAP  # noqa: E402

HALF_X, HEIGHT, HALF_Z = 3.0, 3.0, 2.0      # the room: 6 x 3 x 4 metres
PANEL_LUMINANCE = (3500.0, 3400.0, 3200.0)  # cd/m2, an office luminaire
BALL_RADIUS, BALL_LEVEL = 0.3, 3            # 1280 triangles: the outline looks round
MIRROR_WIDTH, MIRROR_HEIGHT, MIRROR_GAP = 2.84, 1.40, 0.015
MIRROR_X, MIRROR_Y = 0.20, 1.60
FRAME_OVERLAP = 0.005                       # the frame covers this much of the mirror's rim
CAMERA, TARGET, VERTICAL_FOV = (2.70, 1.60, 1.75), (-0.42, 0.92, -0.90), 55.0
SEED = 1996

MATTE = {
    "wall": (0.78, 0.75, 0.69), "accent wall": (0.13, 0.27, 0.30), "ceiling": (0.84, 0.84, 0.82),
    "skirting": (0.80, 0.78, 0.74), "steel": (0.22, 0.23, 0.25), "graphite": (0.045, 0.045, 0.05),
    "screen": (0.012, 0.014, 0.018), "keys": (0.20, 0.20, 0.21), "mustard": (0.72, 0.42, 0.06),
    "teal": (0.06, 0.30, 0.33), "rust": (0.55, 0.16, 0.07), "plum": (0.24, 0.08, 0.17),
    "cream": (0.80, 0.76, 0.66),
    "terracotta": (0.60, 0.25, 0.13), "soil": (0.06, 0.04, 0.03), "leaf": (0.10, 0.33, 0.08),
    "board": (0.86, 0.87, 0.88),
}


def make_paint(scene, draw):
    paint = {name: scene.matte(name, colour) for name, colour in MATTE.items()}
    paint["carpet"] = scene.matte("carpet", (1.0, 1.0, 1.0), scene.texture("carpet", textures.carpet(draw)))
    paint["wood"] = scene.matte("wood", (1.0, 1.0, 1.0), scene.texture("wood", textures.wood(draw)))
    view = scene.texture("landscape", textures.landscape(), wrap=glb.CLAMP_TO_EDGE)
    paint["landscape"] = scene.matte("landscape", (1.0, 1.0, 1.0), view)
    paint["mirror"] = scene.metal("mirror", (0.95, 0.95, 0.95))
    paint["chrome"] = scene.metal("chrome", (0.77, 0.78, 0.78))
    paint["rough metal"] = scene.metal("rough metal", (0.91, 0.79, 0.60), roughness=0.3)
    paint["panel"] = scene.emitter("panel", PANEL_LUMINANCE)
    return paint


def add_room(scene, paint):
    x, y, z = HALF_X, HEIGHT, HALF_Z
    surfaces = (
        ("floor", "carpet", [(-x, 0, z), (x, 0, z), (x, 0, -z), (-x, 0, -z)]),
        ("ceiling", "ceiling", [(-x, y, -z), (x, y, -z), (x, y, z), (-x, y, z)]),
        ("mirror wall", "wall", [(-x, 0, -z), (x, 0, -z), (x, y, -z), (-x, y, -z)]),
        ("right wall", "wall", [(x, 0, -z), (x, 0, z), (x, y, z), (x, y, -z)]),
        ("door wall", "wall", [(x, 0, z), (-x, 0, z), (-x, y, z), (x, y, z)]),
        ("picture wall", "accent wall", [(-x, 0, z), (-x, 0, -z), (-x, y, -z), (-x, y, z)]))
    for name, material, corners in surfaces:
        # One repeat of the carpet is one metre.
        patch = shapes.quad(*corners, repeat=(2 * x, 2 * z))
        scene.node(name, mesh=scene.mesh(name, [(paint[material], patch)]))
    skirting = shapes.Patch().add(
        shapes.box((-x + 0.02, GAP, -z + GAP), (x - 0.02, 0.08, -z + 0.015), skip=("-y", "-z", "-x", "+x")),
        shapes.box((-x + GAP, GAP, -z + 0.02), (-x + 0.015, 0.08, z - 0.02), skip=("-y", "-x", "-z", "+z")))
    scene.node("skirting", mesh=scene.mesh("skirting", [(paint["skirting"], skirting)]))
    panel = furniture.ceiling_panel(scene, paint)
    for i in range(8):
        scene.node(f"ceiling panel {i + 1}", mesh=panel,
                   at=(-2.1 + 1.4 * (i % 4), HEIGHT, -0.9 if i < 4 else 0.9))


def add_wall_objects(scene, paint, draw):
    mirror = scene.node("mirror on the wall", at=(MIRROR_X, MIRROR_Y, -HALF_Z + GAP))
    w, h = MIRROR_WIDTH / 2, MIRROR_HEIGHT / 2
    glass = shapes.quad((-w, -h, 0), (w, -h, 0), (w, h, 0), (-w, h, 0))
    scene.node("mirror", parent=mirror, at=(0, 0, MIRROR_GAP),
               mesh=scene.mesh("mirror", [(paint["mirror"], glass)]))
    rim = furniture.frame(MIRROR_WIDTH, MIRROR_HEIGHT, 0.05, 0.035, FRAME_OVERLAP)
    scene.node("mirror frame", parent=mirror, mesh=scene.mesh("mirror frame", [(paint["graphite"], rim)]))

    width, height = 1.35, 0.90
    picture = scene.node("picture on the wall", at=(-HALF_X + GAP, 1.62, -0.35), rotation=glb.turn_y(90))
    w, h = width / 2, height / 2
    view = shapes.quad((-w, -h, 0), (w, -h, 0), (w, h, 0), (-w, h, 0))
    scene.node("picture", parent=picture, at=(0, 0, 0.012),
               mesh=scene.mesh("picture", [(paint["landscape"], view)]))
    rim = furniture.frame(width, height, 0.04, 0.03, FRAME_OVERLAP)
    rim.add(shapes.box((-0.012, -h + 0.01, 0.013), (0.012, h - 0.01, 0.026), skip=("-z", "-y", "+y")))
    scene.node("picture frame", parent=picture, mesh=scene.mesh("picture frame", [(paint["cream"], rim)]))

    scene.node("door", mesh=furniture.door(scene, paint), at=(-0.55, 0, HALF_Z), rotation=glb.turn_y(180))
    scene.node("bookshelf", mesh=furniture.bookshelf(scene, paint, draw), at=(-2.05, 0, HALF_Z - 0.01),
               rotation=glb.turn_y(180))
    board = shapes.box((-0.9, -0.55, 0), (0.9, 0.55, 0.02), skip=("-z",))
    tray = shapes.box((-0.4, -0.60, 0), (0.4, -0.58, 0.07), skip=("-z",))
    scene.node("whiteboard", at=(HALF_X - GAP, 1.55, 0.2), rotation=glb.turn_y(-90), mesh=scene.mesh(
        "whiteboard", [(paint["board"], board), (paint["steel"], tray)]))


def add_workstations(scene, paint):
    """Two by two desks back to back. The third chair is a mirror image of the first."""
    desk, monitor = furniture.desk(scene, paint), furniture.monitor(scene, paint)
    keyboard, mouse = furniture.keyboard(scene, paint), furniture.mouse(scene, paint)
    chairs = {fabric: furniture.chair(scene, paint, fabric) for fabric in ("mustard", "rust")}
    places = (("1", -0.48, 0.47, 0, "mustard", (0.12, 0.66), 24, False),
              ("2", -1.80, 0.47, 0, "rust", (-0.05, 0.62), -18, False),
              ("3", -0.48, -0.27, 180, "mustard", (0.02, 0.72), -28, True),
              ("4", -1.80, -0.27, 180, "rust", (0.06, 0.66), 35, False))
    for number, x, z, facing, fabric, (chair_x, chair_z), turn, mirrored in places:
        place = scene.node(f"workstation {number}", at=(x, 0, z), rotation=glb.turn_y(facing))
        scene.node(f"desk {number}", parent=place, mesh=desk)
        top = furniture.DESK_HEIGHT
        scene.node(f"monitor {number}", parent=place, mesh=monitor, at=(-0.08, top, -0.16),
                   rotation=glb.turn_y(6))
        scene.node(f"keyboard {number}", parent=place, mesh=keyboard, at=(-0.06, top, 0.16))
        scene.node(f"mouse {number}", parent=place, mesh=mouse, at=(0.26, top, 0.17), rotation=glb.turn_y(12))
        scene.node(f"chair {number}", parent=place, mesh=chairs[fabric], at=(chair_x, 0, chair_z),
                   rotation=glb.turn_y(turn), scale=(-1, 1, 1) if mirrored else None)


def add_loose_objects(scene, paint, draw):
    stand, ring_radius, rim = furniture.ball_stand(scene, paint)
    place = scene.node("ball stand", mesh=stand, at=(0.50, 0, 0.10), rotation=glb.turn_y(90))
    rest = rim + math.sqrt(BALL_RADIUS ** 2 - ring_radius ** 2) + GAP
    ball = scene.mesh("chrome ball", [(paint["chrome"], shapes.icosphere(BALL_RADIUS, BALL_LEVEL))])
    scene.node("chrome ball", parent=place, mesh=ball, at=(0, rest, 0))
    scene.node("sideboard", mesh=furniture.sideboard(scene, paint), at=(0.15, 0, -HALF_Z + 0.02))
    scene.node("rough metal lamp", mesh=furniture.lamp(scene, paint), at=(-0.35, 0.60, -HALF_Z + 0.23))
    scene.node("book stack", mesh=furniture.book_stack(scene, paint), at=(0.62, 0.60, -HALF_Z + 0.22))
    scene.node("rough metal bin", mesh=furniture.waste_bin(scene, paint), at=(1.20, 0, -0.75))
    scene.node("plant", mesh=furniture.plant(scene, paint, draw), at=(-2.45, 0, -1.45))


def build():
    scene = glb.Glb("Office", "Written for Utsuri")
    draw = random.Random(SEED).random
    paint = make_paint(scene, draw)
    add_room(scene, paint)
    add_wall_objects(scene, paint, draw)
    add_workstations(scene, paint)
    add_loose_objects(scene, paint, draw)
    scene.node("camera", camera=scene.camera("camera", VERTICAL_FOV, 4 / 3), at=CAMERA,
               rotation=glb.look_rotation([t - c for t, c in zip(TARGET, CAMERA)]))
    return scene


if __name__ == "__main__":
    glb.generator_main(build, HERE / "office-lambert.glb")
