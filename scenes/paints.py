# SPDX-License-Identifier: Apache-2.0
"""Materials by name for scenes that look as exported: dielectrics unless the name says metal, double-sided."""

import random

import displays
import finishes
import glb
import textures

# Linear base colour, roughness; 0.5 is what modellers leave.
PLASTIC = {
    "white": ((0.80, 0.80, 0.78), 0.5), "ceiling": ((0.84, 0.84, 0.82), 0.9), "graphite": ((0.05, 0.05, 0.055), 0.4),
    "keys": ((0.16, 0.16, 0.17), 0.5), "black rubber": ((0.02, 0.02, 0.02), 0.6), "paper": ((0.82, 0.80, 0.72), 0.9),
    "porcelain": ((0.82, 0.81, 0.78), 0.08), "red glaze": ((0.52, 0.06, 0.04), 0.12),
    "blue glaze": ((0.04, 0.13, 0.38), 0.15), "green glaze": ((0.06, 0.26, 0.16), 0.2),
    "yellow plastic": ((0.80, 0.52, 0.05), 0.35), "coffee": ((0.05, 0.02, 0.01), 0.05),
    "shade cloth": ((0.84, 0.78, 0.66), 0.8), "enamel green": ((0.05, 0.20, 0.14), 0.25),
    "enamel red": ((0.46, 0.07, 0.04), 0.25), "terracotta": ((0.56, 0.25, 0.14), 0.75), "soil": ((0.05, 0.035, 0.03), 1.0),
    "leaf": ((0.08, 0.28, 0.07), 0.4), "apple": ((0.55, 0.06, 0.04), 0.3), "stalk": ((0.16, 0.10, 0.05), 0.7),
    "carton": ((0.48, 0.33, 0.20), 0.85), "skirting": ((0.80, 0.79, 0.76), 0.4), "plum wall": ((0.20, 0.08, 0.13), 0.6),
    "teal wall": ((0.10, 0.25, 0.28), 0.6), "sand wall": ((0.60, 0.50, 0.38), 0.6),
}
METAL = {
    "mirror": ((0.95, 0.95, 0.95), 0.0), "chrome": ((0.77, 0.78, 0.78), 0.0), "steel": ((0.56, 0.57, 0.58), 0.35),
    "black steel": ((0.10, 0.10, 0.11), 0.4), "brass": ((0.88, 0.66, 0.30), 0.25), "gold mirror": ((0.98, 0.78, 0.42), 0.0),
    "copper": ((0.93, 0.56, 0.42), 0.18), "aluminium": ((0.91, 0.92, 0.92), 0.3),
}
LOOKS = {
    "oak floor": finishes.planks,
    "dull floor": lambda draw: finishes.planks(draw, (120, 92, 66), (196, 164, 128), 0.35, 0.6),
    "wood": finishes.wood,
    "walnut": lambda draw: finishes.wood(draw, (58, 36, 24), (112, 74, 48), 0.25, 0.5),
    "tiles": finishes.tiles,
    "dark tiles": lambda draw: finishes.tiles(draw, (38, 56, 62), (66, 92, 98), (150, 146, 138), 0.10),
    "plaster": finishes.plaster,
    "warm plaster": lambda draw: finishes.plaster(draw, (188, 160, 128), (216, 192, 160)),
    "worn metal": finishes.worn_metal, "brushed metal": finishes.brushed_metal, "rusted metal": finishes.rusted,
    "stone": finishes.stone,
    "rug": lambda draw: finishes.carpet(draw, (84, 28, 32), (206, 178, 140)),
    "blue rug": lambda draw: finishes.carpet(draw, (34, 48, 84), (180, 184, 176)),
    "grey carpet": finishes.carpet_tiles,
    "grey fabric": lambda draw: finishes.fabric(draw, (84, 88, 94), (142, 146, 150)),
    "mustard fabric": lambda draw: finishes.fabric(draw, (166, 112, 28), (222, 172, 74)),
    "rust fabric": lambda draw: finishes.fabric(draw, (128, 54, 34), (190, 98, 66)),
    "teal fabric": lambda draw: finishes.fabric(draw, (22, 74, 80), (66, 128, 132)),
    "towel": lambda draw: finishes.fabric(draw, (196, 84, 62), (238, 140, 112)),
}
# Base colour from a picture, one roughness.
PICTURES = {
    "landscape": (lambda draw: textures.landscape(), 0.5), "abstract": (displays.abstract, 0.6),
    "dial": (lambda draw: displays.clock_face(), 0.4),
    "red book": (lambda draw: displays.book_cover((150, 44, 36)), 0.7),
    "blue book": (lambda draw: displays.book_cover((40, 70, 128)), 0.7),
    "green book": (lambda draw: displays.book_cover((44, 96, 66)), 0.7),
    "cream book": (lambda draw: displays.book_cover((214, 200, 170), (120, 60, 40)), 0.7),
}
# cd/m2 per linear Rec.709 channel.
LIGHTS = {
    "bulb": (11000.0, 8600.0, 6000.0), "small bulb": (9000.0, 7200.0, 5000.0), "tube": (9000.0, 8800.0, 8400.0),
    "panel": (3500.0, 3400.0, 3200.0), "fairy": (6000.0, 4200.0, 2200.0),
}
# Pictures that shine: a white texel emits this much.
DISPLAYS = {
    "dashboard": (displays.dashboard, 420.0), "document": (displays.text_page, 320.0),
    "window": (lambda draw: displays.sky(), 900.0),
}
CLAMPED = {"landscape", "abstract", "dial", "dashboard", "document", "window"}


class Paints(dict):
    """Maps names to materials of `scene`, and makes each when it is first asked for."""

    def __init__(self, scene):
        super().__init__()
        self.scene = scene

    def __missing__(self, name):
        self[name] = self._make(name, random.Random(name).random)
        return self[name]

    def plain(self, name, colour, roughness, metallic=0.0):
        """Adds a material of the scene's own."""
        self[name] = self.scene.finish(name, colour, roughness, metallic)

    def _make(self, name, draw):
        if name in PLASTIC:
            return self.scene.finish(name, *PLASTIC[name])
        if name in METAL:
            return self.scene.finish(name, *METAL[name], metallic=1.0)
        if name in LIGHTS:
            return self.scene.finish(name, (0.8, 0.8, 0.8), 0.5, glow=LIGHTS[name])
        if name in LOOKS:
            kinds = ("colour", "finish")
            pair = [self._texture(f"{name} {kind}", png, name) for kind, png in zip(kinds, LOOKS[name](draw))]
            cloth = 0.5 if "fabric" in name or name == "towel" else None
            return self.scene.finish(name, look=pair, specular=cloth)
        if name in PICTURES:
            paint, roughness = PICTURES[name]
            return self.scene.finish(name, look=(self._texture(name, paint(draw), name), None), roughness=roughness)
        paint, luminance = DISPLAYS[name]
        return self.scene.finish(name, (0.02, 0.02, 0.02), 0.25, glow=(luminance,) * 3,
                                 glow_texture=self._texture(name, paint(draw), name))

    def _texture(self, label, png, name):
        return self.scene.texture(label, png, wrap=glb.CLAMP_TO_EDGE if name in CLAMPED else glb.REPEAT)
