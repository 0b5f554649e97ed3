# SPDX-License-Identifier: Apache-2.0
"""Things that lie on tables and hang on walls: smooth meshes that stand on y = 0, or hang on z = 0 facing +z.

`paint` maps the names of materials to their numbers.
"""

import math

from shapes import Patch, box
from solids import arc, ball, curve, frame, hanging, picture, pipe, surface, turned


def cup(scene, paint, name, glaze, drink=None):
    """A mug with a handle; `drink` names what fills it."""
    outside = [(0.0, 0.0), (0.028, 0.0), (0.030, 0.004), *curve([(0.036, 0.012), (0.041, 0.045), (0.041, 0.088)], 4)]
    inside = curve([(0.0375, 0.088), (0.037, 0.045), (0.032, 0.014)], 3)
    body = turned([*outside, (0.0405, 0.091), (0.038, 0.091), *inside, (0.0, 0.010)], 16, (2.0, 1.0), 50)
    ear = [(0.0385 + x, 0.048 + y, 0.0) for x, y in
           [(0.0, 0.028), *arc(0.026, 75, -75, 7, (0.006, 0.0)), (0.0, -0.028)]]
    handle = pipe(ear, lambda t: 0.0055 + 0.002 * abs(2 * t - 1), 8, caps=False)
    parts = [(paint[glaze], Patch().add(body, handle))]
    if drink:
        parts.append((paint[drink], turned([(0.0372, 0.075), (0.0, 0.075)], 16)))
    return scene.mesh(name, parts)


def vase(scene, paint, name, glaze, profile, sides=28, rows=14, wall=0.004):
    """`profile` lists (radius, height) of the outside from its foot to its lip; hollow, closed below."""
    outside = curve(profile, rows)
    inside = [(max(r - wall, 0.001), y) for r, y in outside[::-1] if y > profile[0][1] + 2 * wall]
    lip = (outside[-1][0] - wall / 2, outside[-1][1] + wall / 2)
    floor = [(0.0, inside[-1][1])]
    body = turned([(0.0, 0.0), (profile[0][0], 0.0), *outside[1:], lip, *inside, *floor], sides, (3.0, 1.0), 50)
    return scene.mesh(name, [(paint[glaze], body)])


def bowl(scene, paint, name, glaze, radius=0.15):
    outside = [(radius * x, radius * y) for x, y in curve([(0.35, 0.0), (0.55, 0.04), (0.86, 0.25), (1.0, 0.52)], 6)]
    inside = [(radius * x, radius * y) for x, y in curve([(0.97, 0.52), (0.83, 0.28), (0.52, 0.075), (0.2, 0.05)], 5)]
    body = turned([(0.0, 0.0), *outside, (0.985 * radius, 0.53 * radius), *inside, (0.0, 0.048 * radius)], 24,
                  (3.0, 1.0), 50)
    return scene.mesh(name, [(paint[glaze], body)])


def apple(scene, paint, name, skin, stalk):
    """Rests on y = 0."""
    def profile_at(t):
        angle = math.pi * (t - 0.5)
        dimple = 0.35 * math.exp(-((math.cos(angle)) / 0.35) ** 2)
        radius = 0.037 * math.cos(angle) * (1 + 0.08 * math.sin(angle))
        return max(radius, 0.0), 0.034 + 0.036 * math.sin(angle) * (1 - dimple)

    profile = [profile_at(i / 8) for i in range(9)]
    profile[0], profile[-1] = (0.0, profile[0][1]), (0.0, profile[-1][1])
    body = turned(profile, 14, (2.0, 1.0), 70)
    stem = pipe([(0, 0.055, 0), (0.002, 0.066, 0), (0.006, 0.078, 0)], 0.0015, 5)
    lowest = min(p[1] for p in body.positions)
    return scene.mesh(name, [(paint[skin], body.moved(0, -lowest, 0)), (paint[stalk], stem.moved(0, -lowest, 0))])


def book(scene, paint, name, cloth, paper, size):
    """Stands on y = 0 with its spine to +z: thickness x, height y, depth z of `size`."""
    thick, tall, deep = size
    board = 0.003
    case = Patch().add(
        box((-thick / 2, 0, -deep / 2), (-thick / 2 + board, tall, deep / 2 - 0.004), grain=tall),
        box((thick / 2 - board, 0, -deep / 2), (thick / 2, tall, deep / 2 - 0.004), grain=tall))

    def spine_at(u, v):
        x, z = math.cos(math.pi * u), math.sin(math.pi * u)
        return (-thick / 2 * x, tall * v, deep / 2 - 0.004 + 0.006 * z)

    case.add(surface(6, 1, spine_at, (1.0, 1.0)))
    pages = box((-thick / 2 + board, 0.004, -deep / 2 + 0.005), (thick / 2 - board, tall - 0.004, deep / 2 - 0.004),
                skip=("-x", "+x"), grain=0.1)
    return scene.mesh(name, [(paint[cloth], case), (paint[paper], pages)])


