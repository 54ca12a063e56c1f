"""Scenes about light: many kinds of it, hard ways to it, and rooms whose answer is a formula.

A scene function fills a Gltf; its docstring is the scene's README.
"""

import math

from gltf_writer import hdr, through_rgbe
from market_kit import Parts
from shapes import Shape, add, cross, dot, lathe, scale, sphere, sub, unit

GREY = (0.5, 0.5, 0.5)


VEACH_EYE, VEACH_TARGET, VEACH_YFOV = (0, 4.5, 15), (0, 1.05, -2), 27
VEACH_ROUGHNESS, VEACH_RADII = (0.1, 0.2, 0.32, 0.5), (0.035, 0.1, 0.3, 0.85)
VEACH_LIGHTS_AT, VEACH_HALF_WIDTH, VEACH_HALF_DEPTH = (0, 4, -5.5), 3.9, 0.62


def veach_plate(i):
    """Corners and normal of a plate that mirrors the row of lights into the eye, past the other plates."""
    middle = (0, 0.6 - 0.32 * i, -2.6 + 1.75 * i)
    normal = unit(add(unit(sub(VEACH_EYE, middle)), unit(sub(VEACH_LIGHTS_AT, middle))))
    across, along = (VEACH_HALF_WIDTH, 0, 0), scale(cross(normal, (1, 0, 0)), VEACH_HALF_DEPTH)
    return [add(middle, add(scale(across, s), scale(along, t)))
            for s, t in ((-1, -1), (1, -1), (1, 1), (-1, 1))], normal


def veach_rows():
    """Where each plate begins and ends in the picture, as fractions of its height from the top."""
    forward = unit(sub(VEACH_TARGET, VEACH_EYE))
    up = cross((1, 0, 0), forward)
    rows = []
    for i in range(len(VEACH_ROUGHNESS)):
        seen = [sub(corner, VEACH_EYE) for corner in veach_plate(i)[0]]
        tangents = [dot(v, up) / dot(v, forward) for v in seen]
        edges = [0.5 - 0.5 * t / math.tan(math.radians(VEACH_YFOV / 2)) for t in tangents]
        rows.append("%.3f to %.3f" % (min(edges), max(edges)))
    return ", ".join(rows)


def veach_mis(gltf):
    """# Veach's plates

    Four metal plates, from nearly smooth at the back to rough in front, reflect four spherical lights of the
    same power and very different size, from 7 cm to 1.7 m across (after the scene of Veach and Guibas 1995,
    with dimensions of its own). Sampling the BSDF finds the large light in the smooth plate, sampling lights
    finds the small light in the rough plate, and only the combination is good everywhere. Each plate has rows
    of the picture for itself, whatever its size: %s
    of the height from the top, for the middle half of the columns where the picture is 16:9.

    **Right answer:** the same mean from `--strategy bsdf`, `light` and `mis`. `light` is noisy where a smooth
    plate shows the large light, since few points on it lie in the narrow lobe, and clean everywhere on the
    rough plate. `bsdf` is clean there and noisy where a rough plate shows the small light, and hardly finds
    what lights floor and wall. With `mis` no plate is much noisier than with the better of the two. A
    smooth plate shows each light as a disc, a rough one as a wide streak. The lights are 80 to 1,280
    triangles: `--light-sampler uniform` counts these and neglects the small lights, `power` does not, and
    `tree` also leaves out triangles that face away.
    """
    eye = VEACH_EYE
    floor = [(-14, -1, -9), (14, -1, -9), (14, -1, 12), (-14, -1, 12)]
    wall = [(-14, -1, -9), (14, -1, -9), (14, 10, -9), (-14, 10, -9)]
    gltf.object("floor", Shape().quad(floor, eye), gltf.lambert("floor", (0.3, 0.3, 0.3)))
    gltf.object("back wall", Shape().quad(wall, eye), gltf.lambert("wall", (0.3, 0.3, 0.3)))
    for i, roughness in enumerate(VEACH_ROUGHNESS):
        corners, normal = veach_plate(i)
        gltf.object("plate %d" % (i + 1), Shape().quad(corners, add(corners[0], normal)),
                    gltf.material("plate_%03d" % round(1000 * roughness), (0.8, 0.8, 0.85), metallic=1,
                                  roughness=roughness))
    for i, radius in enumerate(VEACH_RADII):
        radiance = 3.5 / radius ** 2  # the same power for all
        tint = ((1.0, 0.45, 0.3), (1.0, 0.9, 0.4), (0.5, 1.0, 0.5), (0.45, 0.6, 1.0))[i]
        center = add(VEACH_LIGHTS_AT, (-3.75 + 2.5 * i, 0, 0))
        gltf.object("light %d" % (i + 1), sphere(center, radius, (1, 2, 2, 3)[i]),
                    gltf.emitter("light_%d" % (i + 1), scale(tint, radiance)))
    gltf.camera(eye, VEACH_TARGET, VEACH_YFOV)
    return veach_rows()


