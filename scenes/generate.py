#!/usr/bin/env python3
"""Writes every scene of this folder: run it after a change and commit what it wrote. Needs Python 3.8 only.

`generate.py --into FOLDER` writes elsewhere (a test does, and compares). To add a scene: a function in one
of the *_scenes.py files, whose docstring is the scene's README, and a row here.
"""

import inspect
import os
import sys

sys.dont_write_bytecode = True  # leave no __pycache__ in the tree
from cornell_scenes import cornell_box, glossy_and_specular  # noqa: E402
from gltf_writer import Gltf  # noqa: E402
import light_scenes as light  # noqa: E402
import market_scenes as market  # noqa: E402
from sphere_scene import sphere_lights  # noqa: E402
from textured_scene import textured  # noqa: E402

SCENES = {"cornell-box": cornell_box, "glossy-and-specular": glossy_and_specular,
          "veach-mis": light.veach_mis, "environment-only": light.environment_only,
          "furnace-room": light.furnace_room, "furnace-room-mirror": light.furnace_room_mirror,
          "ajar-door": light.ajar_door, "many-lights-100": market.many_lights_100,
          "many-lights-10000": market.many_lights_10000,
          "many-lights-100000": market.many_lights_100000,
          "many-lights-walled-10000": market.many_lights_walled_10000,
          "many-lights-walled-100000": market.many_lights_walled_100000, "sphere-lights": sphere_lights,
          "textured": textured}

FOOTER = "**Made by** `scenes/generate.py`, from nothing but numbers. **Licence:** CC0 1.0 (public domain).\n"


def main():
    target = os.path.dirname(os.path.abspath(__file__))
    if len(sys.argv) == 3 and sys.argv[1] == "--into":
        target = sys.argv[2]
    elif len(sys.argv) != 1:
        sys.exit("usage: generate.py [--into FOLDER]")
    for name, build in SCENES.items():
        gltf = Gltf(name)
        figures = build(gltf)  # for the docstring's %s
        readme = inspect.cleandoc(build.__doc__)
        gltf.write(os.path.join(target, name), (readme % figures if figures else readme) + "\n\n" + FOOTER)


if __name__ == "__main__":
    main()
