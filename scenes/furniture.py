# SPDX-License-Identifier: Apache-2.0
"""Furniture as meshes in their own frames: on the floor at the origin, the user at +z.

`paint` maps the names of colours to materials.
"""

import shapes
from shapes import Patch, box, cylinder, lathe, prism, rounded_rectangle

GAP = 0.001         # between objects that rest on each other, metres: no surfaces coincide
DESK_WIDTH, DESK_DEPTH, DESK_HEIGHT = 1.30, 0.72, 0.74
WOOD_GRAIN = 0.6    # metres per repeat of the wood texture


def desk(scene, paint):
    w, d, top = DESK_WIDTH / 2, DESK_DEPTH / 2, DESK_HEIGHT
    legs = Patch()
    for x in (-w + 0.05, w - 0.10):
        for z in (-d + 0.05, d - 0.10):
            legs.add(box((x, GAP, z), (x + 0.05, top - 0.03 - GAP, z + 0.05), skip=("-y", "+y")))
    apron = box((-w + 0.11, 0.36, -d + 0.06), (w - 0.11, top - 0.03 - GAP, -d + 0.08), skip=("+y",))
    board = box((-w, top - 0.03, -d), (w, top, d), grain=WOOD_GRAIN)
    return scene.mesh("desk", [(paint["wood"], board), (paint["steel"], legs), (paint["steel"], apron)])


def monitor(scene, paint):
    """Stands on y = 0; the screen faces +z."""
    shell = box((-0.28, 0.14, -0.02), (0.28, 0.48, 0.02))
    neck = box((-0.03, 0.012 + GAP, -0.055), (0.03, 0.36, -0.02 - GAP), skip=("-y",))
    foot = box((-0.12, GAP, -0.12), (0.12, 0.012, 0.06), skip=("-y",))
    front = 0.02 + GAP
    screen = shapes.quad((-0.265, 0.16, front), (0.265, 0.16, front),
                         (0.265, 0.465, front), (-0.265, 0.465, front))
    return scene.mesh("monitor", [(paint["graphite"], Patch().add(shell, neck, foot)),
                                  (paint["screen"], screen)])


def keyboard(scene, paint):
    body = box((-0.21, GAP, -0.065), (0.21, 0.014, 0.065), skip=("-y",))
    rows = box((-0.20, 0.014 + GAP, -0.055), (0.20, 0.022, 0.055), skip=("-y",))
    return scene.mesh("keyboard", [(paint["graphite"], body), (paint["keys"], rows)])


def mouse(scene, paint):
    body = prism(shapes.regular_polygon(6, 0.032, 0.055), GAP, 0.03, skip=("-y",))
    return scene.mesh("mouse", [(paint["graphite"], body)])


def chair(scene, paint, fabric):
    """The sitter looks to -z. A lever under the seat on +x tells a mirrored instance from a plain one."""
    seat = prism(rounded_rectangle(0.48, 0.46, 0.09, 1), 0.43, 0.49)
    back = prism(rounded_rectangle(0.44, 0.50, 0.10, 1), -0.025, 0.025)
    back = back.turned("x", 90).turned("x", 10).moved(0, 0.86, 0.29)
    frame = Patch().add(
        box((-0.03, 0.40, 0.05), (0.03, 0.425, 0.25), skip=("+y",)),
        box((-0.03, 0.40, 0.25 + GAP), (0.03, 0.80, 0.265), skip=("-y", "+y")),
        box((0.10, 0.412, -0.01), (0.30, 0.424, 0.02), skip=("-x", "-y")),
        cylinder(0.025, 0.25, 0.43 - GAP, 6, caps=False),
        lathe([(0.055, 0.06), (0.034, 0.26)], 6))
    castors = Patch()
    for arm in range(5):
        spoke = Patch()
        spoke.polygon([(0.045, 0.115, 0.026), (0.31, 0.085, 0.018),
                       (0.31, 0.085, -0.018), (0.045, 0.115, -0.026)])
        for side in (1, -1):
            face = [(0.045, 0.075, 0.026 * side), (0.31, 0.065, 0.018 * side),
                    (0.31, 0.085, 0.018 * side), (0.045, 0.115, 0.026 * side)]
            spoke.polygon(face if side > 0 else face[::-1])
        frame.add(spoke.turned("y", 72 * arm + 90))
        wheel = prism(shapes.regular_polygon(5, 0.03, 0.03), -0.022, 0.022, skip=("-y",))
        castors.add(wheel.turned("x", 90).moved(0.285, 0.03 + GAP, 0).turned("y", 72 * arm + 90))
    return scene.mesh(f"chair {fabric}", [(paint[fabric], Patch().add(seat, back)), (paint["steel"], frame),
                                          (paint["graphite"], castors)])


