"""The Cornell box and its relatives (Goral et al. 1984; dimensions measured at Cornell).

A scene function fills a Gltf; its docstring is the scene's README.
"""

from shapes import Shape, sphere

CORNELL_WHITE, CORNELL_RED, CORNELL_GREEN = (0.725, 0.71, 0.68), (0.63, 0.065, 0.05), (0.14, 0.45, 0.091)
CORNELL_LIGHT = (17, 12, 4)


def cornell(x, y, z):
    """Cornell's millimetres (x to the left, z into the box) to metres about the box's axis, camera on +Z."""
    return ((278.0 - x) / 1000, y / 1000, (279.6 - z) / 1000)


def cornell_room(gltf, light_radiance=CORNELL_LIGHT):
    """Walls, light and camera. The light fills a hole in the ceiling, so its back lights nothing."""
    inside = cornell(278, 274, 280)
    white = gltf.lambert("white", CORNELL_WHITE)
    outer = [cornell(x, 548.8, z) for x, z in ((556, 0), (556, 559.2), (0, 559.2), (0, 0))]
    inner = [cornell(x, 548.8, z) for x, z in ((343, 227), (343, 332), (213, 332), (213, 227))]
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

    The classic box: white, red and green walls, a short and a tall block, one square light. Dimensions are
    those that Cornell University measured, in metres (the box is 0.55 m wide); the reflectances are the
    usual RGB fits of the measured spectra. Every surface is exactly Lambertian (`lambert_*`: dielectric
    specular factor 0), the light (`emit_light`) emits 17, 12, 4 W/(m^2 sr) and reflects nothing. It fills a
    hole in the ceiling, so that a renderer whose emitters are two-sided sees the same scene.

    **Right answer:** the walls' colours bleed onto the blocks; the light is a flat (17, 12, 4); the ceiling
    is lit by reflection only. With `--max-bounces 0` the ceiling is black.
    """
    white = cornell_room(gltf)
    short = [cornell(x, 0, z) for x, z in ((130, 65), (82, 225), (240, 272), (290, 114))]
    tall = [cornell(x, 0, z) for x, z in ((423, 247), (265, 296), (314, 456), (472, 406))]
    gltf.object("short block", Shape().prism(short, 0.165), white)
    gltf.object("tall block", Shape().prism(tall, 0.330), white)


def glossy_and_specular(gltf):
    """# Glossy and specular

    The Cornell box with a perfect mirror (roughness 0, `mirror`), a glossy metal sphere (roughness 0.2,
    `glossy`) and a glossy plastic slab under them (dielectric, roughness 0.3). Walls and light as in
    `cornell-box`. The mirror can only be seen by following its reflection, the glossy sphere is found by
    both kinds of sampling: the scene where estimators differ most while their means must not. Light that
    the mirror throws onto the walls is a caustic.

    **Right answer:** the mirror sphere shows the open front as black and the light as flat (17, 12, 4)
    times the metal's reflectance; all estimators agree, also `--strategy light`: no shadow ray finds a light
    in a mirror, so there the reflected ray counts it. Only `--naive-sampling cosine` leaves the mirror black.
    """
    cornell_room(gltf)
    ball = sphere((0, 0, 0), 0.09, 4)
    slab = [(-0.22, 0, 0.16), (-0.22, 0, -0.2), (0.22, 0, -0.2), (0.22, 0, 0.16)]
    gltf.object("slab", Shape().prism(slab, 0.02), gltf.material("plastic", (0.1, 0.2, 0.5), roughness=0.3))
    stored = gltf.attributes(ball)
    gltf.object("mirror ball", stored, gltf.material("mirror", (0.95, 0.93, 0.88), metallic=1, roughness=0),
                translation=[-0.11, 0.11, -0.06])
    gltf.object("glossy ball", stored, gltf.material("glossy", (1.0, 0.77, 0.34), metallic=1, roughness=0.2),
                translation=[0.11, 0.11, 0.03])
