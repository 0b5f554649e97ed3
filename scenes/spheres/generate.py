# SPDX-License-Identifier: Apache-2.0
"""Mirror spheres of three sizes in a room whose walls say which way round they are."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import glb  # noqa: E402
import png  # noqa: E402
import shapes  # noqa: E402

# Half width, height and half depth of the room, metres.
HALF_X, HEIGHT, HALF_Z = 2.0, 3.0, 2.5
TEXELS_PER_METRE = 64
REST = 0.001                # gap under a resting object, metres: no surfaces coincide
SPHERE_LEVEL = 4            # 5120 triangles
PANEL_LUMINANCE = (1500.0, 1450.0, 1350.0)

LETTER_CELL = 12            # texels a dot of the letter
ARROW_LENGTH, ARROW_THICKNESS = 96, 9


def stripes(x, y):
    return (x // 16) % 2


def dots(x, y):
    return int((x % 32 - 16) ** 2 + (y % 32 - 16) ** 2 < 64)


def lattice(x, y):
    return int(x % 32 < 4 or y % 32 < 4)


def diagonals(x, y):
    return (x + y) // 16 % 2


def checker(x, y):
    return (x // 32 + y // 32) % 2


def sign(width, height, letter, pattern, colours):
    """A wall picture: two tones of pattern, a plain field with the letter, an arrow to its right below."""
    picture = png.Picture(width, height, [*colours, (236, 232, 222), (28, 28, 32)])
    picture.paint(pattern)
    letter_width, letter_height = png.LETTER_COLUMNS * LETTER_CELL, png.LETTER_ROWS * LETTER_CELL
    left, top = (width - letter_width) // 2, height // 2 - letter_height // 2 - 20
    picture.rectangle(width // 2 - 64, top - 14, width // 2 + 64, top + letter_height + 54, 2)
    picture.letter(letter, left, top, LETTER_CELL, 3)
    picture.arrow_right((width - ARROW_LENGTH) // 2, top + letter_height + 12, ARROW_LENGTH, ARROW_THICKNESS,
                        colour=3)
    return picture.encode()


def add_room(scene):
    """Each wall is upright and readable from inside the room."""
    x, y, z = HALF_X, HEIGHT, HALF_Z
    long_wall, short_wall, tall = (int(TEXELS_PER_METRE * s) for s in (2 * z, 2 * x, y))
    walls = (
        ("front wall", "F", short_wall, stripes, [(58, 92, 138), (74, 110, 156)],
         [(-x, 0, -z), (x, 0, -z), (x, y, -z), (-x, y, -z)]),
        ("right wall", "R", long_wall, dots, [(168, 74, 58), (206, 122, 88)],
         [(x, 0, -z), (x, 0, z), (x, y, z), (x, y, -z)]),
        ("back wall", "B", short_wall, lattice, [(196, 158, 66), (166, 126, 44)],
         [(x, 0, z), (-x, 0, z), (-x, y, z), (x, y, z)]),
        ("left wall", "L", long_wall, diagonals, [(70, 122, 84), (92, 146, 104)],
         [(-x, 0, z), (-x, 0, -z), (-x, y, -z), (-x, y, z)]))
    for name, letter, width, pattern, colours, corners in walls:
        texture = scene.texture(name, sign(width, tall, letter, pattern, colours), wrap=glb.CLAMP_TO_EDGE)
        material = scene.matte(name, (1.0, 1.0, 1.0), texture)
        scene.node(name, mesh=scene.mesh(name, [(material, shapes.quad(*corners))]))
    tiles = png.Picture(64, 64, [(188, 184, 176), (92, 92, 98)])
    tiles.paint(checker)
    texture = scene.texture("floor", tiles.encode(), magnify=glb.NEAREST)
    material = scene.matte("floor", (0.9, 0.9, 0.9), texture)
    floor = shapes.quad((-x, 0, z), (x, 0, z), (x, 0, -z), (-x, 0, -z), repeat=(2 * x, 2 * z))
    scene.node("floor", mesh=scene.mesh("floor", [(material, floor)]))
    ceiling = shapes.quad((-x, y, -z), (x, y, -z), (x, y, z), (-x, y, z))
    scene.node("ceiling", mesh=scene.mesh("ceiling", [(scene.matte("ceiling", (0.8, 0.8, 0.8)), ceiling)]))


def add_spheres(scene):
    ball = shapes.icosphere(1.0, SPHERE_LEVEL)
    mirror = scene.mesh("mirror sphere", [(scene.metal("mirror", (0.95, 0.95, 0.95)), ball)])
    matte = scene.mesh("matte sphere", [(scene.matte("matte", (0.75, 0.32, 0.22)), ball)])
    for name, mesh, radius, x, z in (("large mirror sphere", mirror, 0.7, -0.65, -0.9),
                                     ("medium mirror sphere", mirror, 0.3, 0.7, -0.35),
                                     ("small mirror sphere", mirror, 0.1, 0.15, 0.1),
                                     ("matte sphere", matte, 0.25, 1.25, -1.2)):
        scene.node(name, mesh=mesh, at=(x, radius + REST, z), scale=[radius] * 3)


def add_lights(scene):
    y = HEIGHT - 0.01
    panel = shapes.quad((-0.5, y, -0.8), (0.5, y, -0.8), (0.5, y, -0.2), (-0.5, y, -0.2))
    emitter = scene.emitter("panel", PANEL_LUMINANCE)
    scene.node("ceiling panel", mesh=scene.mesh("ceiling panel", [(emitter, panel)]))
    point = scene.point_light("point light", (1.0, 0.86, 0.7), 60.0)
    scene.node("point light", light=point, at=(-1.4, 2.2, 1.2))
    position, target = (1.5, 2.7, 0.6), (1.25, 0.25, -1.2)
    spot = scene.spot_light("spot light", (0.8, 0.9, 1.0), 300.0, 12.0, 20.0)
    scene.node("spot light", light=spot, at=position,
               rotation=glb.look_rotation([t - p for t, p in zip(target, position)]))


def build():
    scene = glb.Glb("Mirror spheres", "Written for Utsuri")
    add_room(scene)
    add_spheres(scene)
    add_lights(scene)
    position, target = (0.15, 1.35, 2.3), (0.05, 0.75, -0.8)
    scene.node("camera", camera=scene.camera("camera", 52.0, 4 / 3), at=position,
               rotation=glb.look_rotation([t - p for t, p in zip(target, position)]))
    return scene


if __name__ == "__main__":
    glb.generator_main(build, pathlib.Path(__file__).with_name("spheres.glb"))