def bookshelf(scene, paint, draw):
    """Back at z = 0, opens to +z; 1.4 m wide, 2.0 m high."""
    width, height, depth, board = 1.4, 2.0, 0.30, 0.025
    half = width / 2
    case = Patch().add(
        box((-half, GAP, 0), (-half + board, height, depth), grain=WOOD_GRAIN),
        box((half - board, GAP, 0), (half, height, depth), grain=WOOD_GRAIN),
        box((-half + board + GAP, 0.05, GAP), (half - board - GAP, height - GAP, 0.01),
            skip=("-z", "-y", "+y", "-x", "+x"), grain=WOOD_GRAIN))
    books = {colour: Patch() for colour in ("rust", "teal", "mustard", "cream", "plum")}
    colours = list(books)
    shelves = 5
    for level in range(shelves):
        y = 0.06 + level * (height - 0.06 - board) / (shelves - 1)
        case.add(box((-half + board + GAP, y, 0.01 + GAP), (half - board - GAP, y + board, depth - 0.01),
                     skip=("-x", "+x", "-z"), grain=WOOD_GRAIN))
        if level == shelves - 1:
            break
        x = -half + board + 0.02 + 0.25 * draw() * (level % 2)
        end = half - board - 0.08 - 0.35 * draw()
        while x < end:
            thickness, tall, deep = 0.09 + 0.14 * draw(), 0.27 + 0.12 * draw(), 0.17 + 0.07 * draw()
            book = box((x, y + board + GAP, 0.02), (x + thickness, y + board + tall, 0.02 + deep),
                       skip=("-y", "-z"))
            books[colours[int(draw() * len(colours))]].add(book)
            x += thickness + 0.004
    rows = [(paint[colour], patch) for colour, patch in books.items() if patch.triangles]
    return scene.mesh("bookshelf", [(paint["wood"], case), *rows])


def sideboard(scene, paint):
    """Back at z = 0; 1.5 m wide, 0.6 m high."""
    body = box((-0.75, 0.06, 0), (0.75, 0.58, 0.38), skip=("-z", "+y"), grain=WOOD_GRAIN)
    top = box((-0.77, 0.58, 0), (0.77, 0.60, 0.40), skip=("-z",), grain=WOOD_GRAIN)
    doors = Patch()
    for i in range(3):
        x = -0.735 + 0.49 * i
        doors.add(box((x + 0.005, 0.08, 0.38 + GAP), (x + 0.485, 0.56, 0.395), skip=("-z",)))
    plinth = box((-0.70, GAP, 0.03), (0.70, 0.06 - GAP, 0.34), skip=("+y", "-y", "-z"))
    return scene.mesh("sideboard", [(paint["wood"], Patch().add(body, top)), (paint["cream"], doors),
                                    (paint["graphite"], plinth)])


def door(scene, paint):
    """In a wall at z = 0, opens to +z."""
    frame = Patch().add(box((-0.50, GAP, GAP), (-0.45, 2.10, 0.05), skip=("-z", "-y")),
                        box((0.45, GAP, GAP), (0.50, 2.10, 0.05), skip=("-z", "-y")),
                        box((-0.45 + GAP, 2.05, GAP), (0.45 - GAP, 2.10, 0.05), skip=("-z", "-x", "+x")))
    leaf = box((-0.45 + GAP, 0.01, GAP), (0.45 - GAP, 2.05 - GAP, 0.03), skip=("-z",), grain=WOOD_GRAIN)
    handle = Patch().add(box((0.36, 1.00, 0.03 + GAP), (0.38, 1.04, 0.07), skip=("-z",)),
                         box((0.26, 1.012, 0.07 + GAP), (0.385, 1.030, 0.085)))
    return scene.mesh("door", [(paint["cream"], frame), (paint["wood"], leaf), (paint["steel"], handle)])


def frame(width, height, border, depth, overlap):
    """Four bars around an opening `overlap` smaller than width x height on each side; front at z = depth."""
    x, y = width / 2 - overlap, height / 2 - overlap
    return Patch().add(
        box((-x - border, -y - border, 0), (-x, y + border, depth), skip=("-z",)),
        box((x, -y - border, 0), (x + border, y + border, depth), skip=("-z",)),
        box((-x + GAP, -y - border, 0), (x - GAP, -y, depth), skip=("-z", "-x", "+x")),
        box((-x + GAP, y, 0), (x - GAP, y + border, depth), skip=("-z", "-x", "+x")))


