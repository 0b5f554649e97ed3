# SPDX-License-Identifier: Apache-2.0
"""Rounded and turned solids as a modeller makes them: texture coordinates everywhere, normals by crease angle."""

import math

from shapes import Patch, cross, minus, path_frames, quad, spline, unit

CREASE = 35.0           # degrees: edges that bend less are smooth
WELD_DIGITS = 6         # decimals of a metre: vertices that agree so far are one


def smoothed(patch, crease=CREASE):
    """The patch with a normal for each corner: the mean of those faces around it that bend less than `crease`.

    Faces weigh by their angle at the corner. Triangles without area are left out.
    """
    faces, around = [], {}
    keys = [tuple(round(c, WELD_DIGITS) + 0.0 for c in p) for p in patch.positions]
    for triangle in patch.triangles:
        if len({keys[i] for i in triangle}) < 3:
            continue
        a, b, c = (patch.positions[i] for i in triangle)
        normal = unit(cross(minus(b, a), minus(c, a)))
        faces.append((triangle, normal))
        for corner in range(3):
            here, left, right = (patch.positions[triangle[(corner + k) % 3]] for k in range(3))
            cosine = _dot(unit(minus(left, here)), unit(minus(right, here)))
            weight = math.acos(max(-1.0, min(1.0, cosine)))
            around.setdefault(keys[triangle[corner]], []).append((normal, weight))
    least = math.cos(math.radians(crease))
    out, made = Patch(), {}
    for triangle, face_normal in faces:
        corners = []
        for i in triangle:
            normal = unit([sum(w * n[k] for n, w in around[keys[i]] if _dot(n, face_normal) > least)
                           for k in range(3)])
            key = (keys[i], tuple(round(c, 4) for c in normal), patch.texcoords[i])
            if key not in made:
                made[key] = out.vertex(patch.positions[i], normal, patch.texcoords[i])
            corners.append(made[key])
        out.triangles.append(tuple(corners))
    return out


def warped(patch, place, crease=CREASE):
    """Moves every vertex to place(x, y, z) and smooths anew."""
    out = Patch().add(patch)
    out.positions = [tuple(place(*p)) for p in patch.positions]
    return smoothed(out, crease)


def surface(columns, rows, position_at, repeat=(1.0, 1.0), around=(False, False), crease=CREASE):
    """A surface through position_at(u, v), u and v in [0, 1]; its front is where u x v points.

    `around` tells for u and v whether 0 and 1 are the same line. The texture repeats `repeat` times.
    """
    patch = Patch()
    for j in range(rows + 1):
        v = (j % rows if around[1] else j) / rows
        for i in range(columns + 1):
            u = (i % columns if around[0] else i) / columns
            patch.vertex(position_at(u, v), (), (repeat[0] * i / columns, repeat[1] * (1 - j / rows)))
    for j in range(rows):
        for i in range(columns):
            a = j * (columns + 1) + i
            c = a + columns + 2
            patch.triangles += [(a, a + 1, c), (a, c, c - 1)]
    return smoothed(patch, crease)


def turned(profile, sides, repeat=(1.0, 1.0), crease=CREASE):
    """Turns `profile`, a list of (radius, y), about the y axis.

    The outside is on the right of the profile's direction of travel: bottom to top for the outside of a jar.
    """
    def position(u, v):
        radius, y = profile[round(v * (len(profile) - 1))]
        return (radius * math.cos(math.tau * u), y, -radius * math.sin(math.tau * u))

    return surface(sides, len(profile) - 1, position, repeat, (True, False), crease)


def curve(points, count):
    """`count` + 1 points of the smooth curve through `points`, of two or three coordinates."""
    return [spline(points, i / count) for i in range(count + 1)]


def arc(radius, start, end, steps, centre=(0.0, 0.0)):
    """Points (x, y) of a circular arc, degrees from +x to +y."""
    angles = [math.radians(start + (end - start) * i / steps) for i in range(steps + 1)]
    return [(centre[0] + radius * math.cos(a), centre[1] + radius * math.sin(a)) for a in angles]


def ball(radius, columns=28, rows=14):
    """A sphere around the origin in columns and rows, as modellers make them."""
    profile = arc(radius, -90, 90, rows)
    return turned([(0.0, -radius), *profile[1:-1], (0.0, radius)], columns, (2.0, 1.0), crease=60)


def torus(radius, thickness, columns=32, rows=12):
    """A ring around +Y whose middle line has `radius`; `thickness` is that of the bar, a radius."""
    def position(u, v):
        wide = radius + thickness * math.cos(math.tau * v)
        return (wide * math.cos(math.tau * u), thickness * math.sin(math.tau * v), -wide * math.sin(math.tau * u))

    return surface(columns, rows, position, (8.0, 1.0), (True, True), crease=80)


def bent(corners, radius, steps=3):
    """A path through `corners` with arcs of `radius` in place of the inner ones."""
    path = [tuple(corners[0])]
    for before, here, after in zip(corners, corners[1:], corners[2:]):
        a, b = unit(minus(before, here)), unit(minus(after, here))
        half = math.acos(max(-1.0, min(1.0, _dot(a, b)))) / 2
        middle = unit(tuple(p + q for p, q in zip(a, b)))
        centre = tuple(h + m * radius / math.sin(half) for h, m in zip(here, middle))
        start = minus(tuple(h + c * radius / math.tan(half) for h, c in zip(here, a)), centre)
        end = minus(tuple(h + c * radius / math.tan(half) for h, c in zip(here, b)), centre)
        turn = math.pi - 2 * half
        for step in range(steps + 1):
            t = step / steps
            s, e = math.sin((1 - t) * turn) / math.sin(turn), math.sin(t * turn) / math.sin(turn)
            path.append(tuple(c + s * p + e * q for c, p, q in zip(centre, start, end)))
    return [*path, tuple(corners[-1])]


