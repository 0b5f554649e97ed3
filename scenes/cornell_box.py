# SPDX-License-Identifier: Apache-2.0
"""The Cornell box, with the vertices that the Cornell University Program of Computer Graphics published.

Source: "Cornell Box Data", https://www.graphics.cornell.edu/online/box/data.html. Everything is in the data's
unit; METRES_PER_UNIT makes it metres.
"""

import math

import glb
import shapes

METRES_PER_UNIT = 0.001

FLOOR = [(552.8, 0.0, 0.0), (0.0, 0.0, 0.0), (0.0, 0.0, 559.2), (549.6, 0.0, 559.2)]
CEILING = [(556.0, 548.8, 0.0), (556.0, 548.8, 559.2), (0.0, 548.8, 559.2), (0.0, 548.8, 0.0)]
LIGHT = [(343.0, 548.8, 227.0), (343.0, 548.8, 332.0), (213.0, 548.8, 332.0), (213.0, 548.8, 227.0)]
BACK_WALL = [(549.6, 0.0, 559.2), (0.0, 0.0, 559.2), (0.0, 548.8, 559.2), (556.0, 548.8, 559.2)]
RIGHT_WALL = [(0.0, 0.0, 559.2), (0.0, 0.0, 0.0), (0.0, 548.8, 0.0), (0.0, 548.8, 559.2)]
LEFT_WALL = [(552.8, 0.0, 0.0), (549.6, 0.0, 559.2), (556.0, 548.8, 559.2), (556.0, 548.8, 0.0)]
SHORT_BLOCK_TOP = [(130.0, 165.0, 65.0), (82.0, 165.0, 225.0), (240.0, 165.0, 272.0), (290.0, 165.0, 114.0)]
TALL_BLOCK_TOP = [(423.0, 330.0, 247.0), (265.0, 330.0, 296.0), (314.0, 330.0, 456.0), (472.0, 330.0, 406.0)]

# The published reflectances and the light are spectra. These are linear RGB triples in wide use for them.
WHITE, RED, GREEN = (0.725, 0.71, 0.68), (0.63, 0.065, 0.05), (0.14, 0.45, 0.091)
LIGHT_LUMINANCE = (17.0, 12.0, 4.0)

CAMERA_POSITION, CAMERA_DIRECTION = (278.0, 273.0, -800.0), (0.0, 0.0, 1.0)
FOCAL_LENGTH, FILM_SIZE = 0.035, 0.025


def polygon(*faces):
    patch = shapes.Patch()
    for face in faces:
        patch.polygon(face)
    return patch


def ring(outer, hole):
    """The polygon `outer` without `hole`, whose corners correspond one to one."""
    sides = []
    for i in range(len(outer)):
        j = (i + 1) % len(outer)
        sides.append([outer[i], outer[j], hole[j], hole[i]])
    return polygon(*sides)


def block(top):
    """The top and the four sides down to the floor, facing outwards; the bottom is hidden."""
    faces = [top]
    for a, b in zip(top, top[1:] + top[:1]):
        faces.append([(a[0], 0.0, a[2]), (b[0], 0.0, b[2]), b, a])
    return polygon(*faces)


def add_camera(scene):
    """The published camera: it sees little more than the opening."""
    vertical_fov = 2 * math.degrees(math.atan(FILM_SIZE / 2 / FOCAL_LENGTH))
    scene.node("camera", camera=scene.camera("camera", vertical_fov, 1.0),
               at=[METRES_PER_UNIT * c for c in CAMERA_POSITION],
               rotation=glb.look_rotation(CAMERA_DIRECTION))
