# SPDX-License-Identifier: Apache-2.0
"""Lamps as exporters write them: bulbs of some hundred triangles in thin shades, tubes, panels below a ceiling.

They stand on y = 0, or hang below it. `paint` maps the names of materials to their numbers.
"""

import math

from shapes import Patch, box, quad
from solids import arc, ball, bar, bent, curve, pipe, rounded_box, turned

BULB_RADIUS = 0.045


def bulb(radius=BULB_RADIUS):
    """A round bulb with its neck upwards; its middle is the origin. 224 triangles."""
    return ball(radius, 14, 9)


def _socket(radius=BULB_RADIUS):
    """Holds a bulb from above."""
    start = 0.9 * radius
    return turned([(0.0, start), (0.018, start), (0.020, start + 0.01), (0.020, start + 0.05),
                   (0.008, start + 0.06), (0.0, start + 0.06)], 12)


def floor_lamp(scene, paint, name, metal, shade, light):
    """1.6 m tall; the shade is one sheet, open above and below."""
    top = 1.34
    foot = turned([(0.0, 0.0), (0.14, 0.0), *arc(0.008, -90, 90, 2, (0.14, 0.008))[1:], (0.03, 0.022), (0.012, 0.04),
                   (0.0, 0.04)], 24)
    pole = bar((0, 0.03, 0), (0, top, 0), 0.009, 12)
    holder = turned([(0.0, top), (0.018, top), (0.02, top + 0.05), (0.0, top + 0.05)], 16)
    ring = Patch()
    for k in range(3):
        ring.add(bar((0, 1.345, 0), (0, 1.345, 0.221), 0.003, 6).turned("y", 120 * k))
    cone = turned([(0.23, 1.30), (0.19, 1.45), (0.15, 1.60)], 40, (4.0, 1.0))
    lit = bulb().moved(0, top + 0.05 + 0.97 * BULB_RADIUS, 0)
    return scene.mesh(name, [(paint[metal], Patch().add(foot, pole, holder, ring)), (paint[shade], cone),
                             (paint[light], lit)])


def pendant_lamp(scene, paint, name, metal, cord, shade, light, drop=0.9):
    """Hangs from the ceiling at y = 0 by a cord; a bell of one sheet over a bulb."""
    rose = turned([(0.0, -0.03), (0.02, -0.03), (0.05, -0.012), (0.05, 0.0), (0.0, 0.0)], 16)
    bell = [(x, y - drop) for x, y in
            curve([(0.19, -0.20), (0.17, -0.12), (0.11, -0.045), (0.05, -0.012), (0.021, 0.0)], 6)]
    middle = -drop - 0.125
    wire = bar((0, -0.03, 0), (0, -drop + 0.01, 0), 0.003, 6)
    neck = turned([(0.0, -drop - 0.005), (0.0215, -drop - 0.005), (0.0215, -drop + 0.004), (0.008, -drop + 0.03),
                   (0.0, -drop + 0.03)], 12)
    return scene.mesh(name, [(paint[metal], Patch().add(rose, neck, _socket().moved(0, middle, 0))),
                             (paint[cord], wire), (paint[shade], turned(bell, 28, (4.0, 1.0))),
                             (paint[light], bulb().moved(0, middle, 0))])


def desk_lamp(scene, paint, name, metal, shade, light):
    """Two arms and a tilted cone with a bulb."""
    foot = turned([(0.0, 0.0), (0.085, 0.0), *arc(0.008, -90, 90, 2, (0.085, 0.008))[1:], (0.02, 0.02), (0.0, 0.02)],
                  20)
    arms = Patch()
    elbow, wrist = (-0.10, 0.30, 0.0), (0.13, 0.44, 0.0)
    arms.add(bar((0, 0.015, 0), elbow, 0.006), bar(elbow, wrist, 0.006))
    for joint in (elbow, wrist):
        knob = turned([(0.0, -0.014), (0.012, -0.014), (0.012, 0.014), (0.0, 0.014)], 14).turned("x", 90)
        arms.add(knob.moved(*joint))
    cone = curve([(0.085, -0.13), (0.075, -0.09), (0.045, -0.03), (0.02, 0.0)], 5)
    hood = turned(cone, 20, (3.0, 1.0)).add(turned([(0.02, 0.0), (0.02, 0.03), (0.0, 0.032)], 14))
    lit = bulb(0.03).moved(0, -0.075, 0)
    cap = turned([(0.0, -0.05), (0.014, -0.05), (0.014, 0.0), (0.0, 0.0)], 12)
    head = [part.turned("z", 28).moved(wrist[0] + 0.016, wrist[1] - 0.024, 0) for part in (hood, lit, cap)]
    return scene.mesh(name, [(paint[metal], Patch().add(foot, arms, head[2])), (paint[shade], head[0]),
                             (paint[light], head[1])])


