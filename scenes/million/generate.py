# SPDX-License-Identifier: Apache-2.0
"""A hall of over a million triangles: a rolling floor and hundreds of detailed objects of eight meshes.

Too large to keep: write it where it is needed with --out.
"""

import argparse
import math
import pathlib
import random
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import glb  # noqa: E402
import shapes  # noqa: E402

DEFAULT_TRIANGLES = 1_100_000
MIN_TRIANGLES = 50_000          # below this the objects, about 2000 triangles each, are too few to spread out
TERRAIN_SHARE = 0.25            # of all triangles
HALF_SIZE, HEIGHT = 20.0, 12.0  # half side and height of the hall, metres
MARGIN = 2.0                    # metres between the objects' centres and the walls
HALL_TRIANGLES = 12             # five faces of the hall and the light
LIGHT_LUMINANCE = (5000.0, 4800.0, 4400.0)
SEED = 1996
PALETTE = ((0.62, 0.22, 0.14), (0.78, 0.55, 0.18), (0.22, 0.42, 0.34), (0.16, 0.30, 0.52), (0.70, 0.66, 0.58))


def ground(x, z):
    """Height of the floor, metres: low waves, at least 0.2."""
    return (1.2 + 0.55 * math.sin(0.31 * x + 0.4) * math.cos(0.27 * z)
            + 0.3 * math.sin(0.83 * x - 0.6 * z) + 0.12 * math.sin(2.1 * x) * math.sin(1.9 * z))


def terrain(triangles):
    cells = math.ceil(math.sqrt(triangles / 2))

    def position_at(u, v):
        x, z = HALF_SIZE * (2 * u - 1), HALF_SIZE * (1 - 2 * v)
        return (x, ground(x, z), z)

    return shapes.grid(cells, cells, position_at)


def displaced_sphere(lobes, rings, depth):
    """A unit sphere pushed in and out by `depth`; its poles stay open by 1.3 % of the radius, so no
    triangle loses its area."""
    pole = 0.004

    def position_at(u, v):
        longitude, latitude = -math.tau * u, math.pi * (pole + (1 - 2 * pole) * v) - math.pi / 2
        # The squared cosine calms the lobes towards the poles, where they crowd together.
        bump = math.cos(lobes * longitude) * math.cos(rings * latitude) * math.cos(latitude) ** 2
        radius = 1 - depth + depth * bump
        return (radius * math.cos(latitude) * math.cos(longitude), radius * math.sin(latitude),
                radius * math.cos(latitude) * math.sin(longitude))

    return shapes.grid(48, 21, position_at, around=True)


def spiral(turns, squeeze):
    steps = 126
    path = []
    for i in range(steps + 1):
        t = i / steps
        radius = 0.75 * (1 - squeeze * t)
        angle = math.tau * turns * t
        path.append((radius * math.cos(angle), 1.8 * t - 0.9, radius * math.sin(angle)))
    return shapes.tube(path, lambda t: 0.14 * (1.15 - t), 8)


def add_hall(scene):
    x, y, z = HALF_SIZE, HEIGHT, HALF_SIZE
    walls = shapes.Patch().add(
        shapes.quad((-x, 0, -z), (x, 0, -z), (x, y, -z), (-x, y, -z)),
        shapes.quad((x, 0, -z), (x, 0, z), (x, y, z), (x, y, -z)),
        shapes.quad((x, 0, z), (-x, 0, z), (-x, y, z), (x, y, z)),
        shapes.quad((-x, 0, z), (-x, 0, -z), (-x, y, -z), (-x, y, z)),
        shapes.quad((-x, y, -z), (x, y, -z), (x, y, z), (-x, y, z)))
    scene.node("hall", mesh=scene.mesh("hall", [(scene.matte("wall", (0.74, 0.73, 0.70)), walls)]))
    half, drop = 6.0, y - 0.02
    light = shapes.quad((-half, drop, -half), (half, drop, -half), (half, drop, half), (-half, drop, half))
    scene.node("light", mesh=scene.mesh("light", [(scene.emitter("light", LIGHT_LUMINANCE), light)]))


def add_objects(scene, triangles, draw):
    """At least `triangles` triangles, on a jittered lattice so that objects keep clear of each other."""
    matte = [scene.matte(f"matte {i}", colour) for i, colour in enumerate(PALETTE)]
    mirror = scene.metal("mirror", (0.9, 0.9, 0.9))
    patches = [displaced_sphere(lobes, rings, depth) for lobes, rings, depth in
               ((3, 2, 0.25), (5, 4, 0.2), (8, 6, 0.15), (2, 7, 0.3))]
    patches += [spiral(turns, squeeze) for turns, squeeze in ((2, 0.5), (3, 0.2), (4, 0.8), (5, 0.0))]
    meshes = [scene.mesh(f"object {i}", [(mirror if i in (2, 5) else matte[i % len(matte)], patch)])
              for i, patch in enumerate(patches)]
    columns = math.ceil(math.sqrt(triangles / min(len(p.triangles) for p in patches)))
    cell = 2 * (HALF_SIZE - MARGIN) / columns
    placed = 0
    for i in range(columns * columns):
        if placed >= triangles:
            break
        column, row = i % columns, i // columns
        x = -HALF_SIZE + MARGIN + cell * (column + 0.3 + 0.4 * draw())
        z = -HALF_SIZE + MARGIN + cell * (row + 0.3 + 0.4 * draw())
        size = cell * (0.2 + 0.15 * draw())
        scene.node(f"object {i}", mesh=meshes[i % len(meshes)], at=(x, ground(x, z) + 1.1 * size, z),
                   rotation=glb.turn_y(360 * draw()), scale=[size] * 3)
        placed += len(patches[i % len(meshes)].triangles)


def build(triangles=DEFAULT_TRIANGLES):
    """A scene of at least `triangles` triangles, over by less than one percent."""
    scene = glb.Glb("Million", "Written for Utsuri")
    floor = terrain(TERRAIN_SHARE * triangles)
    scene.node("terrain", mesh=scene.mesh("terrain", [(scene.matte("terrain", (0.46, 0.42, 0.36)), floor)]))
    add_hall(scene)
    add_objects(scene, triangles - len(floor.triangles) - HALL_TRIANGLES, random.Random(SEED).random)
    position, target = (-14.0, 6.5, 18.5), (1.0, 1.5, -2.0)
    scene.node("camera", camera=scene.camera("camera", 50.0, 4 / 3), at=position,
               rotation=glb.look_rotation([t - p for t, p in zip(target, position)]))
    return scene


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=pathlib.Path, required=True, help="file to write")
    parser.add_argument("--triangles", type=int, default=DEFAULT_TRIANGLES,
                        help="least number of triangles, instances counted (default: %(default)s)")
    arguments = parser.parse_args()
    if arguments.triangles < MIN_TRIANGLES:
        parser.error(f"--triangles {arguments.triangles}: must be at least {MIN_TRIANGLES}")
    arguments.out.write_bytes(build(arguments.triangles).encode())


if __name__ == "__main__":
    main()
