# SPDX-License-Identifier: Apache-2.0
"""The Cornell box. The data's unit is kept in the meshes; the node above them scales it to metres."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import cornell_box as data  # noqa: E402
import glb  # noqa: E402
from cornell_box import block, polygon, ring  # noqa: E402


def build():
    scene = glb.Glb("Cornell box", "Geometry: Cornell Box Data, Program of Computer Graphics, Cornell")
    white, red, green = (scene.matte(*m) for m in (
        ("white", data.WHITE), ("red", data.RED), ("green", data.GREEN)))
    light = scene.emitter("light", data.LIGHT_LUMINANCE)
    box = scene.node("cornell box", scale=[data.METRES_PER_UNIT] * 3)
    for name, material, patch in (
            ("floor", white, polygon(data.FLOOR)),
            ("ceiling", white, ring(data.CEILING, data.LIGHT)),
            ("back wall", white, polygon(data.BACK_WALL)),
            ("right wall", green, polygon(data.RIGHT_WALL)),
            ("left wall", red, polygon(data.LEFT_WALL)),
            ("light", light, polygon(data.LIGHT)),
            ("short block", white, block(data.SHORT_BLOCK_TOP)),
            ("tall block", white, block(data.TALL_BLOCK_TOP))):
        scene.node(name, parent=box, mesh=scene.mesh(name, [(material, patch)], normals=False))
    data.add_camera(scene)
    return scene


if __name__ == "__main__":
    glb.generator_main(build, pathlib.Path(__file__).with_name("cornell.glb"))