def tube_lamp(scene, paint, name, housing, light, length=1.2, drop=0.0):
    """A fluorescent tube along x below a housing that touches the ceiling at y = 0, or hangs `drop` below it."""
    body = rounded_box(length + 0.08, 0.035, 0.07, 0.008, 1).moved(0, -0.035 - drop, 0)
    for side in (-1, 1):
        x = side * (length / 2 + 0.012)
        body.add(box((x - 0.012, -0.083 - drop, -0.017), (x + 0.012, -0.031 - drop, 0.017), grain=0.2))
        if drop:
            x = side * 0.4 * length
            body.add(bar((x, -drop, 0), (x, 0, 0), 0.003, 6))
    y = -0.062 - drop
    tube = pipe([(-length / 2, y, 0), (length / 2, y, 0)], 0.013, 12, caps=False)
    return scene.mesh(name, [(paint[housing], body), (paint[light], tube)])


def panel_lamp(scene, paint, name, rim, light, width=1.2, depth=0.3, gap=0.02):
    """A luminous plate `gap` below the ceiling at y = 0, in a narrow rim, on four pins; it shines both ways."""
    x, z = width / 2, depth / 2
    plate = quad((-x, -gap, -z), (x, -gap, -z), (x, -gap, z), (-x, -gap, z))
    edge = Patch()
    for side in (-1, 1):
        near, far = sorted((side * z, side * (z + 0.01)))
        edge.add(box((-x - 0.01, -gap - 0.008, near), (x + 0.01, -gap + 0.008, far), grain=0.2))
        near, far = sorted((side * x, side * (x + 0.01)))
        edge.add(box((near, -gap - 0.008, -z), (far, -gap + 0.008, z), skip=("-z", "+z"), grain=0.2))
        for end in (-1, 1):
            edge.add(bar(*((side * 0.8 * x, y, end * (z + 0.005)) for y in (-gap, 0.0)), 0.003, 6))
    return scene.mesh(name, [(paint[rim], edge), (paint[light], plate)])


def wall_lamp(scene, paint, name, metal, shade, light):
    """A half-open cylinder on an arm from the wall z = 0, with a bulb in it."""
    plate = turned([(0.0, 0.0), (0.05, 0.0), (0.05, 0.008), (0.035, 0.014), (0.0, 0.014)], 24).turned("x", 90)
    arm = pipe(bent([(0, 0, 0.01), (0, 0, 0.12), (0, 0.06, 0.12)], 0.03, 4), 0.007, 8)
    holder = turned([(0.0, 0.05), (0.017, 0.05), (0.017, 0.09), (0.0, 0.09)], 14).moved(0, 0, 0.12)
    sheet = turned([(0.075, 0.04), (0.075, 0.24)], 32, (3.0, 1.0)).moved(0, 0, 0.12)
    spokes = Patch()
    for k in range(3):
        angle = math.tau * k / 3
        spokes.add(bar((0, 0.06, 0.12), (0.0745 * math.cos(angle), 0.06, 0.12 + 0.0745 * math.sin(angle)), 0.0025, 6))
    return scene.mesh(name, [(paint[metal], Patch().add(plate, arm, holder, spokes)), (paint[shade], sheet),
                             (paint[light], bulb(0.035).moved(0, 0.124, 0.12))])


def desk_strip(scene, paint, name, metal, light, length=0.5):
    """A strip light that lies under a shelf at y = 0."""
    channel = box((-length / 2, -0.012, -0.012), (length / 2, 0.0, 0.012), skip=("-y",), grain=0.2)
    glow = quad((-length / 2, -0.011, -0.011), (length / 2, -0.011, -0.011), (length / 2, -0.011, 0.011),
                (-length / 2, -0.011, 0.011))
    return scene.mesh(name, [(paint[metal], channel), (paint[light], glow)])


def table_lamp(scene, paint, name, metal, shade, light):
    """Stands on y = 0: a turned foot below a cone of one sheet with a bulb in it."""
    foot = turned([(0.0, 0.0), (0.075, 0.0), *arc(0.008, -90, 90, 2, (0.075, 0.008))[1:],
                   *curve([(0.03, 0.024), (0.05, 0.08), (0.035, 0.16), (0.012, 0.21)], 8), (0.012, 0.27), (0.018, 0.27),
                   (0.018, 0.31), (0.0, 0.31)], 24)
    ring = Patch()
    for k in range(3):
        ring.add(bar((0, 0.29, 0), (0, 0.29, 0.1655), 0.0025, 6).turned("y", 120 * k))
    cone = turned([(0.17, 0.27), (0.135, 0.37), (0.10, 0.47)], 36, (4.0, 1.0))
    lit = bulb(0.04).moved(0, 0.31 + 0.038, 0)
    return scene.mesh(name, [(paint[metal], Patch().add(foot, ring)), (paint[shade], cone), (paint[light], lit)])
