"""Many lights: a night market of 100, 10,000 and 100,000 emissive triangles, open or divided by walls.

A scene function fills a Gltf; its docstring is the scene's README. The squares are in market_kit.py.
"""

from market_kit import CELL, Chance, LIGHTS_PER_CELL, Parts, kits
from shapes import scale

LAMBERT = {
    "wood": (0.22, 0.12, 0.06), "leaves": (0.05, 0.2, 0.06), "cream": (0.75, 0.7, 0.58),
    "red_cloth": (0.55, 0.06, 0.05), "blue_cloth": (0.06, 0.15, 0.5), "green_cloth": (0.05, 0.3, 0.15),
    "ochre_cloth": (0.65, 0.36, 0.05), "roof": (0.22, 0.09, 0.06), "wall": (0.5, 0.45, 0.38),
    "plaster_0": (0.6, 0.5, 0.4), "plaster_1": (0.5, 0.3, 0.24), "plaster_2": (0.4, 0.45, 0.5)}
GLOSSY = {  # base colour, roughness
    "ground": ((0.3, 0.28, 0.25), 0.45), "paving": ((0.2, 0.2, 0.21), 0.22),
    "stone": ((0.35, 0.33, 0.3), 0.6), "iron": ((0.03, 0.03, 0.035), 0.4), "orange": ((0.8, 0.3, 0.03), 0.4),
    "lime": ((0.35, 0.6, 0.05), 0.4), "plum": ((0.3, 0.04, 0.2), 0.4),
    "lemon": ((0.85, 0.7, 0.08), 0.4)}
RADIANCE = {  # of lamps, W/(m^2 sr)
    "red": (170, 12, 6), "amber": (130, 56, 8), "green": (16, 105, 20), "cyan": (12, 84, 96),
    "blue": (18, 34, 170), "violet": (92, 22, 145), "rose": (145, 32, 60), "gold": (240, 140, 34),
    "paper_red": (8, 0.5, 0.15), "paper_amber": (8, 2.6, 0.3), "paper_rose": (7, 0.7, 1.3),
    "paper_blue": (0.4, 1.1, 7), "warm_dim": (80, 50, 24), "warm_mid": (240, 150, 70),
    "warm_bright": (1800, 1170, 570), "window_warm": (2.2, 1.2, 0.42), "window_cool": (0.9, 1.15, 1.5),
    "window_dim": (0.6, 0.3, 0.1)}
HIDDEN_GAIN = 6  # of the lamps behind walls
WALL_HALF, WALL_TOP, GATE_HALF, GATE_TOP = 0.15, 4.4, 1.1, 2.7


def surfaces(gltf):
    made = {name: gltf.lambert(name, color) for name, color in LAMBERT.items()}
    made.update({name: gltf.material(name, color, roughness=roughness)
                 for name, (color, roughness) in GLOSSY.items()})
    made["brass"] = gltf.material("brass", (0.9, 0.7, 0.35), metallic=1, roughness=0.22)
    return made


class Market:
    """Squares on a grid; every fourth column is a street along z, and one of these is the camera's."""

    def __init__(self, gltf, columns, rows, walled):
        self.gltf, self.columns, self.rows = gltf, columns, rows
        self.street, self.home = columns // 8 * 4, max(rows - 2, 0)  # the camera's square
        self.materials, self.stored, self.lamps, self.meshes = surfaces(gltf), {}, {}, {}
        self.kits = kits()
        chance = Chance(1)
        for j in range(rows):
            for i in range(columns):
                self.place(i, j, chance, HIDDEN_GAIN if walled and i != self.street else 1)
        x, z = CELL * columns / 2 + 3, CELL * rows / 2 + 3
        ground = Parts()
        ground.faces("ground", [(-x, 0, -z), (-x, 0, z), (x, 0, z), (x, 0, -z)], [(0, 1, 2, 3)])
        if walled:
            self.walls(ground)
        for name, shape in ground.shapes.items():
            gltf.object(name, shape, self.materials[name])

    def middle(self, i, j):
        return (CELL * (i - (self.columns - 1) / 2), 0, CELL * (j - (self.rows - 1) / 2))

    def place(self, i, j, chance, gain):
        if i % 4 == 0:
            kind, turns = "street %d" % ((j - self.home) % 4), 0 if i == self.street else 2 * chance.below(2)
        else:
            kind = chance.of(("house 0", "house 1", "house 2") * 2 + ("tree", "grove"))
            turns = chance.below(4)
        half = (0.0, 0.70710678, 1.0, -0.70710678)[turns]
        placement = {"translation": self.middle(i, j)}
        if turns:
            placement["rotation"] = [0, half, 0, (1.0, 0.70710678, 0.0, 0.70710678)[turns]]
        self.gltf.node(kind, mesh=self.mesh(kind, gain), **placement)

    def mesh(self, kind, gain):
        if (kind, gain) not in self.meshes:
            parts = []
            for name, shape in self.kits[kind].shapes.items():
                if (kind, name) not in self.stored:
                    self.stored[kind, name] = self.gltf.attributes(shape)
                parts.append((self.stored[kind, name], self.material(name, gain)))
            self.meshes[kind, gain] = self.gltf.mesh(kind, *parts)
        return self.meshes[kind, gain]

    def material(self, name, gain):
        if not name.startswith("emit_"):
            return self.materials[name]
        lamp = name[len("emit_"):]
        if (lamp, gain) not in self.lamps:
            suffix = "" if gain == 1 else "_hidden"
            self.lamps[lamp, gain] = self.gltf.emitter(lamp + suffix, scale(RADIANCE[lamp], gain))
        return self.lamps[lamp, gain]

    def walls(self, parts):
        """Around every square; only the camera's street has gates, from square to square."""
        x, z = CELL * self.columns / 2, CELL * self.rows / 2
        street = self.middle(self.street, 0)[0]
        for i in range(self.columns + 1):
            at = CELL * i - x
            parts.box("wall", (at - WALL_HALF, 0, -z), (at + WALL_HALF, WALL_TOP, z))
        for j in range(self.rows + 1):
            lower, upper = CELL * j - z - WALL_HALF, CELL * j - z + WALL_HALF
            top = WALL_TOP - 0.01  # no coplanar tops where walls cross
            if j in (0, self.rows):
                parts.box("wall", (-x, 0, lower), (x, top, upper))
                continue
            parts.box("wall", (-x, 0, lower), (street - GATE_HALF, top, upper))
            parts.box("wall", (street + GATE_HALF, 0, lower), (x, top, upper))
            parts.box("wall", (street - GATE_HALF, GATE_TOP, lower), (street + GATE_HALF, top, upper))

    def look_along(self):
        """The camera at eye height in the second square of the street, looking along it."""
        x, _, z = self.middle(self.street, self.home)
        self.gltf.camera((x + 0.3, 1.7, z + 2.5), (x - 0.3, 1.75, z - 12), 50)


