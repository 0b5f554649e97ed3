# SPDX-License-Identifier: Apache-2.0
"""The Cornell box with a mirror before its tall block, and a tiled room behind the camera."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import cornell_box as data  # noqa: E402
import glb  # noqa: E402
import png  # noqa: E402
import shapes  # noqa: E402
from cornell_box import block, polygon, ring  # noqa: E402

# Lengths in the data's unit, millimetres.
FRONT = -1200.0             # z of the wall behind the camera, which is at -800
FRONT_LIGHT_SHIFT = -850.0  # from the published light to the one in the tiled room
TILE = 70.0                 # edge of a tile
MIRROR_GAP = 4.0            # between the tall block and the mirror
MIRROR_RIM = 8.0            # of the block's face around the mirror
LUMINANCE_SCALE = 100.0     # makes the light's triple the cd/m2 of a bright lamp
MIRROR_REFLECTANCE = (0.95, 0.95, 0.95)


def tiles():
    """Two by two tiles, pale and blue, and the joints between them."""
    size, tile, joint = 32, 16, 2
    picture = png.Picture(size, size, [(226, 226, 226), (64, 118, 176), (120, 116, 108)])

    def colour_at(x, y):
        if x % tile < joint or y % tile < joint:
            return 2
        return (x // tile + y // tile) % 2

    picture.paint(colour_at)
    return picture.encode()


def tiled(bottom_left, bottom_right, height):
    """An upright wall, seen from its front."""
    length = sum((a - b) ** 2 for a, b in zip(bottom_left, bottom_right)) ** 0.5
    repeat = 2 * TILE
    top = [(p[0], height, p[2]) for p in (bottom_right, bottom_left)]
    return shapes.quad(bottom_left, bottom_right, *top, repeat=(length / repeat, height / repeat))


def mirror():
    """A rectangle before the face of the tall block that looks to the opening, seen from its front."""
    left, right = data.TALL_BLOCK_TOP[0], data.TALL_BLOCK_TOP[1]
    along = shapes.unit(shapes.minus(right, left))
    out = shapes.cross(along, (0.0, 1.0, 0.0))
    bottom, top = MIRROR_RIM, left[1] - MIRROR_RIM

    def corner(end, inwards, y):
        return (end[0] + inwards * along[0] + MIRROR_GAP * out[0], y,
                end[2] + inwards * along[2] + MIRROR_GAP * out[2])

    return polygon([corner(left, MIRROR_RIM, bottom), corner(right, -MIRROR_RIM, bottom),
                    corner(right, -MIRROR_RIM, top), corner(left, MIRROR_RIM, top)])


def tiled_room(white, tile, light):
    """Goes on where the box is open, with a light of its own."""
    left, right, height = data.FLOOR[0][0], 0.0, data.CEILING[0][1]
    top_left = data.CEILING[0][0]
    floor = [(left, 0, FRONT), (right, 0, FRONT), (right, 0, 0), (left, 0, 0)]
    ceiling = [(top_left, height, FRONT), (top_left, height, 0), (right, height, 0), (right, height, FRONT)]
    lamp = [(x, y, z + FRONT_LIGHT_SHIFT) for x, y, z in data.LIGHT]
    walls = shapes.Patch().add(
        tiled((right, 0, 0), (right, 0, FRONT), height),
        tiled((right, 0, FRONT), (left, 0, FRONT), height),
        tiled((left, 0, FRONT), (left, 0, 0), height))
    return (("front floor", white, polygon(floor)), ("front ceiling", white, ring(ceiling, lamp)),
            ("tiled walls", tile, walls), ("front light", light, polygon(lamp)))


def build():
    about = "Box: Cornell Box Data, Program of Computer Graphics, Cornell; the rest: written for Utsuri"
    scene = glb.Glb("Cornell box with a mirror", about)
    white, red, green = (scene.matte(*m) for m in (
        ("white", data.WHITE), ("red", data.RED), ("green", data.GREEN)))
    tile = scene.matte("tiles", (1.0, 1.0, 1.0), scene.texture("tiles", tiles()))
    light = scene.emitter("light", [LUMINANCE_SCALE * c for c in data.LIGHT_LUMINANCE])
    glass = scene.metal("mirror", MIRROR_REFLECTANCE)
    box = scene.node("cornell box", scale=[data.METRES_PER_UNIT] * 3)
    for name, material, patch in (
            ("floor", white, polygon(data.FLOOR)),
            ("ceiling", white, ring(data.CEILING, data.LIGHT)),
            ("back wall", white, polygon(data.BACK_WALL)),
            ("right wall", green, polygon(data.RIGHT_WALL)),
            ("left wall", red, polygon(data.LEFT_WALL)),
            ("light", light, polygon(data.LIGHT)),
            ("short block", white, block(data.SHORT_BLOCK_TOP)),
            ("tall block", white, block(data.TALL_BLOCK_TOP)),
            ("mirror", glass, mirror()),
            *tiled_room(white, tile, light)):
        scene.node(name, parent=box, mesh=scene.mesh(name, [(material, patch)], normals=False))
    data.add_camera(scene)
    return scene


if __name__ == "__main__":
    glb.generator_main(build, pathlib.Path(__file__).with_name("mirror-cornell.glb"))
