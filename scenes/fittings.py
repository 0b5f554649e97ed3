# SPDX-License-Identifier: Apache-2.0
"""Tables, shelves, screens and partitions with rounded edges: on y = 0, the user at +z.

`paint` maps the names of materials to their numbers.
"""

import math

from shapes import Patch, box
from solids import arc, bar, bent, picture, pipe, rounded_box, turned


def table(scene, paint, name, wood, metal, width=1.6, depth=0.85, height=0.74):
    """A rounded top on two bent frames of tube."""
    top = rounded_box(width, 0.03, depth, 0.008, grain=0.8).moved(0, height - 0.03, 0)
    thick, frames = 0.014, Patch()
    x, z = width / 2 - 0.16, depth / 2 - 0.08
    for side in (-1, 1):
        corners = [(side * x, height - 0.03, -z + 0.02), (side * x, thick, -z), (side * x, thick, z),
                   (side * x, height - 0.03, z - 0.02)]
        frames.add(pipe(bent(corners, 0.06, 2), thick, 8))
    for end in (-1, 1):
        frames.add(bar((-x, 0.55, end * (z - 0.005)), (x, 0.55, end * (z - 0.005)), 0.009))
    return scene.mesh(name, [(paint[wood], top), (paint[metal], frames)])


def round_table(scene, paint, name, wood, metal, radius=0.35, height=0.46):
    rim = arc(0.012, -90, 90, 3, (radius - 0.012, height - 0.012))
    top = turned([(0.0, height - 0.024), *rim, (0.0, height)], 32, (1.0, 1.0))
    # The grain of a turned disc would run around: lay it along x instead.
    top.texcoords = [(x / 0.8, z / 0.8) for x, _, z in top.positions]
    foot = turned([(0.0, 0.0), (0.6 * radius, 0.0), *arc(0.008, -90, 90, 2, (0.6 * radius, 0.008))[1:], (0.06, 0.03),
                   (0.025, 0.06), (0.022, height - 0.06), (0.10, height - 0.024), (0.0, height - 0.024)], 24)
    return scene.mesh(name, [(paint[wood], top), (paint[metal], foot)])


def screen(scene, paint, name, shell, display, wide=0.60, tall=0.35):
    """A monitor that stands on y = 0 and faces +z; its picture is 3 mm behind the rim of its shell."""
    low = 0.13
    back = rounded_box(wide + 0.02, tall + 0.02, 0.022, 0.006).moved(0, low - 0.01, -0.012)
    for side in (-1, 1):
        x, y = side * (wide / 2 + 0.005), low - 0.01 if side < 0 else low + tall
        back.add(box((x - 0.005, low - 0.01, -0.002), (x + 0.005, low + tall + 0.01, 0.003), grain=0.2),
                 box((-wide / 2, y, -0.002), (wide / 2, y + 0.01, 0.003), skip=("-x", "+x"), grain=0.2))
    foot = rounded_box(0.24, 0.010, 0.18, 0.0045)
    neck = pipe(bent([(0, 0.005, -0.05), (0, 0.16, -0.06), (0, 0.26, -0.018)], 0.03, 3), 0.016, 8)
    return scene.mesh(name, [(paint[shell], Patch().add(back, foot, neck)),
                             (paint[display], picture(wide, tall).moved(0, low + tall / 2, 0.0005))])


def keyboard(scene, paint, name, shell, keys):
    """Keys in five rows on a flat case."""
    case = rounded_box(0.42, 0.012, 0.135, 0.004)
    caps = Patch()
    for row in range(5):
        count = 11 if row < 4 else 5
        pitch = 0.40 / count
        for k in range(count):
            cap = box((-0.45 * pitch, 0.0, -0.010), (0.45 * pitch, 0.006, 0.010), skip=("-y",), grain=0.1)
            caps.add(cap.moved(-0.20 + pitch * (k + 0.5), 0.012, -0.052 + 0.026 * row))
    return scene.mesh(name, [(paint[shell], case), (paint[keys], caps)])


def mouse(scene, paint, name, shell):
    profile = [(0.0, 0.0), (0.9, 0.0), (1.0, 0.25), (0.93, 0.6), (0.7, 0.88), (0.35, 0.98), (0.0, 1.0)]
    body = turned(profile, 20, crease=60)
    body.positions = [(0.031 * x, 0.032 * y * (1 - 0.15 * z), 0.055 * z) for x, y, z in body.positions]
    normals = [(x / 0.031, y / 0.032, z / 0.055) for x, y, z in body.normals]
    body.normals = [tuple(c / math.hypot(*n) for c in n) for n in normals]
    return scene.mesh(name, [(paint[shell], body)])