def wall_clock(scene, paint, name, rim, dial, hand, radius=0.16):
    """Its back lies on the wall z = 0."""
    case = turned([(0.0, 0.0), (0.98 * radius, 0.0), *arc(0.02, -45, 135, 4, (radius, 0.024)),
                   (0.955 * radius, 0.026)], 32, (4.0, 1.0), 50)
    face = Patch()
    ring = [(0.96 * radius * math.cos(math.tau * k / 32), 0.96 * radius * math.sin(math.tau * k / 32), 0.026)
            for k in range(32)]
    face.polygon(ring, [(0.5 + 0.5 * x / radius, 0.5 - 0.5 * y / radius) for x, y, _ in ring])
    hands = Patch()
    for length, wide, z, angle in ((0.55, 0.010, 0.031, -56), (0.82, 0.007, 0.035, -312), (0.86, 0.003, 0.039, -150)):
        pointer = box((-wide / 2, -0.12 * radius, z - 0.001), (wide / 2, length * radius, z + 0.001), grain=0.1)
        hands.add(pointer.turned("z", angle))
    hands.add(turned([(0.0, 0.0), (0.009, 0.0), (0.009, 0.016), (0.0, 0.018)], 12).turned("x", 90).moved(0, 0, 0.026))
    return scene.mesh(name, [(paint[rim], case.turned("x", 90)), (paint[dial], face), (paint[hand], hands)])


MOULDING = [(0.040, 0.0), (0.040, 0.012), (0.034, 0.022), (0.022, 0.024), (0.010, 0.020), (0.0, 0.012), (0.0, 0.004)]


def framed(scene, paint, name, wood, content, width, height, border=1.0):
    """A picture or mirror of width x height behind a moulding `border` times 40 mm wide, on the wall z = 0."""
    moulding = frame(width, height, [(border * o, z) for o, z in MOULDING])
    back = box((-width / 2 - 0.02, -height / 2 - 0.02, 0), (width / 2 + 0.02, height / 2 + 0.02, 0.004), grain=0.5)
    plate = picture(width + 0.004, height + 0.004, 0.006)
    return scene.mesh(name, [(paint[wood], Patch().add(moulding, back)), (paint[content], plate)])


def potted_plant(scene, paint, name, clay, soil, leaf, draw, leaves=12, tall=0.75):
    pot = turned([(0.0, 0.0), (0.11, 0.0), (0.12, 0.006), (0.155, 0.26), (0.168, 0.262), (0.172, 0.30), (0.155, 0.303),
                  (0.145, 0.26), (0.14, 0.24)], 22, (4.0, 1.0))
    earth = turned([(0.1435, 0.255), (0.08, 0.262), (0.0, 0.266)], 22, (1.0, 1.0), 60)
    blades, stems = Patch(), Patch()
    for k in range(leaves):
        reach, lift = 0.22 + 0.26 * draw(), tall * (0.55 + 0.5 * draw())
        wide, turn = 0.05 + 0.025 * draw(), 360 * (k + 0.7 * draw()) / leaves
        path = curve([(0.02, 0.25, 0), (0.06, 0.25 + 0.5 * lift, 0), (0.35 * reach, 0.25 + 0.8 * lift, 0)], 4)
        stems.add(pipe(path, lambda t: 0.006 - 0.003 * t, 4, caps=False).turned("y", turn))
        x0, y0, _ = path[-1]

        def blade_at(u, v, x0=x0, y0=y0, reach=reach, wide=wide):
            t = v
            breadth = wide * math.sin(math.pi * (0.04 + 0.96 * t) ** 0.8) + 0.002
            across = 2 * u - 1
            fold = 0.25 * breadth * across * across
            return (x0 + reach * t, y0 + 0.20 * t - 0.42 * t * t + fold, -breadth * across)

        blades.add(surface(2, 6, blade_at, (1.0, 1.0), crease=80).turned("y", turn))
    return scene.mesh(name, [(paint[clay], pot), (paint[soil], earth), (paint[leaf], Patch().add(blades, stems))])


def cable(scene, paint, name, rubber, points, radius=0.004):
    """A cable through `points`, as smooth as a spline; it does not go below y = 0."""
    path = [(x, max(y, radius), z) for x, y, z in curve(points, 4 * (len(points) - 1))]
    return scene.mesh(name, [(paint[rubber], pipe(path, radius, 6))])


def garland(scene, paint, name, wire, bulb, start, end, sag, count):
    """A hanging cable with `count` small balls below it."""
    path = hanging(start, end, sag, 3 * (count + 1))
    balls = Patch()
    for k in range(count):
        x, y, z = path[3 * (k + 1)]
        balls.add(ball(0.022, 10, 6).moved(x, y - 0.024, z))
    return scene.mesh(name, [(paint[wire], pipe(path, 0.003, 6)), (paint[bulb], balls)])
