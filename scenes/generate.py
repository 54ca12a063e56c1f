#!/usr/bin/env python3
"""Writes every scene of this folder: run it after a change and commit what it wrote. Python 3.8, nothing else.

One function per scene; its docstring is the scene's README. `generate.py --into FOLDER` writes elsewhere (a test does,
and compares). Cornell box: Goral, Torrance, Greenberg and Battaile 1984, with the dimensions Cornell measured.
"""

import inspect
import os
import sys

sys.dont_write_bytecode = True  # leave no __pycache__ in the tree
from gltf_writer import Gltf  # noqa: E402
from shapes import Shape  # noqa: E402

CORNELL_WHITE, CORNELL_RED, CORNELL_GREEN = (0.725, 0.71, 0.68), (0.63, 0.065, 0.05), (0.14, 0.45, 0.091)
CORNELL_LIGHT = (17, 12, 4)


def cornell(x, y, z):
    """Cornell's millimetres (x to the left, z into the box) to metres around the box's middle, camera on +Z."""
    return ((278.0 - x) / 1000, y / 1000, (279.6 - z) / 1000)


def cornell_room(gltf, light_radiance=CORNELL_LIGHT):
    """Walls, light and camera. The light fills a hole in the ceiling, so its back lights nothing."""
    inside = cornell(278, 274, 280)
    white = gltf.lambert("white", CORNELL_WHITE)
    outer = [cornell(*p) for p in ((556, 548.8, 0), (556, 548.8, 559.2), (0, 548.8, 559.2), (0, 548.8, 0))]
    inner = [cornell(*p) for p in ((343, 548.8, 227), (343, 548.8, 332), (213, 548.8, 332), (213, 548.8, 227))]
    floor = [cornell(*p) for p in ((552.8, 0, 0), (549.6, 0, 559.2), (0, 0, 559.2), (0, 0, 0))]
    walls = Shape().quad(floor, inside).frame(outer, inner, inside)
    walls.quad([floor[1], floor[2], outer[2], outer[1]], inside)
    gltf.object("white walls", walls, white)
    gltf.object("red wall", Shape().quad([floor[0], floor[1], outer[1], outer[0]], inside),
                gltf.lambert("red", CORNELL_RED))
    gltf.object("green wall", Shape().quad([floor[3], floor[2], outer[2], outer[3]], inside),
                gltf.lambert("green", CORNELL_GREEN))
    gltf.object("light", Shape().quad(inner, inside), gltf.emitter("light", light_radiance))
    gltf.camera(cornell(278, 273, -800), cornell(278, 273, 0), 39.307653)  # 25 mm of film behind a 35 mm lens
    return white


def cornell_box(gltf):
    """# Cornell box

    The classic box: white, red and green walls, a short and a tall block, one square light.
    Dimensions are those that Cornell University measured, in metres (the box is 0.55 m wide); the reflectances are the
    usual RGB fits of the measured spectra. Every surface is exactly Lambertian (`lambert_*`: dielectric specular
    factor 0), the light (`emit_light`) emits 17, 12, 4 W/(m^2 sr) and reflects nothing. It fills a hole in the ceiling, so
    that a renderer whose emitters are two-sided sees the same scene.

    **Right answer:** the walls' colours bleed onto the blocks; the light is a flat (17, 12, 4); the ceiling is lit by
    reflection only. With `--max-bounces 0` the ceiling is black.
    """
    white = cornell_room(gltf)
    short = [cornell(x, 0, z) for x, z in ((130, 65), (82, 225), (240, 272), (290, 114))]
    tall = [cornell(x, 0, z) for x, z in ((423, 247), (265, 296), (314, 456), (472, 406))]
    gltf.object("short block", Shape().prism(short, 0.165), white)
    gltf.object("tall block", Shape().prism(tall, 0.330), white)


SCENES = {"cornell-box": cornell_box}

FOOTER = "\n**Made by** `scenes/generate.py`, from nothing but numbers. **Licence:** CC0 1.0 (public domain).\n"


def main():
    target = os.path.dirname(os.path.abspath(__file__))
    if len(sys.argv) == 3 and sys.argv[1] == "--into":
        target = sys.argv[2]
    elif len(sys.argv) != 1:
        sys.exit("usage: generate.py [--into FOLDER]")
    for name, build in SCENES.items():
        gltf = Gltf(name)
        build(gltf)
        gltf.write(os.path.join(target, name), inspect.cleandoc(build.__doc__) + "\n" + FOOTER)


if __name__ == "__main__":
    main()