def furnace_room(gltf):
    """# Furnace room

    A closed cube of 2 m whose every point reflects the fraction a = (0.25, 0.5, 0.8) of the light
    (Lambertian) and emits e = (1, 1, 1) W/(m^2 sr) itself. The camera is inside.

    **Right answer:** every pixel is e (1 + a + a^2 + ...) = e / (1 - a) = (1.3333, 2, 5). Cut after N
    indirect bounces (`--max-bounces N`), it is e times the sum of a^k for k from 0 to N + 1. Any other value
    anywhere is energy lost or made.
    """
    wall = gltf.material("furnace_wall", (0.25, 0.5, 0.8), specular=0, emission=(1, 1, 1))
    gltf.object("room", Shape().room((-1, -1, -1), (1, 1, 1)), wall)
    gltf.camera((0.2, 0.1, 0.7), (-0.3, -0.2, -1), 60)


def furnace_room_mirror(gltf):
    """# Furnace room with a mirror

    A closed cube of 2 m whose walls reflect the fraction a = (0.2, 0.35, 0.5) of the light (Lambertian) and
    emit e = (1, 1, 1) W/(m^2 sr), and in it a ball that is a perfect white mirror.

    **Right answer:** e / (1 - a) = (1.25, 1.5385, 2) in every pixel: the ball cannot be seen, as what it
    reflects is as bright everywhere. With `--max-bounces 30` what is cut off is less than a billionth. An
    outline or a stain is energy lost or made at mirrors, or counted twice when one follows another surface.
    There is no such room with rough metal: the model of glTF 2.0 lets light between microfacets get lost, so
    the answer is not a formula. Nor with dielectric gloss, as its reflectance depends on the angle.
    """
    wall = gltf.material("furnace_wall", (0.2, 0.35, 0.5), specular=0, emission=(1, 1, 1))
    gltf.object("room", Shape().room((-1, -1, -1), (1, 1, 1)), wall)
    mirror = gltf.material("mirror", (1, 1, 1), metallic=1, roughness=0)
    gltf.object("ball", sphere((-0.1, -0.2, -0.3), 0.5, 3), mirror)
    gltf.camera((0.2, 0.1, 0.8), (-0.1, -0.15, -1), 60)


def wall_with_doorway(shape, z, facing, left, right, head):
    for x0, x1, y0 in ((-2, left, 0), (right, 2, 0), (left, right, head)):
        shape.quad([(x0, y0, z), (x1, y0, z), (x1, 2.5, z), (x0, 2.5, z)], facing)


