# SPDX-License-Identifier: Apache-2.0
"""Smooth chairs and sofas as meshes in their own frames: on y = 0, the sitter looks to +z.

`paint` maps the names of materials to their numbers.
"""

import math

from shapes import Patch
from solids import arc, bar, bent, curve, pillow, pipe, rounded_box, turned, warped


def tube_chair(scene, paint, name, fabric, metal):
    """A cantilever chair on two runners of bent tube."""
    thick, half, seat = 0.011, 0.19, 0.43
    frame = Patch()
    for x in (-half, half):
        corners = [(x, seat, -0.17), (x, seat, 0.20), (x, thick, 0.22), (x, thick, -0.21), (x, 0.82, -0.25)]
        frame.add(pipe(bent(corners, 0.05, 2), thick, 8))
    for z in (0.10, -0.10):
        frame.add(bar((-half, seat, z), (half, seat, z), 0.008, 6))
    cushion = pillow(0.42, 0.045, 0.40, 0.02, 0.012, 1, 2).moved(0, seat + thick, 0.0)
    back = rounded_box(0.43, 0.26, 0.028, 0.0135, 1, (3, 0, 0), 0.3)
    back = warped(back, lambda x, y, z: (x, y, z + 0.25 * x * x - 0.009), 50)
    back = back.turned("x", -3.0).moved(0, 0.55, -0.213)
    return scene.mesh(name, [(paint[fabric], Patch().add(cushion, back)), (paint[metal], frame)])


def office_chair(scene, paint, name, fabric, plastic, metal):
    """Swivels on five castors, with armrests. A lever under the seat on +x tells it from its mirror image."""
    seat = pillow(0.49, 0.07, 0.47, 0.033, 0.02, 1, 4).moved(0, 0.43, 0)
    seat = warped(seat, lambda x, y, z: (x, y - 0.9 * max(0.0, z - 0.12) ** 2, z), 50)
    back = rounded_box(0.45, 0.54, 0.05, 0.024, 1, (4, 3, 0), 0.3)
    back = warped(back, lambda x, y, z: (
        x * (1 - 0.35 * (y - 0.27) ** 2), y, z + 0.45 * x * x - 0.25 * (y - 0.18) ** 2), 50)
    back = back.turned("x", -8).moved(0, 0.56, -0.225)
    column = turned([(0.0, 0.085), (0.055, 0.085), (0.05, 0.13), (0.032, 0.15), (0.032, 0.27), (0.02, 0.28),
                     (0.02, 0.41), (0.07, 0.42), (0.07, 0.431), (0.0, 0.431)], 16)
    spine = pipe(curve([(0, 0.418, -0.05), (0, 0.42, -0.20), (0, 0.50, -0.285), (0, 0.70, -0.30)], 6), 0.016, 8)
    lever = pipe(bent([(0.05, 0.42, 0.02), (0.20, 0.42, 0.02), (0.27, 0.405, 0.03)], 0.02), 0.006, 8)
    legs, castors, arms = Patch(), Patch(), Patch()
    for k in range(5):
        spoke = pipe([(0, 0.11, 0.03), (0, 0.078, 0.30)], lambda t: 0.022 - 0.008 * t, 8)
        pin = bar((0, 0.045, 0.285), (0, 0.08, 0.285), 0.008, 6)
        wheel = turned([(0.0, -0.02), (0.024, -0.02), (0.03, -0.012), (0.03, 0.012), (0.024, 0.02), (0.0, 0.02)], 8)
        legs.add(Patch().add(spoke, pin).turned("y", 72 * k))
        castors.add(wheel.turned("z", 90).moved(0, 0.03, 0.285).turned("y", 72 * k))
    for side in (-1, 1):
        corners = [(0.18 * side, 0.436, 0), (0.275 * side, 0.436, 0), (0.275 * side, 0.655, -0.02)]
        legs.add(pipe(bent(corners, 0.05), 0.011, 8))
        arms.add(rounded_box(0.07, 0.03, 0.25, 0.014).moved(0.275 * side, 0.65, 0.0))
    return scene.mesh(name, [(paint[fabric], Patch().add(seat, back)),
                             (paint[metal], Patch().add(column, spine, lever, legs)),
                             (paint[plastic], Patch().add(arms, castors))])


def sofa(scene, paint, name, fabric, wood, width=1.9, places=2):
    """Cushions in a low frame on turned legs."""
    inner = width - 0.36
    frame = Patch().add(
        rounded_box(width, 0.20, 0.86, 0.03, grain=0.3).moved(0, 0.14, 0),
        rounded_box(width, 0.46, 0.18, 0.06, grain=0.3).moved(0, 0.34, -0.34))
    for side in (-1, 1):
        frame.add(rounded_box(0.18, 0.27, 0.68, 0.06, grain=0.3).moved(side * (width / 2 - 0.09), 0.34, 0.09))
    legs = Patch()
    for x in (-width / 2 + 0.10, width / 2 - 0.10):
        for z in (-0.33, 0.33):
            legs.add(turned([(0.0, 0.0), (0.016, 0.0), (0.028, 0.14), (0.0, 0.14)], 12).moved(x, 0, z))
    cushions = Patch()
    each = inner / places
    for k in range(places):
        x = -inner / 2 + each * (k + 0.5)
        cushions.add(pillow(each - 0.006, 0.14, 0.66, 0.05, 0.03, 1, 3).moved(x, 0.34, 0.085))
        back = pillow(each - 0.02, 0.15, 0.42, 0.06, 0.05, 1, 3).turned("x", 78)
        cushions.add(back.moved(x, 0.703, -0.247))
    return scene.mesh(name, [(paint[fabric], Patch().add(frame, cushions)), (paint[wood], legs)])


def throw_pillow(scene, paint, name, fabric):
    """Lies on y = 0, thick in the middle and thin at its seam."""
    half = rounded_box(0.42, 0.10, 0.42, 0.02, 1, (5, 0, 5), 0.25)

    def place(x, y, z):
        full = (1 - (x / 0.212) ** 2) * (1 - (z / 0.212) ** 2)
        return (x, 0.05 + (y - 0.05) * (0.12 + 1.1 * max(0.0, full) ** 0.6), z)

    half = warped(half, place, 80)
    lowest = min(p[1] for p in half.positions)
    return scene.mesh(name, [(paint[fabric], half.moved(0, -lowest, 0))])


def stool(scene, paint, name, wood, metal):
    """A round seat on three splayed legs with a ring."""
    rim = arc(0.018, -90, 90, 4, (0.16, 0.602))
    seat = turned([(0.0, 0.584), *rim, (0.09, 0.612), (0.0, 0.609)], 32, (3.0, 1.0))
    legs = Patch()
    for k in range(3):
        legs.add(bar((0.10, 0.59, 0), (0.20, 0.006, 0), 0.012).turned("y", 120 * k + 20))
    for k in range(3):
        a, b = (math.radians(120 * n + 20) for n in (k, k + 1))
        ends = [(0.168 * math.cos(t), 0.19, -0.168 * math.sin(t)) for t in (a, b)]
        legs.add(bar(*ends, 0.006, 6))
    legs = _stand(legs)
    return scene.mesh(name, [(paint[wood], seat), (paint[metal], legs)])


def _stand(patch):
    """Moved so that the lowest point is on y = 0."""
    return patch.moved(0, -min(p[1] for p in patch.positions), 0)