def many_lights_100(gltf):
    """# Many lights: one court

    One square of the night market of `many-lights-10000`, walled in under a black sky: two stalls face each
    other across a paved lane, under a string of bulbs and beside a paper lantern. Ten lamps of eight
    emissive triangles and one of twenty make 100 lights, and none is far.

    **Right answer:** the same mean whatever `--light-sampler` and `--light-rays` say; 100 lights in the
    report. Half of a lamp's triangles face away from any point: `uniform` and `power` waste these rays,
    `tree` knows better. `power` beats `uniform`, since distance matters little; one ray to every light is
    still practical.
    """
    Market(gltf, 1, 1, walled=True).look_along()


def many_lights_10000(gltf):
    """# Many lights: a night market

    A hundred squares of 6 m under a black sky: streets of stalls, houses with lit windows, strings of
    coloured bulbs, paper lanterns, a lit tree. Each square has 100 emissive triangles, so there are 10,000
    lights, some in every direction and at every height up to 4 m, whose powers differ by more than a hundred
    times. The camera stands in a street at eye height and looks along it over glossy paving. The lights
    near a point do nearly all of its lighting, with a hundredth of the market's power.

    **Right answer:** the same mean whatever `--light-sampler` says; 10,000 lights in the report. `uniform`
    and `power` spend nearly all shadow rays on lights that are tens of metres away and drown the street in
    noise; `tree` weighs distance and orientation and finds the near ones; `visibility` has little to add,
    since most near lights can be seen.
    """
    Market(gltf, 10, 10, walled=False).look_along()


def many_lights_walled_10000(gltf):
    """# Many lights behind walls

    The night market of `many-lights-10000`, every square walled in: walls of 0.3 m, higher than any lamp and
    any roof. Only the ten squares of the camera's street have gates from one to the next, so of the 10,000
    emissive triangles exactly 9,000 are hidden from every point that a path from the camera can reach. The
    hidden ones are also six times as bright as their like in the street, and many stand near a wall's other
    side.

    **Right answer:** the same mean whatever `--light-sampler` says; black lamps behind the walls change
    nothing. `uniform` and `power` hit walls with all but about one of a hundred shadow rays. `tree` chooses
    by distance, and most of what is near is hidden: lit by every lamp without walls, a point of the street
    would get several times as much. `visibility` learns which clusters of lamps a place sees and
    sends its rays there.
    """
    Market(gltf, 10, 10, walled=True).look_along()


def many_lights_100000(gltf):
    """# Many lights: a whole town of markets

    The night market of `many-lights-10000`, continued over 150 m by 240 m: a thousand squares, 100,000
    emissive triangles. What a point of the camera's street sees nearby is of the same kind, so that what
    ten times as many lights cost is what differs.

    **Right answer:** the same mean whatever `--light-sampler` says; 100,000 lights in the report. `uniform`
    and `power` are ten times as unlikely to find the near lights as they are with 10,000. `tree` goes a few
    levels deeper, and neither its noise nor its cost should grow by much.
    """
    Market(gltf, 25, 40, walled=False).look_along()


def many_lights_walled_100000(gltf):
    """# Many lights behind walls: a thousand squares

    The squares of `many-lights-100000`, each walled in as in `many-lights-walled-10000`. The camera's street
    has gates through its forty squares, so 96,000 of the 100,000 emissive triangles are hidden from every
    point that a path from the camera can reach, and they are six times as bright as their like in the street.

    **Right answer:** the same mean whatever `--light-sampler` says. What hides the nearest lights is what
    hides them in `many-lights-walled-10000`, so `tree` fares as it does there, and `visibility`, which
    learns about clusters of lights, must do so with clusters ten times as full.
    """
    Market(gltf, 25, 40, walled=True).look_along()
