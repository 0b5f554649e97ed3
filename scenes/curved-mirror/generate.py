# SPDX-License-Identifier: Apache-2.0
"""Curved mirrors of few polygons: a vase, a ring and a hollow dish, among patterns near and far."""

import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import furniture  # noqa: E402
import glb  # noqa: E402
import png  # noqa: E402
import shapes  # noqa: E402
from furniture import GAP  # noqa: E402

HALF_X, HEIGHT, HALF_Z = 2.5, 2.8, 2.5      # the room, metres
TABLE_TOP, TABLE_HALF_X, TABLE_HALF_Z, TABLE_Z = 0.75, 0.90, 0.45, -1.85
LAMP_LUMINANCE = (2600.0, 2500.0, 2300.0)   # cd/m2
REFLECTANCE = (0.93, 0.93, 0.92)
CAMERA, TARGET, VERTICAL_FOV = (0.35, 1.62, 0.20), (0.0, 1.20, -2.0), 44.0

# So few polygons that interpolating reflections over them shows.
VASE_COLUMNS, VASE_ROWS = 24, 20
RING_COLUMNS, RING_ROWS = 28, 14
DISH_COLUMNS, DISH_ROWS = 28, 7

# Radius and height of the vase's outside from its foot to its lip, then of its inside down to the neck.
VASE = [(0.095, GAP), (0.155, 0.07), (0.188, 0.18), (0.155, 0.32), (0.085, 0.43), (0.062, 0.50),
        (0.085, 0.56), (0.112, 0.600), (0.100, 0.595), (0.055, 0.50), (0.004, 0.45)]
RING_RADIUS, RING_THICKNESS = 0.19, 0.068
DISH_RADIUS, DISH_DEPTH, DISH_HOLE = 0.40, 0.10, 0.02

MATTE = {"wood": (0.45, 0.27, 0.14), "graphite": (0.045, 0.045, 0.05), "ceiling": (0.84, 0.84, 0.82),
         "red": (0.66, 0.10, 0.07), "yellow": (0.80, 0.58, 0.08), "blue": (0.07, 0.17, 0.46),
         "green": (0.10, 0.36, 0.14), "cream": (0.80, 0.76, 0.66)}


def turned_surface(columns, rows, profile_at):
    """Turns the smooth curve profile_at(v) = (radius, y) about +Y, v in [0, 1]: smooth normals.

    The outside is on the right of the curve's direction of travel.
    """
    step = 1e-4             # of v, for the curve's tangent
    patch = shapes.Patch()
    for row in range(rows + 1):
        v = row / rows
        radius, y = profile_at(v)
        (r0, y0), (r1, y1) = profile_at(v - step), profile_at(v + step)
        for column in range(columns):
            c, s = math.cos(math.tau * column / columns), math.sin(math.tau * column / columns)
            patch.vertex((radius * c, y, -radius * s),
                         shapes.unit(((y1 - y0) * c, r0 - r1, -(y1 - y0) * s)))
    for row in range(rows):
        for column in range(columns):
            a, b = row * columns + column, row * columns + (column + 1) % columns
            patch.triangles += [(a, b, b + columns), (a, b + columns, a + columns)]
    return patch


def vase():
    return turned_surface(VASE_COLUMNS, VASE_ROWS, lambda v: shapes.spline(VASE, v))


def ring():
    """A torus that stands on y = 0, its hole towards z."""
    def profile_at(v):
        angle = math.tau * v
        return RING_RADIUS + RING_THICKNESS * math.cos(angle), RING_THICKNESS * math.sin(angle)

    lying = turned_surface(RING_COLUMNS, RING_ROWS, profile_at)
    return lying.turned("x", 90).moved(0, RING_RADIUS + RING_THICKNESS + GAP, 0)


def dish():
    """A hollow paraboloid that opens to +z, its deepest point at the origin; a knob fills the hole there."""
    def profile_at(v):
        radius = DISH_RADIUS + (DISH_HOLE - DISH_RADIUS) * v
        return radius, DISH_DEPTH * (radius / DISH_RADIUS) ** 2

    return turned_surface(DISH_COLUMNS, DISH_ROWS, profile_at).turned("x", 90)


def pattern(size, colours, colour_at):
    picture = png.Picture(size, size, colours)
    picture.paint(colour_at)
    return picture.encode()