def laptop(scene, paint, name, shell, keys, display):
    """Open; its screen leans back."""
    base = rounded_box(0.32, 0.014, 0.22, 0.005)
    caps = Patch()
    for row in range(5):
        for k in range(10):
            caps.add(box((-0.0125, 0.0, -0.008), (0.0125, 0.0015, 0.008), skip=("-y",), grain=0.1).moved(
                -0.126 + 0.028 * k, 0.014, -0.075 + 0.019 * row))
    lid = rounded_box(0.32, 0.21, 0.007, 0.003).turned("x", -18).moved(0, 0.012, -0.112)
    view = picture(0.30, 0.185).moved(0, 0.108, 0.0042).turned("x", -18).moved(0, 0.012, -0.112)
    return scene.mesh(name, [(paint[shell], Patch().add(base, lid)), (paint[keys], caps), (paint[display], view)])


def shelf(scene, paint, name, wood, metal, width=1.2, height=1.9, depth=0.30, boards=5):
    """Boards between four uprights; returns the mesh and the heights of what stands on the boards."""
    parts, posts, tops = Patch(), Patch(), []
    for k in range(boards):
        y = 0.08 + k * (height - 0.10) / (boards - 1)
        parts.add(box((-width / 2, y, -depth / 2), (width / 2, y + 0.022, depth / 2), grain=0.8))
        tops.append(y + 0.022)
    for x in (-width / 2 - 0.012, width / 2 + 0.012):
        for z in (-depth / 2 + 0.03, depth / 2 - 0.03):
            posts.add(bar((x, 0, z), (x, height, z), 0.012))
    return scene.mesh(name, [(paint[wood], parts), (paint[metal], posts)]), tops


def cabinet(scene, paint, name, wood, front, metal, width=1.2, height=0.55, depth=0.40):
    """A sideboard on a plinth with two doors and knobs; its back is at z = -depth / 2."""
    body = rounded_box(width, height - 0.05, depth, 0.004, 1, grain=0.8).moved(0, 0.05, 0)
    plinth = box((-width / 2 + 0.04, 0.0, -depth / 2 + 0.02), (width / 2 - 0.04, 0.05, depth / 2 - 0.05), grain=0.5)
    doors, knobs = Patch(), Patch()
    for side in (-1, 1):
        door = rounded_box(width / 2 - 0.015, height - 0.08, 0.018, 0.004, 1, grain=0.6)
        doors.add(door.moved(side * width / 4, 0.065, depth / 2 + 0.009))
        knob = turned([(0.0, 0.0), (0.006, 0.0), (0.006, 0.012), *arc(0.006, -60, 90, 2, (0.006, 0.018)), (0.0, 0.024)],
                      10).turned("x", 90)
        knobs.add(knob.moved(side * 0.05, 0.6 * height, depth / 2 + 0.018))
    return scene.mesh(name, [(paint[wood], Patch().add(body, plinth)), (paint[front], doors), (paint[metal], knobs)])


def partition(scene, paint, name, cloth, metal, width=1.6, height=1.5, thick=0.025):
    """A thin screen that stands on the floor along its whole length, with two feet."""
    panel = rounded_box(width, height, thick, 0.004, 1, grain=0.4)
    feet = Patch()
    for side in (-1, 1):
        x = side * (width / 2 - 0.15)
        feet.add(box((x - 0.025, 0.0, -0.20), (x + 0.025, 0.02, 0.20), grain=0.2))
    return scene.mesh(name, [(paint[cloth], panel), (paint[metal], feet)])


def door(scene, paint, name, leaf, casing, metal):
    """On the wall z = 0; a leaf with two panels, a casing, a bent handle on a rose."""
    wood, trim = Patch(), Patch()
    wood.add(rounded_box(0.90, 2.04, 0.03, 0.003, 1, grain=0.8).moved(0, 0.005, 0.016))
    for y, tall in ((0.14, 0.76), (1.06, 0.86)):
        wood.add(rounded_box(0.66, tall, 0.012, 0.005, grain=0.8).moved(0, y, 0.031))
    for side in (-1, 1):
        trim.add(box((side * 0.49 - 0.035, 0.0, 0.0), (side * 0.49 + 0.035, 2.12, 0.036), skip=("-z",), grain=0.5))
    trim.add(box((-0.455, 2.05, 0.0), (0.455, 2.12, 0.036), skip=("-z", "-x", "+x"), grain=0.5))
    rose = turned([(0.0, 0.0), (0.025, 0.0), (0.025, 0.006), (0.0, 0.008)], 20).turned("x", 90).moved(0.40, 1.02, 0.031)
    handle = pipe(bent([(0.40, 1.02, 0.035), (0.40, 1.02, 0.085), (0.28, 1.02, 0.085)], 0.02, 4), 0.009, 10)
    return scene.mesh(name, [(paint[leaf], wood), (paint[casing], trim), (paint[metal], Patch().add(rose, handle))])
