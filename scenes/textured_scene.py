"""The scene of textures: every kind that core glTF has, with texels whose answer can be worked out."""

import math

from gltf_writer import png
from shapes import Shape

NEAREST_REPEAT = {"magFilter": 9728, "minFilter": 9728, "wrapS": 10497, "wrapT": 10497}
NEAREST_CLAMP = {**NEAREST_REPEAT, "wrapS": 33071, "wrapT": 33071}
LINEAR_CLAMP = {"magFilter": 9729, "minFilter": 9729, "wrapS": 33071, "wrapT": 33071}
UNIT_UVS = [(0, 1), (1, 1), (1, 0), (0, 0)]


def checker(light, dark, cells=8):
    return png([[v for x in range(cells) for v in ([light] * 3 if (x + y) % 2 == 0 else [dark] * 3)]
                for y in range(cells)], 3)


def studs(size=64, cells=4):
    """A tangent-space normal map of round studs (+Y up, as glTF has it)."""
    rows = []
    for j in range(size):
        row = []
        for i in range(size):
            x, y = ((i + 0.5) / size * cells) % 1 * 2 - 1, 1 - ((j + 0.5) / size * cells) % 1 * 2
            r = math.hypot(x, y)
            slope = 0.6 * math.sin(math.pi * r / 0.8) / r if 0 < r < 0.8 else 0
            n = (x * slope, y * slope, 1)
            length = math.sqrt(sum(c * c for c in n))
            row += [round(255 * (c / length + 1) / 2) for c in n]
        rows.append(row)
    return png(rows, 3)


def leaf(size=64):
    """A leaf in alpha with hard edges, one vein lighter."""
    rows = []
    for j in range(size):
        row = []
        for i in range(size):
            x, y = (i + 0.5) / size * 2 - 1, (j + 0.5) / size * 2 - 1
            inside = abs(x) < 0.75 * (1 - y * y) ** 1.5 and abs(y) < 0.97
            row += [90, 170, 60] if abs(x) > 0.06 else [170, 210, 120]
            row += [255 if inside else 0]
        rows.append(row)
    return png(rows, 4)


def fade(size=16):
    """Alpha from 0 on the left to 255 on the right."""
    row = [v for i in range(size) for v in (220, 60, 40, round(255 * i / (size - 1)))]
    return png([row] * size, 4)


def roughness_steps():
    """G = roughness, B = metallic: four columns of rising roughness, dielectric below and metal above."""
    return png([[v for rough in (26, 90, 160, 255) for v in (0, rough, metal)] for metal in (255, 0)], 3)


def glow():
    return png([[255, 0, 0, 0, 255, 0], [0, 0, 255, 255, 255, 255]], 3)


def upright(x, y, z, half):
    return [(x + s * half, y + t * half, z) for s, t in ((-1, -1), (1, -1), (1, 1), (-1, 1))]


def textured(gltf):
    """# Textured

    One card for each use of a texture: a checkered floor (sRGB greys, nearest), a wall of studs (normal
    map), a panel of roughness and metallic steps, a leaf (alpha MASK), a fading red card (alpha BLEND) and
    a glowing panel of four colours (emissive texture). A square light shines from above, so that leaf and
    card throw shadows.

    **Right answer:** the checker's sRGB greys 188 and 99 are albedos of 0.5029 and 0.1248 (a ratio of 4.03;
    undecoded they would be 1.9). The studs bulge out of the wall and are lit from above. The leaf has hard
    edges, also in its shadow; the red card fades out to the left, and its shadow with it. The glowing panel
    shows red, green (top), blue, white (bottom), blended into each other, of radiance 2 at most.
    """
    eye = (0, 1.1, 3.6)
    floor = [(-2, 0, 2), (2, 0, 2), (2, 0, -1), (-2, 0, -1)]
    greys = gltf.texture("checker.png", checker(188, 99), NEAREST_REPEAT)
    gltf.object("floor", Shape().quad(floor, eye, [(0, 1.5), (2, 1.5), (2, 0), (0, 0)]),
                gltf.material("floor", specular=0, pbr={"baseColorTexture": greys}))
    wall = [(-2, 0, -1), (2, 0, -1), (2, 2.4, -1), (-2, 2.4, -1)]
    normal_map = gltf.texture("studs.png", studs(), {"magFilter": 9729, "minFilter": 9729})
    gltf.object("wall", Shape().quad(wall, eye, [(0, 3), (5, 3), (5, 0), (0, 0)]),
                gltf.material("wall", (0.6, 0.6, 0.65), roughness=0.6, normalTexture=normal_map))
    steps = gltf.texture("steps.png", roughness_steps(), NEAREST_CLAMP)
    slope = [(-1.9, 0.02, 1.4), (-0.7, 0.02, 1.4), (-0.7, 0.5, 0.9), (-1.9, 0.5, 0.9)]
    gltf.object("steps", Shape().quad(slope, eye, UNIT_UVS),
                gltf.material("steps", (0.9, 0.75, 0.4), metallic=1, pbr={"metallicRoughnessTexture": steps}))
    leaves = gltf.texture("leaf.png", leaf(), LINEAR_CLAMP)
    gltf.object("leaf", Shape().quad(upright(-0.35, 0.5, 0.7, 0.45), eye, UNIT_UVS),
                gltf.material("leaf", specular=0, pbr={"baseColorTexture": leaves}, alphaMode="MASK",
                              alphaCutoff=0.5, doubleSided=True))
    fading = gltf.texture("fade.png", fade(), LINEAR_CLAMP)
    gltf.object("fading card", Shape().quad(upright(0.6, 0.45, 0.7, 0.4), eye, UNIT_UVS),
                gltf.material("fade", specular=0, pbr={"baseColorTexture": fading}, alphaMode="BLEND",
                              doubleSided=True))
    panel = gltf.texture("glow.png", glow(), LINEAR_CLAMP)
    gltf.object("glowing panel", Shape().quad(upright(1.5, 0.5, 0.3, 0.3), eye, UNIT_UVS),
                gltf.material("glow", (0, 0, 0), specular=0, emission=(2, 2, 2), emissiveTexture=panel))
    lamp = [(-0.6, 2.6, 0.4), (0.6, 2.6, 0.4), (0.6, 2.6, 1.6), (-0.6, 2.6, 1.6)]
    gltf.object("lamp", Shape().quad(lamp, (0, 0, 1)), gltf.emitter("lamp", (12, 12, 12)))
    gltf.camera(eye, (0, 0.75, 0), 42)