def add_room(scene, paint):
    """One repeat of a pattern is a metre, of the floor two."""
    def bricks(x, y):
        row = y // 16
        return 0 if y % 16 < 2 or (x + 16 * (row % 2)) % 32 < 2 else 1 + row % 2

    patterns = {
        "stripes": ([(40, 78, 118), (226, 220, 204)], lambda x, y: x // 8 % 2),
        "bricks": ([(214, 204, 186), (158, 70, 50), (176, 88, 62)], bricks),
        "diamonds": ([(62, 108, 78), (222, 214, 180)],
                     lambda x, y: int(abs(x % 32 - 15.5) + abs(y % 32 - 15.5) < 12)),
        "rings": ([(204, 158, 60), (122, 62, 74)], lambda x, y: int(math.hypot(x - 31.5, y - 31.5) / 8) % 2),
        "cloth": ([(226, 218, 200), (150, 44, 40)], lambda x, y: (x // 32 + y // 32) % 2),
        "checks": ([(206, 200, 190), (74, 70, 76)], lambda x, y: (x // 32 + y // 32) % 2)}
    for name, (colours, colour_at) in patterns.items():
        texture = scene.texture(name, pattern(64, colours, colour_at))
        paint[name] = scene.matte(name, (0.95, 0.95, 0.95), texture)
    x, y, z = HALF_X, HEIGHT, HALF_Z
    surfaces = (
        ("dish wall", "stripes", [(-x, 0, -z), (x, 0, -z), (x, y, -z), (-x, y, -z)], (2 * x, y)),
        ("right wall", "bricks", [(x, 0, -z), (x, 0, z), (x, y, z), (x, y, -z)], (2 * z, y)),
        ("wall behind the camera", "diamonds", [(x, 0, z), (-x, 0, z), (-x, y, z), (x, y, z)], (2 * x, y)),
        ("left wall", "rings", [(-x, 0, z), (-x, 0, -z), (-x, y, -z), (-x, y, z)], (2 * z, y)),
        ("floor", "checks", [(-x, 0, z), (x, 0, z), (x, 0, -z), (-x, 0, -z)], (x, z)),
        ("ceiling", "ceiling", [(-x, y, -z), (x, y, -z), (x, y, z), (-x, y, z)], (1, 1)))
    for name, material, corners, repeat in surfaces:
        scene.node(name, mesh=scene.mesh(name, [(paint[material], shapes.quad(*corners, repeat=repeat))]))
    pendant = furniture.pendant(scene, paint, length=1.4, width=0.3, drop=0.45)
    for name, along in (("front pendant", 1.2), ("back pendant", -1.0)):
        scene.node(name, mesh=pendant, at=(0, y, along))


def add_table(scene, paint):
    x, z, top = TABLE_HALF_X, TABLE_HALF_Z, TABLE_TOP
    board = shapes.box((-x, top - 0.03, -z), (x, top - 0.002, z))
    for sx in (-1, 1):
        for sz in (-1, 1):
            board.add(shapes.box((sx * (x - 0.06) - 0.03, GAP, sz * (z - 0.06) - 0.03),
                                 (sx * (x - 0.06) + 0.03, top - 0.03 - GAP, sz * (z - 0.06) + 0.03),
                                 skip=("-y", "+y")))
    # A square of the cloth is 0.1 m.
    cloth = shapes.quad((-x, top, z), (x, top, z), (x, top, -z), (-x, top, -z), repeat=(10 * x, 10 * z))
    return scene.node("table", at=(0, 0, TABLE_Z),
                      mesh=scene.mesh("table", [(paint["wood"], board), (paint["cloth"], cloth)]))


def add_mirrors(scene, paint, table):
    for name, patch, place, turn in (("vase", vase(), (-0.40, TABLE_TOP, 0.02), 0),
                                     ("ring", ring(), (0.38, TABLE_TOP, 0.02), 25)):
        scene.node(name, parent=table, at=place, rotation=glb.turn_y(turn),
                   mesh=scene.mesh(name, [(paint["mirror"], patch)]))
    wall = scene.node("dish on the wall", at=(0.03, 1.70, -HALF_Z + 0.03))
    scene.node("dish", parent=wall, mesh=scene.mesh("dish", [(paint["mirror"], dish())]))
    knob = shapes.cylinder(DISH_HOLE + 0.004, -0.029, 0.012, 12).turned("x", 90)
    scene.node("knob", parent=wall, mesh=scene.mesh("knob", [(paint["graphite"], knob)]))


def add_blocks(scene, paint, table):
    """Toy blocks around the mirrors, some of them a few centimetres away."""
    for i, (colour, size, x, z, turn) in enumerate((
            ("red", 0.09, -0.68, 0.20, 20), ("yellow", 0.07, -0.17, 0.22, -15),
            ("blue", 0.11, -0.08, -0.20, 35), ("green", 0.08, 0.10, 0.28, 10),
            ("cream", 0.07, 0.66, 0.26, -30), ("red", 0.10, 0.76, -0.10, 15),
            ("blue", 0.06, 0.36, 0.33, 40), ("yellow", 0.12, -0.74, -0.20, 5))):
        half = size / 2
        cube = shapes.box((-half, GAP, -half), (half, size, half), skip=("-y",))
        scene.node(f"block {i + 1}", parent=table, at=(x, TABLE_TOP, z), rotation=glb.turn_y(turn),
                   mesh=scene.mesh(f"block {i + 1}", [(paint[colour], cube)]))


def build():
    scene = glb.Glb("Curved mirrors", "Written for Utsuri")
    paint = {name: scene.matte(name, colour) for name, colour in MATTE.items()}
    paint["mirror"] = scene.metal("mirror", REFLECTANCE)
    paint["lamp"] = scene.emitter("lamp", LAMP_LUMINANCE)
    add_room(scene, paint)
    table = add_table(scene, paint)
    add_mirrors(scene, paint, table)
    add_blocks(scene, paint, table)
    scene.node("camera", camera=scene.camera("camera", VERTICAL_FOV, 4 / 3), at=CAMERA,
               rotation=glb.look_rotation([t - c for t, c in zip(TARGET, CAMERA)]))
    return scene


if __name__ == "__main__":
    glb.generator_main(build, pathlib.Path(__file__).with_name("curved-mirror.glb"))
