"""Parts of a night market for the scene generator: stalls, houses, a lit tree, lanterns and strings of bulbs.

A kit builds one square of CELL metres about its own origin. Everything stays inside REACH and below
LAMP_TOP, so that walls between squares cut nothing. Solids have no stored normals: they are flat.
"""

import math

from shapes import Shape, add, cross, dot, scale, sub, unit

CELL, REACH, LAMP_TOP = 6.0, 2.8, 4.3
LIGHTS_PER_CELL = 100
BULBS = ("red", "amber", "green", "cyan", "blue", "violet", "rose", "gold")
FRUIT = ("orange", "lime", "plum", "lemon")


class Chance:
    """Numerical Recipes' linear congruential generator: the same numbers with every Python."""

    def __init__(self, seed):
        self.state = seed * 7919 + 1
        for _ in range(8):
            self.below(2)

    def below(self, count):
        self.state = (self.state * 1664525 + 1013904223) % 2 ** 32
        return (self.state >> 16) * count >> 16

    def between(self, low, high):
        return low + (high - low) * self.below(4096) / 4095

    def of(self, items):
        return items[self.below(len(items))]


class Parts:
    """Flat solids, sorted by the material that they have."""

    def __init__(self):
        self.shapes = {}

    def faces(self, material, points, faces):
        shape = self.shapes.setdefault(material, Shape())
        first = len(shape.positions)
        shape.positions += points
        for face in faces:
            for k in range(1, len(face) - 1):
                shape.triangles.append((first + face[0], first + face[k], first + face[k + 1]))

    def solid(self, material, points, faces):
        """A convex solid, each face turned outwards."""
        middle = scale(tuple(sum(axis) for axis in zip(*points)), 1 / len(points))
        turned = []
        for face in faces:
            a, b, c = (points[i] for i in face[:3])
            outward = dot(cross(sub(b, a), sub(c, a)), sub(a, middle)) > 0
            turned.append(face if outward else face[::-1])
        self.faces(material, points, turned)

    def slab(self, material, lower, upper):
        """A body between two quads of corners in the same order."""
        sides = [(i, (i + 1) % 4, (i + 1) % 4 + 4, i + 4) for i in range(4)]
        self.solid(material, list(lower) + list(upper), [(0, 1, 2, 3), (4, 5, 6, 7)] + sides)

    def box(self, material, lower, upper):
        (x0, y0, z0), (x1, y1, z1) = lower, upper
        base = [(x0, z0), (x1, z0), (x1, z1), (x0, z1)]
        self.slab(material, [(x, y0, z) for x, z in base], [(x, y1, z) for x, z in base])

    def post(self, material, x, z, bottom, top, half=0.03):
        self.box(material, (x - half, bottom, z - half), (x + half, top, z + half))

    def ball8(self, material, center, radius):
        """An octahedron."""
        points = [add(center, tuple(s * radius * (k == axis) for k in range(3)))
                  for axis in range(3) for s in (-1, 1)]
        self.solid(material, points, [(a, b, c) for a in (0, 1) for b in (2, 3) for c in (4, 5)])

    def ball20(self, material, center, radius, height=1.0):
        """An icosahedron standing on a tip, stretched upwards."""
        tip, ring = radius * height, 1 / math.sqrt(5)
        points = [(0, tip, 0), (0, -tip, 0)]
        for k in range(10):
            angle, y = math.pi * k / 5, tip * ring * (1 if k % 2 == 0 else -1)
            points.append((2 * ring * radius * math.cos(angle), y, 2 * ring * radius * math.sin(angle)))
        faces = [(k % 2, 2 + k, 2 + (k + 2) % 10) for k in range(10)]
        faces += [(2 + k, 2 + (k + 1) % 10, 2 + (k + 2) % 10) for k in range(10)]
        self.solid(material, [add(center, p) for p in points], faces)

    def panel(self, material, middle, across, half_width, half_height, facing):
        """An upright quad about `middle`, its width along `across`, seen from the side of `facing`."""
        a, up = scale(across, half_width), (0, half_height, 0)
        corners = [add(middle, add(scale(a, s), scale(up, t)))
                   for s, t in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
        seen = dot(cross(sub(corners[1], corners[0]), sub(corners[2], corners[0])), facing) > 0
        self.faces(material, corners, [(0, 1, 2, 3) if seen else (3, 2, 1, 0)])

    def light_triangles(self):
        return sum(len(s.triangles) for name, s in self.shapes.items() if name.startswith("emit_"))


def cord(parts, points):
    for a, b in zip(points, points[1:]):
        lift = (0, 0.012, 0)
        parts.faces("iron", [a, b, add(b, lift), add(a, lift)], [(0, 1, 2, 3)])


def string(parts, chance, start, end, sag, count, hang):
    """A cord between two points, with count lamps; hang(place, index) adds one below the cord."""
    def at(t):
        return add(add(scale(start, 1 - t), scale(end, t)), (0, -4 * sag * t * (1 - t), 0))

    cord(parts, [at(i / (2 * count)) for i in range(2 * count + 1)])
    turn = chance.below(len(BULBS))
    for i in range(count):
        hang(at((i + 0.5) / count), turn + i)


def bulbs(parts, chance, start, end, count, sag=0.35, radius=0.065):
    def hang(place, i):
        parts.ball8("emit_" + BULBS[i % len(BULBS)], add(place, (0, -radius - 0.02, 0)),
                    radius * chance.between(0.7, 1.2))
    string(parts, chance, start, end, sag, count, hang)


def lantern(parts, color, place, radius):
    parts.ball20("emit_paper_" + color, place, radius, 1.2)
    parts.post("iron", place[0], place[2], place[1] + 1.15 * radius, place[1] + 1.4 * radius, 0.3 * radius)


def lantern_post(parts, chance, x, z, height, radius):
    parts.post("iron", x, z, 0, height, 0.04)
    parts.post("stone", x, z, 0, 0.25, 0.14)
    parts.box("iron", (x - 0.3, height - 0.04, z - 0.02), (x + 0.04, height, z + 0.02))
    lantern(parts, chance.of(("red", "amber", "rose", "blue")), (x - 0.3, height - 1.5 * radius, z), radius)


def stall(parts, chance, side, z, cloth, lamps):
    """A table of goods under a striped canopy; side -1 or 1 says at which edge of the lane it stands."""
    back, front = side * 2.45, side * 1.5
    low, high = min(back, front), max(back, front)
    parts.box(cloth, (low + 0.04, 0.0, z - 1.06), (high - 0.04, 0.8, z + 1.06))
    parts.box("wood", (low, 0.8, z - 1.1), (high, 0.86, z + 1.1))
    for x in (back, front):
        for dz in (-1.12, 1.12):
            parts.post("wood", x, z + dz, 0, 2.5 if x == back else 2.2)
    for i in range(6):
        material = cloth if i % 2 == 0 else "cream"
        z0, z1 = z - 1.2 + 0.4 * i, z - 0.8 + 0.4 * i
        front_edge, back_edge = (side * 1.2, 2.12), (side * 2.65, 2.62)
        roof = [front_edge + (z0,), front_edge + (z1,), back_edge + (z1,), back_edge + (z0,)]
        parts.slab(material, roof, [add(p, (0, 0.03, 0)) for p in roof])
        parts.faces(material, [roof[0], roof[1], add(roof[1], (0, -0.17, 0)), add(roof[0], (0, -0.17, 0))],
                    [(0, 1, 2, 3)])
    for i in range(3):
        kind, zc = chance.of(FRUIT), z - 0.7 + 0.7 * i
        parts.box("wood", (low + 0.12, 0.86, zc - 0.28), (high - 0.12, 0.98, zc + 0.28))
        for k in range(6):
            parts.ball8(kind, (low + 0.3 + 0.18 * (k % 3), 1.07, zc - 0.13 + 0.26 * (k // 3)), 0.105)
    for i in range(lamps):
        parts.ball8("emit_warm_" + chance.of(("dim", "mid", "mid", "bright")),
                    (side * 1.85, 1.95, z + 0.6 * (2 * i - 1)), chance.between(0.045, 0.07))


def street(kind):
    """A paved lane along z, between stalls and lanterns."""
    parts, chance = Parts(), Chance(10 + kind)
    parts.box("paving", (-1.25, 0, -3), (1.25, 0.02, 3))
    clothes = ("red_cloth", "blue_cloth", "green_cloth", "ochre_cloth")
    if kind == 0:  # two stalls face each other
        stall(parts, chance, -1, -0.9, clothes[0], 2)
        stall(parts, chance, 1, -0.7, clothes[1], 2)
        bulbs(parts, chance, (-2.7, 3.6, -2.5), (2.7, 3.8, -2.3), 6)
        lantern_post(parts, chance, 1.8, -2.45, 2.5, 0.2)
    elif kind == 1:  # three stalls
        stall(parts, chance, -1, -1.4, clothes[2], 2)
        stall(parts, chance, -1, 1.4, clothes[3], 2)
        stall(parts, chance, 1, 1.1, clothes[0], 2)
        bulbs(parts, chance, (-2.6, 3.5, -0.2), (2.6, 3.9, 0.2), 4)
        lantern_post(parts, chance, 2.0, -1.7, 2.9, 0.2)
    elif kind == 2:  # two strings of bulbs over benches
        bulbs(parts, chance, (-2.7, 3.6, -1.5), (2.7, 3.9, -1.7), 5, 0.5)
        bulbs(parts, chance, (-2.7, 3.9, 1.5), (2.7, 3.5, 1.3), 5, 0.5)
        lantern_post(parts, chance, -1.75, 0.2, 2.6, 0.19)
        for x in (-2.2, 2.2):
            parts.box("wood", (x - 0.2, 0.4, -2.2), (x + 0.2, 0.46, -0.7))
            parts.box("stone", (x - 0.15, 0, -2.0), (x + 0.15, 0.4, -1.85))
            parts.box("stone", (x - 0.15, 0, -1.05), (x + 0.15, 0.4, -0.9))
            parts.box("stone", (x - 0.4, 0, 1.0), (x + 0.4, 0.5, 1.8))
            parts.ball20("leaves", (x, 0.95, 1.4), 0.45, 1.2)
    else:  # paper lanterns on a string
        def hang(place, i):
            lantern(parts, ("red", "amber", "rose", "blue", "amber")[i % 5], add(place, (0, -0.3, 0)),
                    chance.between(0.16, 0.24))
        string(parts, chance, (-2.6, 3.9, 0.5), (2.6, 3.9, -0.5), 0.5, 5, hang)
        stall(parts, chance, 1, 0.4, clothes[3], 0)
    return parts


def house(kind):
    """Lit windows on four sides under a hipped roof, bulbs along the eaves."""
    parts, chance = Parts(), Chance(40 + kind)
    half, eaves = 2.0, 2.9
    plaster = "plaster_%d" % kind
    parts.box(plaster, (-half, 0, -half), (half, eaves, half))
    parts.box("stone", (-half - 0.06, 0, -half - 0.06), (half + 0.06, 0.35, half + 0.06))
    roof = [(s * 2.35, eaves, t * 2.35) for s, t in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    parts.solid("roof", roof + [(0, LAMP_TOP, -0.8), (0, LAMP_TOP, 0.8)],
                [(0, 1, 2, 3), (0, 1, 4), (2, 3, 5), (1, 2, 5, 4), (3, 0, 4, 5)])
    lit = 0
    for side in range(4):
        out = ((0, 0, 1), (1, 0, 0), (0, 0, -1), (-1, 0, 0))[side]
        across = (out[2], 0, out[0])
        for column in (-1.2, 0, 1.2):
            middle = add(scale(out, half), add(scale(across, column), (0, 1.65, 0)))
            if column == 0 and side % 2 == 0:
                door = add(middle, add(scale(out, 0.012), (0, -0.6, 0)))
                parts.panel("wood", door, across, 0.45, 1.05, out)
                continue
            lit += 1
            parts.panel("wood", add(middle, scale(out, 0.01)), across, 0.4, 0.6, out)
            parts.panel("emit_window_" + chance.of(("warm", "warm", "cool", "dim")),
                        add(middle, scale(out, 0.02)), across, 0.33, 0.53, out)
            parts.panel("wood", add(middle, scale(out, 0.03)), across, 0.02, 0.53, out)
            parts.panel("wood", add(middle, add(scale(out, 0.031), (0, 0.15, 0))), across, 0.33, 0.018, out)
    assert lit == 10
    for z in (-2.5, 2.5):
        bulbs(parts, chance, (-2.4, 2.85, z), (2.4, 2.85, z), 5, 0.12, 0.06)
    return parts


def lit_tree():
    """A cone of leaves with twelve bulbs and a star."""
    parts, chance = Parts(), Chance(70)
    parts.post("wood", 0, 0, 0, 0.7, 0.12)
    for tier in range(3):
        low, high, wide = 0.5 + 0.9 * tier, 2.0 + 0.85 * tier, 1.25 - 0.33 * tier
        ring = [(wide * math.cos(math.pi * k / 4), low, wide * math.sin(math.pi * k / 4)) for k in range(8)]
        sides = [(k, (k + 1) % 8, 8) for k in range(8)]
        parts.solid("leaves", ring + [(0, high, 0)], [tuple(range(8))] + sides)
        for k in range(4):
            angle = math.pi * (2 * k + tier) / 4 + 0.2
            place = (1.03 * wide * math.cos(angle), low + 0.05, 1.03 * wide * math.sin(angle))
            parts.ball8("emit_" + BULBS[(3 * k + tier) % len(BULBS)], place, chance.between(0.05, 0.085))
    star = [add((0, 3.83, 0), scale(p, 0.1)) for p in ((1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1))]
    parts.solid("emit_warm_bright", star, [(0, 1, 2), (0, 1, 3), (0, 2, 3), (1, 2, 3)])
    parts.box("stone", (-1.5, 0, -1.5), (1.5, 0.12, 1.5))
    return parts


def grove():
    """Five paper lanterns on posts of different height around a stone."""
    parts, chance = Parts(), Chance(80)
    parts.box("stone", (-0.6, 0, -0.6), (0.6, 0.45, 0.6))
    parts.ball20("brass", (0, 0.95, 0), 0.55)
    for k in range(5):
        angle = 2 * math.pi * k / 5 + 0.3
        x, z = 2.0 * math.cos(angle), 2.0 * math.sin(angle)
        lantern_post(parts, chance, x, z, 1.5 + 0.45 * k, 0.28 - 0.03 * k)
    return parts


def kits():
    """Every kind of square by name; each has LIGHTS_PER_CELL emissive triangles."""
    made = {"street %d" % k: street(k) for k in range(4)}
    made.update({"house %d" % k: house(k) for k in range(3)})
    made.update({"tree": lit_tree(), "grove": grove()})
    for name, parts in made.items():
        assert parts.light_triangles() == LIGHTS_PER_CELL, (name, parts.light_triangles())
        for shape in parts.shapes.values():
            assert all(max(abs(x), abs(z)) <= 3 and y <= LAMP_TOP for x, y, z in shape.positions), name
    return made