def plant(scene, paint, draw):
    pot = lathe([(0.13, GAP), (0.18, 0.34), (0.16, 0.34), (0.155, 0.29)], 12)
    soil = lathe([(0.157, 0.30), (0.0, 0.31)], 12)
    leaves = Patch()
    count = 11
    for i in range(count):
        reach, lift, width = 0.30 + 0.22 * draw(), 0.55 + 0.55 * draw(), 0.07 + 0.03 * draw()
        leaf = shapes.grid(1, 4, lambda u, v, r=reach, h=lift, w=width: (
            w * (2 * u - 1) * (0.15 + 1.7 * v * (1.05 - v)),
            0.30 + h * (1.5 * v - 0.62 * v * v),
            -r * v * v - 0.03))
        leaves.add(leaf.turned("y", 360 * (i + 0.6 * draw()) / count))
    return scene.mesh("plant", [(paint["terracotta"], pot), (paint["soil"], soil), (paint["leaf"], leaves)])


def waste_bin(scene, paint):
    wall = lathe([(0.12, GAP), (0.15, 0.36), (0.143, 0.36), (0.114, 0.012), (0.0, 0.012)], 14)
    return scene.mesh("waste bin", [(paint["rough metal"], wall)])


def book_stack(scene, paint):
    """Three books lying on y = 0."""
    parts, bottom = [], GAP
    for colour, width, depth, thickness, turn in (("rust", 0.30, 0.22, 0.040, 8),
                                                  ("cream", 0.26, 0.20, 0.030, -14),
                                                  ("teal", 0.22, 0.16, 0.045, 20)):
        book = box((-width / 2, bottom, -depth / 2), (width / 2, bottom + thickness, depth / 2), skip=("-y",))
        parts.append((paint[colour], book.turned("y", turn)))
        bottom += thickness + GAP
    return scene.mesh("book stack", parts)


def lamp(scene, paint):
    """Stands on y = 0."""
    stem = Patch().add(lathe([(0.09, GAP), (0.09, 0.012), (0.0, 0.016)], 12),
                       cylinder(0.009, 0.015, 0.44, 6, caps=False))
    shade = lathe([(0.17, 0.27), (0.10, 0.47), (0.0, 0.48)], 20)
    return scene.mesh("lamp", [(paint["steel"], stem), (paint["rough metal"], shade)])


def ball_stand(scene, paint):
    """A cabinet with a ring on top that holds a ball. Returns the mesh and the height of the ring's rim."""
    top = 0.60
    ring_radius, rim = 0.115, top + 0.03
    cabinet = box((-0.23, 0.03, -0.23), (0.23, top, 0.23), grain=WOOD_GRAIN)
    drawers = Patch()
    for i in range(3):
        y = 0.05 + 0.18 * i
        drawers.add(box((-0.215, y, 0.23 + GAP), (0.215, y + 0.17, 0.243), skip=("-z",)))
    foot = box((-0.21, GAP, -0.21), (0.21, 0.03 - GAP, 0.21), skip=("-y", "+y"))
    ring = lathe([(0.135, top + GAP), (ring_radius, rim), (ring_radius - 0.01, top + GAP)], 14)
    mesh = scene.mesh("ball stand", [(paint["wood"], cabinet), (paint["cream"], drawers),
                                     (paint["graphite"], Patch().add(foot, ring))])
    return mesh, ring_radius, rim


def ceiling_panel(scene, paint):
    """Hangs below y = 0; lit from its underside, 1.2 m by 0.3 m."""
    case = box((-0.62, -0.045, -0.17), (0.62, -GAP, 0.17), skip=("+y",))
    y = -0.045 - GAP
    light = shapes.quad((-0.60, y, -0.15), (0.60, y, -0.15), (0.60, y, 0.15), (-0.60, y, 0.15))
    return scene.mesh("ceiling panel", [(paint["cream"], case), (paint["panel"], light)])


def pendant(scene, paint, length, width, drop):
    """Hangs on two wires `drop` below y = 0, along x; lit from above and from below."""
    x, z, top, bottom = length / 2, width / 2, -drop, -drop - 0.03
    rim = box((-x - 0.01, bottom, -z - 0.01), (x + 0.01, top, z + 0.01), skip=("-y", "+y"))
    for side in (-1, 1):
        rim.add(box((0.7 * side * x - 0.003, top - 0.01, -0.003), (0.7 * side * x + 0.003, -GAP, 0.003),
                    skip=("-y", "+y")))
    panels = Patch().add(
        shapes.quad((-x, top - 0.005, z), (x, top - 0.005, z), (x, top - 0.005, -z), (-x, top - 0.005, -z)),
        shapes.quad((-x, bottom + 0.005, -z), (x, bottom + 0.005, -z), (x, bottom + 0.005, z),
                    (-x, bottom + 0.005, z)))
    return scene.mesh("pendant", [(paint["graphite"], rim), (paint["lamp"], panels)])
