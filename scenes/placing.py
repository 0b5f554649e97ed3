# SPDX-License-Identifier: Apache-2.0
"""Where things come to stand: on floors, against walls, in a room."""

import math
import random

import glb
import shapes
from paints import Paints


class Stage:
    """A scene as an exporter writes it, its materials, and how things come to stand in it."""

    def __init__(self, name, seed=1):
        self.scene = glb.Glb(name, "Written for Utsuri")
        self.paint = Paints(self.scene)
        self.draw = random.Random(seed).random
        self.root = None        # the node below which everything stands, if any

    def put(self, name, mesh, x, y, z, yaw=0.0, tilt=None, parent=None, scale=None):
        """A node with `mesh`, turned by `yaw` degrees; `tilt` is (axis, degrees) before that turn."""
        rotation = glb.turn_y(yaw)
        if tilt:
            rotation = glb.after(rotation, glb.turn(*tilt))
        return self.scene.node(name, parent=self.root if parent is None else parent, mesh=mesh, at=(x, y, z),
                               rotation=rotation, scale=scale)

    def look(self, eye, target, vertical_fov):
        """Adds the camera."""
        self.scene.node("camera", parent=self.root, camera=self.scene.camera("camera", vertical_fov, 4 / 3), at=eye,
                        rotation=glb.look_rotation([t - c for t, c in zip(target, eye)]))


def lean(length, thickness, degrees, rounding=0.0):
    """Where the foot of a board stands that leans back against a wall, tilted `degrees` from upright.

    The board is `length` high, `thickness` deep, its edges rounded by `rounding`; it stands on y = 0 around the
    y axis and turns about x by -degrees. Returns (y, z): moved there, it touches the floor y = 0 and the wall z = 0.
    """
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    y, z = rounding, -thickness / 2 + rounding
    lowest = y * c + z * s - rounding
    rearmost = z * c - (length - rounding) * s - rounding
    return -lowest, -rearmost


def room(stage, half_x, height, half_z, looks, grain=1.0):
    """A room around the origin: walls with the texture once every `grain` metres.

    `looks` names the materials of floor, ceiling, back (-z), right, front, left, of those walls that there are.
    """
    x, y, z = half_x, height, half_z
    corners = {"floor": [(-x, 0, z), (x, 0, z), (x, 0, -z), (-x, 0, -z)],
               "ceiling": [(-x, y, -z), (x, y, -z), (x, y, z), (-x, y, z)],
               "back": [(-x, 0, -z), (x, 0, -z), (x, y, -z), (-x, y, -z)],
               "right": [(x, 0, -z), (x, 0, z), (x, y, z), (x, y, -z)],
               "front": [(x, 0, z), (-x, 0, z), (-x, y, z), (x, y, z)],
               "left": [(-x, 0, z), (-x, 0, -z), (-x, y, -z), (-x, y, z)]}
    node = stage.scene.node("room", parent=stage.root)
    for name, look in looks.items():
        a, b, c, d = corners[name]
        repeat = (math.dist(a, b) / grain, math.dist(b, c) / grain)
        mesh = stage.scene.mesh(name, [(stage.paint[look], shapes.quad(a, b, c, d, repeat))])
        stage.scene.node(name, parent=node, mesh=mesh)


def skirting(stage, look, half_x, half_z, walls=("back", "right", "front", "left")):
    """Boards along the walls of a room."""
    thick = 0.014
    boards = shapes.Patch()
    for wall, length, turn, away in (("back", 2 * half_x, 0, half_z), ("front", 2 * half_x, 180, half_z),
                                     ("right", 2 * (half_z - thick), -90, half_x),
                                     ("left", 2 * (half_z - thick), 90, half_x)):
        if wall in walls:
            board = shapes.box((-length / 2, 0.0, -away), (length / 2, 0.08, -away + thick), grain=0.5)
            boards.add(board.turned("y", turn))
    mesh = stage.scene.mesh("skirting", [(stage.paint[look], boards)])
    stage.scene.node("skirting", parent=stage.root, mesh=mesh)
