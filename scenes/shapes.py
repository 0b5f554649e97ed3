# SPDX-License-Identifier: Apache-2.0
"""Triangle patches of the common shapes. Metres, +Y up, counter-clockwise seen from outside."""

import math


class Patch:
    """Vertices with unit normals and optional texture coordinates (v = 0 at the top), and their triangles."""

    def __init__(self):
        self.positions, self.normals, self.texcoords, self.triangles = [], [], [], []

    def vertex(self, position, normal, texcoord=None):
        self.positions.append(tuple(position))
        self.normals.append(tuple(normal))
        self.texcoords.append(texcoord)
        return len(self.positions) - 1

    def polygon(self, points, texcoords=None):
        """Adds a flat convex polygon as a fan."""
        normal = unit(cross(minus(points[1], points[0]), minus(points[2], points[0])))
        uvs = texcoords or [None] * len(points)
        corner = [self.vertex(p, normal, uv) for p, uv in zip(points, uvs)]
        self.triangles += [(corner[0], corner[i], corner[i + 1]) for i in range(1, len(corner) - 1)]

    def add(self, *others):
        """Appends patches; returns self."""
        for other in others:
            first = len(self.positions)
            self.positions += other.positions
            self.normals += other.normals
            self.texcoords += other.texcoords
            self.triangles += [tuple(first + i for i in triangle) for triangle in other.triangles]
        return self

    def moved(self, x, y, z):
        out = Patch().add(self)
        out.positions = [(p[0] + x, p[1] + y, p[2] + z) for p in self.positions]
        return out

    def turned(self, axis, degrees):
        """A turn about the x, y or z axis through the origin, right-handed."""
        a, b = {"x": (1, 2), "y": (2, 0), "z": (0, 1)}[axis]
        c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))

        def turn(v):
            w = list(v)
            w[a], w[b] = c * v[a] - s * v[b], s * v[a] + c * v[b]
            return tuple(w)

        out = Patch().add(self)
        out.positions = [turn(p) for p in self.positions]
        out.normals = [turn(n) for n in self.normals]
        return out


def minus(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    length = math.sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2])
    return (a[0] / length, a[1] / length, a[2] / length)


def quad(bottom_left, bottom_right, top_right, top_left, repeat=(1.0, 1.0)):
    """A parallelogram seen upright from its front; the texture repeats `repeat` times across and up."""
    patch = Patch()
    u, v = repeat
    patch.polygon([bottom_left, bottom_right, top_right, top_left], [(0.0, v), (u, v), (u, 0.0), (0.0, 0.0)])
    return patch


def box(low, high, skip=(), grain=None):
    """An axis-aligned box. `skip` names faces left out, for example ("-y",).

    `grain` gives texture coordinates: metres per repeat, u along the longer side of each face.
    """
    (x0, y0, z0), (x1, y1, z1) = low, high
    faces = {
        "-x": [(x0, y0, z0), (x0, y0, z1), (x0, y1, z1), (x0, y1, z0)],
        "+x": [(x1, y0, z1), (x1, y0, z0), (x1, y1, z0), (x1, y1, z1)],
        "-y": [(x0, y0, z0), (x1, y0, z0), (x1, y0, z1), (x0, y0, z1)],
        "+y": [(x0, y1, z1), (x1, y1, z1), (x1, y1, z0), (x0, y1, z0)],
        "-z": [(x1, y0, z0), (x0, y0, z0), (x0, y1, z0), (x1, y1, z0)],
        "+z": [(x0, y0, z1), (x1, y0, z1), (x1, y1, z1), (x0, y1, z1)],
    }
    patch = Patch()
    for name, corners in faces.items():
        if name not in skip:
            patch.polygon(corners, _grain_coordinates(corners, grain) if grain else None)
    return patch


def _grain_coordinates(corners, grain):
    width, height = math.dist(corners[0], corners[1]) / grain, math.dist(corners[1], corners[2]) / grain
    if width >= height:
        return [(0.0, height), (width, height), (width, 0.0), (0.0, 0.0)]
    return [(0.0, 0.0), (0.0, width), (height, width), (height, 0.0)]


def rounded_rectangle(width, depth, radius, steps=2):
    """Outline in (x, z) around the origin; `steps` chords a corner."""
    outline = []
    for quarter, (sx, sz) in enumerate(((1, 1), (-1, 1), (-1, -1), (1, -1))):
        for step in range(steps + 1):
            angle = math.pi / 2 * (quarter + step / steps)
            outline.append((sx * (width / 2 - radius) + radius * math.cos(angle),
                            sz * (depth / 2 - radius) + radius * math.sin(angle)))
    return outline


def regular_polygon(corners, half_width, half_depth):
    """Outline in (x, z) around the origin, stretched to an ellipse of these half axes."""
    angles = [math.tau * i / corners for i in range(corners)]
    return [(half_width * math.cos(a), half_depth * math.sin(a)) for a in angles]


def prism(outline, bottom, top, skip=()):
    """A convex outline in (x, z) drawn out from y = bottom to y = top; `skip` may name "-y" and "+y"."""
    area = sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(outline, outline[1:] + outline[:1]))
    # Positive in (x, z) is clockwise seen from above, because z points to the viewer.
    ring = outline[::-1] if area > 0 else outline
    patch = Patch()
    for (xa, za), (xb, zb) in zip(ring, ring[1:] + ring[:1]):
        patch.polygon([(xa, bottom, za), (xb, bottom, zb), (xb, top, zb), (xa, top, za)])
    if "+y" not in skip:
        patch.polygon([(x, top, z) for x, z in ring])
    if "-y" not in skip:
        patch.polygon([(x, bottom, z) for x, z in ring[::-1]])
    return patch