def table(gltf):
    """Where Veach's teapots stood: a vase of brass, a ball of porcelain and a matte bowl."""
    boards = Parts()
    boards.box("table", (-1.5, 0.66, 0.95), (-0.1, 0.7, 1.6))
    for x in (-1.45, -0.21):
        for z in (1.0, 1.49):
            boards.box("table", (x, 0, z), (x + 0.06, 0.66, z + 0.06))
    gltf.object("table", boards.shapes["table"], gltf.lambert("table", (0.35, 0.2, 0.1)))
    vase = [(0.09, 0), (0.14, 0.05), (0.18, 0.13), (0.185, 0.2), (0.16, 0.28), (0.1, 0.36), (0.07, 0.42),
            (0.065, 0.47), (0.075, 0.52), (0.1, 0.55)]
    brass = gltf.material("brass", (0.9, 0.68, 0.32), metallic=1, roughness=0.25)
    gltf.object("vase", lathe(vase, 32), brass, translation=[-1.2, 0.7, 1.25])
    porcelain = gltf.material("porcelain", (0.75, 0.75, 0.78), roughness=0.15)
    gltf.object("ball", sphere((0, 0, 0), 0.18, 3), porcelain, translation=[-0.75, 0.88, 1.3])
    bowl = [(0.07, 0), (0.075, 0.03), (0.13, 0.07), (0.18, 0.13), (0.205, 0.21), (0.19, 0.21), (0.165, 0.13),
            (0.12, 0.085), (0, 0.06)]
    glaze = gltf.lambert("bowl", (0.2, 0.38, 0.5))
    gltf.object("bowl", lathe(bowl, 32), glaze, translation=[-0.36, 0.7, 1.2])


def ajar_door(gltf):
    """# Ajar door

    The scene this renderer is named after (Veach 1997, rebuilt from nothing): a room without a lamp, lit
    only by what comes through a door that stands ajar to a bright room behind. The lamp is in that room's
    far corner and sees nothing of the front room but what lies in line with the gap.

    **Right answer:** with `--max-bounces 0` the picture is black but for the gaps beside the door, where the
    back room shows, and thin slivers of light on frame and walls. With bounces light falls through the gap
    onto wall, floor and ceiling beside it, and everything else is lit from there by further reflection.
    Hard: no light sampler can help where hardly any point sees the lamp, so all of them are equally noisy,
    and `bsdf` is worse, since it must hit the lamp itself.
    """
    white = gltf.lambert("white", (0.75, 0.75, 0.75))
    left, right, head = 0.3, 1.2, 2.1  # the doorway in the wall z = 0
    middle_front, middle_back = (0, 1.25, 2), (0, 1.25, -1.5)
    front = Shape().room((-2, 0, 0.05), (2, 2.5, 4), without=("-z", "-y"))
    back = Shape().room((-2, 0, -3), (2, 2.5, -0.05), without=("+z", "+y"))
    floor = Shape().quad([(-2, 0, 0.05), (2, 0, 0.05), (2, 0, 4), (-2, 0, 4)], middle_front)
    lamp = [(-1.6, 2.5, -2.4), (-0.6, 2.5, -2.4), (-0.6, 2.5, -1.4), (-1.6, 2.5, -1.4)]
    ceiling = [(-2, 2.5, -3), (2, 2.5, -3), (2, 2.5, -0.05), (-2, 2.5, -0.05)]
    back.frame(ceiling, lamp, middle_back)
    wall_with_doorway(front, 0.05, middle_front, left, right, head)
    wall_with_doorway(back, -0.05, middle_back, left, right, head)
    opening = (0.75, 1, 0)
    for corners in ([(left, 0), (right, 0)], [(left, 0), (left, head)], [(right, 0), (right, head)],
                    [(left, head), (right, head)]):
        (xa, ya), (xb, yb) = corners
        front.quad([(xa, ya, -0.05), (xb, yb, -0.05), (xb, yb, 0.05), (xa, ya, 0.05)], opening)
    gltf.object("front room", front, white)
    gltf.object("floor", floor, gltf.lambert("floor", (0.5, 0.4, 0.3)))
    gltf.object("back room", back, gltf.lambert("back_room", (0.8, 0.7, 0.55)))
    gltf.object("lamp", Shape().quad(lamp, middle_back), gltf.emitter("lamp", (520, 450, 340)))
    # The door hangs at the doorway's right side, opened 20 degrees into the front room.
    angle = math.radians(20)
    out, thick = (-math.cos(angle), 0, math.sin(angle)), (-0.04 * math.sin(angle), 0, -0.04 * math.cos(angle))
    hinge, width = (right - 0.01, 0.005, 0.06), 0.88
    free = add(hinge, scale(out, width))
    door = Shape().prism([hinge, free, add(free, thick), add(hinge, thick)], head - 0.03)
    gltf.object("door", door, gltf.lambert("door", (0.45, 0.25, 0.12)))
    table(gltf)
    gltf.camera((-0.3, 1.45, 3.7), (-0.05, 1.1, 0), 52)