def hanging(start, end, sag, count=12):
    """The path of a cable from `start` to `end` that hangs `sag` below the middle of the straight line."""
    ts = [i / count for i in range(count + 1)]
    return [tuple(a + (b - a) * t - (4 * sag * t * (1 - t) if k == 1 else 0.0)
                  for k, (a, b) in enumerate(zip(start, end))) for t in ts]


def bar(start, end, radius, sides=8):
    """A straight round bar with flat ends."""
    return pipe([start, end], radius, sides)


def pipe(path, radius, sides=10, caps=True):
    """A round bar along a path; `radius` is a number, or a function of the place along it in [0, 1]."""
    frames = path_frames(path)
    radius_at = radius if callable(radius) else lambda t: radius
    last = len(path) - 1

    def position(u, v):
        i = round(v * last)
        # Exact quarter turns: what a bar lies on, it touches.
        c, s = (round(f(math.tau * u), 12) for f in (math.cos, math.sin))
        return tuple(p + radius_at(v) * (c * f + s * g) for p, f, g in zip(path[i], *frames[i]))

    out = surface(sides, last, position, (1.0, 4.0), (True, False), crease=50)
    for i, outward in ((0, -1), (last, 1)) if caps else ():
        ring = [position(step / sides, i / last) for step in range(sides)][::outward]
        out.polygon(ring, [(0.5 + 0.5 * math.cos(math.tau * k / sides),
                            0.5 + 0.5 * math.sin(math.tau * k / sides)) for k in range(sides)])
    return out


def rounded_box(width, height, depth, radius, steps=1, cuts=(0, 0, 0), grain=1.0):
    """Stands on y = 0 around the y axis, its edges rounded by `radius` in 2 * `steps` chords.

    `cuts` split the flat parts along x, y, z, for warping. `grain` is metres per repeat of the texture, which
    runs along the longer side of each face.
    """
    half = (width / 2, height / 2, depth / 2)
    inner = [h - radius for h in half]
    rounding = [radius * math.tan(math.pi / 4 * k / steps) for k in range(1, steps + 1)]
    lines = []
    for axis in range(3):
        flat = [inner[axis] * (2 * k / (cuts[axis] + 1) - 1) for k in range(cuts[axis] + 2)]
        lines.append([-inner[axis] - r for r in rounding[::-1]] + flat + [inner[axis] + r for r in rounding])
    patch = Patch()
    for axis in range(3):
        b, c = (axis + 1) % 3, (axis + 2) % 3
        for sign in (-1, 1):
            across, up = lines[b], lines[c][::sign]
            first = len(patch.positions)
            for q in up:
                for p in across:
                    point = [0.0, 0.0, 0.0]
                    point[axis], point[b], point[c] = sign * half[axis], p, q
                    patch.vertex(*_rounded(point, inner, radius, half[1]),
                                 (p / grain, -q / grain) if half[b] >= half[c] else (q / grain, p / grain))
            width_of = len(across)
            for j in range(len(up) - 1):
                for i in range(width_of - 1):
                    a = first + j * width_of + i
                    patch.triangles += [(a, a + 1, a + width_of + 1), (a, a + width_of + 1, a + width_of)]
    return patch


def _rounded(point, inner, radius, lift):
    """The point of a rounded box, lifted onto y = 0, nearest to one of its sharp box, and the normal there."""
    core = [max(-h, min(h, p)) for p, h in zip(point, inner)]
    normal = unit(minus(point, core))
    place = [c + radius * n for c, n in zip(core, normal)]
    return (place[0], place[1] + lift, place[2]), normal


def pillow(width, height, depth, radius, bulge, steps=1, cuts=4, grain=0.3):
    """A cushion on y = 0: a rounded box whose top rises by `bulge` in the middle."""
    box = rounded_box(width, height, depth, radius, steps, (cuts, 0, cuts), grain)

    def place(x, y, z):
        swell = (1 - (2 * x / width) ** 2) * (1 - (2 * z / depth) ** 2)
        return (x, y + bulge * swell * max(0.0, 2 * y / height - 1), z)

    return warped(box, place, 50)


def frame(width, height, profile, grain=0.5):
    """A mitred frame around an opening in the plane z = 0, front at +z.

    `profile` lists (outwards from the opening, z), from the outer edge to the inner.
    """
    patch = Patch()
    for side in range(4):
        horizontal = side % 2 == 0
        along, away = (width / 2, height / 2) if horizontal else (height / 2, width / 2)
        angle = side * 90
        bar = Patch()
        place = 0.0
        for (o0, z0), (o1, z1) in zip(profile, profile[1:]):
            corners = [(along + o0, -away - o0, z0), (along + o1, -away - o1, z1),
                       (-along - o1, -away - o1, z1), (-along - o0, -away - o0, z0)]
            next_place = place + math.hypot(o1 - o0, z1 - z0)
            bar.polygon(corners, [(x / grain, v / grain) for (x, _, _), v in
                                  zip(corners, (place, next_place, next_place, place))])
            place = next_place
        patch.add(bar.turned("z", angle))
    return smoothed(patch)


def picture(width, height, z=0.0):
    """An upright rectangle that faces +z and shows a texture once."""
    w, h = width / 2, height / 2
    return quad((-w, -h, z), (w, -h, z), (w, h, z), (-w, h, z))


def _dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
