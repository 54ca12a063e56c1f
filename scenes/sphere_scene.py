"""The scene of lights that are spheres: meshes, punctual lights with a radius and a sun with a diameter.

The irradiance of a sphere light of radiance L and radius r at distance d, wholly above the horizon, is
pi L (r/d)^2 cos(theta): the view factor of a sphere (Howell, "A Catalog of Radiation Heat Transfer
Configuration Factors", B-21).
"""

import math

from shapes import Shape, add, dot, scale, sphere, sub, unit

# Center and radius in metres, radiance.
GLOBES = {
    "great": ((-3.4, 3.0, -3.6), 0.8, (6, 2.2, 0.6)), "middle": ((3.3, 2.1, -1.4), 0.3, (0.9, 12.0, 20.0)),
    "small": ((0.9, 1.15, 0.35), 0.08, (110, 20, 60)), "tiny": ((-0.95, 0.3, 0.55), 0.025, (520, 300, 60)),
    "moon": ((8.5, 7.4, -24.0), 1.5, (1.2, 2.2, 4.0))}
LAMP_AT, LAMP_RADIUS, LAMP_INTENSITY, LAMP_COLOR = (-1.2, 4.2, 3.4), 0.3, 16, (1, 0.9, 0.8)
SPOT_AT, SPOT_TO, SPOT_OUTER = (3.6, 3.6, 2.2), (1.9, 0.5, -0.5), 0.26
SUN_FROM, SUN_IRRADIANCE, SUN_COLOR, SUN_DEGREES = unit((-0.75, 0.7, -0.25)), 0.35, (0.75, 0.85, 1.0), 2
BALLS = {"matte": (-1.9, 0.5, -0.5), "rough": (0, 0.5, -0.5), "glossy": (1.9, 0.5, -0.5)}
BALL_RADIUS, TILE, TILE_HALF, TILE_ALBEDO = 0.5, (0.2, 0.02, 2.0), 0.25, (0.8, 0.8, 0.8)


def clear_of(point, target, radius, center, ball):
    """Whether a ball leaves the cone from a point to a sphere untouched."""
    to_light, to_ball = sub(target, point), sub(center, point)
    along, reach = math.sqrt(dot(to_light, to_light)), math.sqrt(dot(to_ball, to_ball))
    angle = math.acos(dot(to_light, to_ball) / (along * reach))
    return reach > along or angle > math.asin(radius / along) + math.asin(ball / reach)


def tile_irradiance(point):
    """From everything in the scene by the formula; nothing may hide any light from the tile."""
    total = [0.0, 0.0, 0.0]
    far_sun = add(point, scale(SUN_FROM, 1000))
    lights = [(center, radius, scale(radiance, math.pi * radius ** 2))
              for center, radius, radiance in GLOBES.values()]
    lights.append((LAMP_AT, LAMP_RADIUS, scale(LAMP_COLOR, LAMP_INTENSITY)))
    lights.append((far_sun, 1000 * math.radians(SUN_DEGREES / 2), scale(SUN_COLOR, 1e6 * SUN_IRRADIANCE)))
    for center, radius, intensity in lights:
        to = sub(center, point)
        distance2 = dot(to, to)
        assert to[1] > radius
        hidden = list((place, BALL_RADIUS) for place in BALLS.values())
        hidden += [(c, r) for c, r, _ in GLOBES.values() if c != center]
        assert all(clear_of(point, center, radius, c, r) for c, r in hidden), center
        cosine = to[1] / math.sqrt(distance2)
        total = [t + i * cosine / distance2 for t, i in zip(total, intensity)]
    axis, to_tile = unit(sub(SPOT_TO, SPOT_AT)), unit(sub(point, SPOT_AT))
    assert dot(axis, to_tile) < math.cos(SPOT_OUTER)
    return total


def sphere_lights(gltf):
    """# Sphere lights

    Lights that are spheres, small and large, near and far, over a matte floor and three balls: matte, rough
    metal and glossy metal. Five glow as meshes (`extras: {"ajar_sphere": true}` on the mesh: a renderer that
    knows the key treats them as true spheres, any other as 1,280 triangles). A point light and a spot light
    have `extras: {"radius": metres}`: they are not seen directly, but their shadows are soft and the glossy
    ball shows them. A directional light has `extras: {"angular_diameter_degrees": 2}`.

    **Right answer:** a sphere of radiance L and radius r at distance d gives the irradiance pi L (r/d)^2 cos,
    however large it is, as long as it is wholly above the horizon; a punctual light's radius changes its
    shadows and not its irradiance. Everything but the spot light reaches the white tile in front unhindered:
    with `--max-bounces 0` its middle has the radiance 0.8 E / pi = (%.4f, %.4f, %.4f). Every strategy and
    light sampler has the same mean, though `bsdf` alone can hardly find the tiny globe. Sampling the cone
    that a sphere covers leaves no noise from distance and orientation, so what `light` shows on floor and
    tile is the choice among lights and the edges of shadows; it is noisy in the glossy ball where that
    shows the great globe.
    """
    ground = [(-40, 0, 12), (40, 0, 12), (40, 0, -40), (-40, 0, -40)]
    gltf.object("ground", Shape().quad(ground, (0, 1, 0)), gltf.lambert("ground", (0.45, 0.43, 0.4)))
    x, y, z = TILE
    base = [(x + s * TILE_HALF, 0, z + t * TILE_HALF) for s, t in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    gltf.object("tile", Shape().prism(base, y), gltf.lambert("tile", TILE_ALBEDO))
    skins = {"matte": gltf.lambert("matte", (0.75, 0.72, 0.68)),
             "rough": gltf.material("rough", (0.95, 0.64, 0.45), metallic=1, roughness=0.45),
             "glossy": gltf.material("glossy", (0.9, 0.9, 0.92), metallic=1, roughness=0.12)}
    ball = gltf.attributes(sphere((0, 0, 0), BALL_RADIUS, 4))
    for name, place in BALLS.items():
        gltf.object(name + " ball", ball, skins[name], translation=list(place))
    globe = gltf.attributes(sphere((0, 0, 0), 1, 3))
    for name, (center, radius, radiance) in GLOBES.items():
        mesh = gltf.mesh(name + " globe", (globe, gltf.emitter(name, radiance)), extras={"ajar_sphere": True})
        gltf.node(name + " globe", mesh=mesh, translation=list(center), scale=[radius] * 3)
    gltf.light("lamp", "point", LAMP_AT, (0, 0, -1), LAMP_COLOR, LAMP_INTENSITY,
               extras={"radius": LAMP_RADIUS})
    gltf.light("spot", "spot", SPOT_AT, sub(SPOT_TO, SPOT_AT), (1, 0.75, 0.5), 60, extras={"radius": 0.12},
               spot={"innerConeAngle": 0.18, "outerConeAngle": SPOT_OUTER})
    gltf.light("sun", "directional", (0, 5, 0), scale(SUN_FROM, -1), SUN_COLOR, SUN_IRRADIANCE,
               extras={"angular_diameter_degrees": SUN_DEGREES})
    gltf.camera((0, 1.7, 5.7), (0, 0.96, -0.5), 38)
    for s, t in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
        tile_irradiance(add(TILE, (s * TILE_HALF, 0, t * TILE_HALF)))
    return tuple(a * e / math.pi for a, e in zip(TILE_ALBEDO, tile_irradiance(TILE)))