def lathe(profile, sides):
    """Turns `profile`, a list of (radius, y), about the y axis: smooth around, creased along the profile.

    The outside is on the right of the profile's direction of travel: bottom to top for the outside of a jar.
    """
    patch = Patch()
    for (r0, y0), (r1, y1) in zip(profile, profile[1:]):
        slope = math.hypot(r1 - r0, y1 - y0)
        outward, up = (y1 - y0) / slope, (r0 - r1) / slope
        for side in range(sides):
            a = [math.tau * (side + step) / sides for step in (0, 1)]
            corners = [(r0, y0, a[0]), (r1, y1, a[0]), (r1, y1, a[1]), (r0, y0, a[1])]
            kept = [c for i, c in enumerate(corners) if c[0] > 0.0 or i in (0, 1)]
            ring = [patch.vertex((r * math.cos(t), y, r * math.sin(t)),
                                 (outward * math.cos(t), up, outward * math.sin(t))) for r, y, t in kept]
            patch.triangles += [(ring[0], ring[i], ring[i + 1]) for i in range(1, len(ring) - 1)]
    return patch


def cylinder(radius, bottom, top, sides, caps=True):
    profile = [(radius, bottom), (radius, top)]
    return lathe([(0.0, bottom), *profile, (0.0, top)] if caps else profile, sides)


def icosphere(radius, level):
    """An icosahedron split `level` times, 20 * 4^level triangles, vertices on the sphere, smooth normals."""
    golden = (1 + math.sqrt(5)) / 2
    points = [unit(p) for p in (
        (-1, golden, 0), (1, golden, 0), (-1, -golden, 0), (1, -golden, 0),
        (0, -1, golden), (0, 1, golden), (0, -1, -golden), (0, 1, -golden),
        (golden, 0, -1), (golden, 0, 1), (-golden, 0, -1), (-golden, 0, 1))]
    triangles = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11),
                 (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6), (7, 1, 8),
                 (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9),
                 (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]
    for _ in range(level):
        middles, split = {}, []

        def middle(a, b):
            key = (min(a, b), max(a, b))
            if key not in middles:
                middles[key] = len(points)
                points.append(unit(tuple(p + q for p, q in zip(points[a], points[b]))))
            return middles[key]

        for a, b, c in triangles:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            split += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        triangles = split
    patch = Patch()
    for p in points:
        patch.vertex(tuple(radius * c for c in p), p)
    patch.triangles = triangles
    return patch


def grid(columns, rows, position_at, around=False):
    """A smooth surface through position_at(u, v), u and v in [0, 1]; its front is where u x v points.

    Normals are central differences of the grid. `around` says that u = 0 and u = 1 are the same line.
    """
    points = [[position_at(i / columns, j / rows) for i in range(columns + 1)] for j in range(rows + 1)]
    patch = Patch()
    for j in range(rows + 1):
        below, above = points[max(j - 1, 0)], points[min(j + 1, rows)]
        for i in range(columns + 1):
            left = points[j][i - 1 if i > 0 else (columns - 1 if around else 0)]
            right = points[j][i + 1 if i < columns else (1 if around else columns)]
            patch.vertex(points[j][i], unit(cross(minus(right, left), minus(above[i], below[i]))))
    for j in range(rows):
        for i in range(columns):
            a = j * (columns + 1) + i
            c = a + columns + 2
            patch.triangles += [(a, a + 1, c), (a, c, c - 1)]
    return patch


def path_frames(points):
    """A pair of unit vectors across a smooth path at each of its points, carried along without a twist.

    For a path in a plane of constant x the first is +X.
    """
    frames = []
    side = None
    for i in range(len(points)):
        tangent = unit(minus(points[min(i + 1, len(points) - 1)], points[max(i - 1, 0)]))
        # Carrying the side vector along keeps the rings from twisting.
        reference = side or ((1.0, 0.0, 0.0) if abs(tangent[0]) < 0.9 else (0.0, 1.0, 0.0))
        across = unit(cross(tangent, reference))
        side = cross(across, tangent)
        frames.append((side, across))
    return frames


def tube(points, radius_at, sides):
    """A tube along a smooth path of `points`; radius_at(t) in metres with t in [0, 1]. Open at both ends."""
    patch = Patch()
    for i, (point, (first, second)) in enumerate(zip(points, path_frames(points))):
        radius = radius_at(i / (len(points) - 1))
        for step in range(sides):
            angle = math.tau * step / sides
            c, s = math.cos(angle), math.sin(angle)
            normal = tuple(c * f + s * g for f, g in zip(first, second))
            patch.vertex(tuple(p + radius * n for p, n in zip(point, normal)), normal)
    for i in range(len(points) - 1):
        for step in range(sides):
            a, b = i * sides + step, i * sides + (step + 1) % sides
            patch.triangles += [(a, b, b + sides), (a, b + sides, a + sides)]
    return patch


def spline(points, t):
    """A Catmull-Rom spline through `points`, t in [0, 1]; its end pieces go on beyond."""
    place = t * (len(points) - 1)
    i = max(0, min(int(place), len(points) - 2))
    s = place - i
    near = [points[min(max(i + k, 0), len(points) - 1)] for k in (-1, 0, 1, 2)]
    return tuple(0.5 * (2 * b + (c - a) * s + (2 * a - 5 * b + 4 * c - d) * s ** 2
                        + (3 * (b - c) + d - a) * s ** 3) for a, b, c, d in zip(*near))