def sky(direction):
    """The sky's radiance: a blue gradient, dark earth, a sun, a red patch at +X, a green one at +Z."""
    x, y, z = direction
    if y > 0:
        t = 1 - y
        radiance = (0.15 + 0.5 * t * t, 0.3 + 0.5 * t * t, 0.7 + 0.2 * t * t)
    else:
        radiance = (0.10, 0.09, 0.08)
    if y < 0.35 and x > 0.92:
        radiance = (2.0, 0.1, 0.1)
    if y < 0.35 and z > 0.92:
        radiance = (0.1, 1.5, 0.1)
    sun = unit((-0.6, 0.7, 0.4))
    if x * sun[0] + y * sun[1] + z * sun[2] > math.cos(math.radians(5)):
        radiance = (160.0, 144.0, 120.0)
    return radiance


def sky_map(width=128, height=64):
    rows = []
    for j in range(height):
        theta = math.pi * (j + 0.5) / height
        row = []
        for i in range(width):
            phi = 2 * math.pi * ((i + 0.5) / width - 0.5)  # u = atan2(z, x) / 2 pi + 1/2
            direction = (math.sin(theta) * math.cos(phi), math.cos(theta), math.sin(theta) * math.sin(phi))
            row.append(through_rgbe(sky(direction)))
        rows.append(row)
    return rows


def sky_irradiance(rows):
    """On an unoccluded level surface: the integral of L cos(theta), summed over the map's texels."""
    width, height, total = len(rows[0]), len(rows), [0.0, 0.0, 0.0]
    for j in range(height // 2):
        low, high = math.pi * j / height, math.pi * (j + 1) / height
        # Integral of cos sin dtheta over the row, times the texel's width in phi.
        weight = (math.sin(high) ** 2 - math.sin(low) ** 2) / 2 * 2 * math.pi / width
        for pixel in rows[j]:
            total = [t + weight * c for t, c in zip(total, pixel)]
    return total


def environment_only(gltf):
    """# Environment only

    Three spheres on a plane and no lamp: all light comes from `sky.hdr`, a synthetic sky of 128 x 64 texels
    with a small sun, hundreds of times as bright as the rest. Render it with `--env
    scenes/environment-only/sky.hdr`. To show the map's orientation, a red patch stands at +X and a green
    one at +Z (behind the camera).

    **Right answer:** in the mirror sphere the red patch is on the right and the green one in the middle;
    shadows fall away from the sun, to the right and back. Far from the spheres the plane (albedo 0.5) has the
    radiance 0.5 E / pi = %s,
    with E = %s W/m^2 as the generator sums it over the map.
    """
    rows = sky_map()
    gltf.images["sky.hdr"] = hdr(rows)
    ground = [(-6, 0, -6), (6, 0, -6), (6, 0, 6), (-6, 0, 6)]
    gltf.object("ground", Shape().quad(ground, (0, 1, 0)), gltf.lambert("ground", GREY))
    ball = gltf.attributes(sphere((0, 0, 0), 0.5, 4))
    gltf.object("matte ball", ball, gltf.lambert("ball", (0.8, 0.4, 0.2)), translation=[-1.2, 0.5, 0])
    gltf.object("mirror ball", ball, gltf.material("mirror", (0.9, 0.9, 0.9), metallic=1, roughness=0),
                translation=[0, 0.5, 0])
    gltf.object("plastic ball", ball, gltf.material("plastic", (0.05, 0.25, 0.1), roughness=0.3),
                translation=[1.2, 0.5, 0])
    gltf.camera((0, 1.6, 4.5), (0, 0.35, 0), 40)
    irradiance = sky_irradiance(rows)
    return tuple("(%.4f, %.4f, %.4f)" % tuple(v) for v in (scale(irradiance, 0.5 / math.pi), irradiance))
