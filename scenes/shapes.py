"""Triangle shapes for the scene generator: quads, boxes and spheres as lists of tuples, in metres, +Y up."""

import math


def sub(a, b):
    return tuple(x - y for x, y in zip(a, b))


def add(a, b):
    return tuple(x + y for x, y in zip(a, b))


def scale(a, s):
    return tuple(x * s for x in a)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    return scale(a, 1 / math.sqrt(dot(a, a)))


class Shape:
    """Vertices with normals (and perhaps texture coordinates); triangles counter-clockwise from the front."""

    def __init__(self):
        self.positions, self.normals, self.uvs, self.triangles = [], [], [], []

    def quad(self, corners, facing, uvs=None):
        """Corners in order around the quad; the front is the side on which the point `facing` lies."""
        corners, uvs = list(corners), list(uvs or [])
        normal = unit(cross(sub(corners[1], corners[0]), sub(corners[2], corners[0])))
        if dot(normal, sub(facing, corners[0])) < 0:
            corners, uvs, normal = corners[::-1], uvs[::-1], scale(normal, -1)
        first = len(self.positions)
        self.positions += corners
        self.normals += [normal] * 4
        self.uvs += uvs
        self.triangles += [(first, first + 1, first + 2), (first, first + 2, first + 3)]
        return self

    def prism(self, base, height):
        """An upright block over a convex base of four points, without its underside, seen from outside."""
        top = [add(p, (0, height, 0)) for p in base]
        middle = scale(add(add(base[0], base[1]), add(base[2], base[3])), 0.25)
        self.quad(top, add(middle, (0, 2 * height, 0)))
        for i in range(4):
            j = (i + 1) % 4
            edge = scale(add(base[i], base[j]), 0.5)
            outside = add(middle, scale(sub(edge, middle), 2))
            self.quad([base[i], base[j], top[j], top[i]], outside)
        return self

    def room(self, lower, upper, without=()):
        """The inside of a box; `without` names faces to leave out: -x +x -y +y -z +z."""
        (x0, y0, z0), (x1, y1, z1) = lower, upper
        faces = {"-x": [(x0, y0, z0), (x0, y1, z0), (x0, y1, z1), (x0, y0, z1)],
                 "+x": [(x1, y0, z0), (x1, y1, z0), (x1, y1, z1), (x1, y0, z1)],
                 "-y": [(x0, y0, z0), (x1, y0, z0), (x1, y0, z1), (x0, y0, z1)],
                 "+y": [(x0, y1, z0), (x1, y1, z0), (x1, y1, z1), (x0, y1, z1)],
                 "-z": [(x0, y0, z0), (x1, y0, z0), (x1, y1, z0), (x0, y1, z0)],
                 "+z": [(x0, y0, z1), (x1, y0, z1), (x1, y1, z1), (x0, y1, z1)]}
        middle = scale(add(lower, upper), 0.5)
        for name, corners in faces.items():
            if name not in without:
                self.quad(corners, middle)
        return self

    def frame(self, outer, inner, facing):
        """A plane with a hole: four trapezoids between two quads with matching corners (no T-junctions)."""
        for i in range(4):
            j = (i + 1) % 4
            self.quad([outer[i], outer[j], inner[j], inner[i]], facing)
        return self


def sphere(center, radius, subdivisions):
    """An icosahedron whose edges were halved `subdivisions` times and pushed out to the sphere; smooth."""
    golden = (1 + math.sqrt(5)) / 2
    points = [unit(p) for s in (-1, 1) for t in (-golden, golden)
              for p in ((0, s, t), (s, t, 0), (t, 0, s))]
    side = min(math.dist(points[0], p) for p in points[1:]) * 1.01
    triangles = [(a, b, c) for a in range(12) for b in range(a + 1, 12) for c in range(b + 1, 12)
                 if max(math.dist(points[a], points[b]), math.dist(points[b], points[c]),
                        math.dist(points[c], points[a])) < side]
    for _ in range(subdivisions):
        middles, finer = {}, []

        def middle(a, b):
            key = (min(a, b), max(a, b))
            if key not in middles:
                points.append(unit(add(points[a], points[b])))
                middles[key] = len(points) - 1
            return middles[key]

        for a, b, c in triangles:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            finer += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        triangles = finer
    shape = Shape()
    shape.normals = points
    shape.positions = [add(center, scale(p, radius)) for p in points]
    for a, b, c in triangles:
        outward = dot(cross(sub(points[b], points[a]), sub(points[c], points[a])), points[a]) > 0
        shape.triangles.append((a, b, c) if outward else (a, c, b))
    return shape


def lathe(profile, segments):
    """A surface of revolution about +Y, smooth: the profile is points (radius, height) from the bottom up."""
    shape = Shape()
    for k, (radius, height) in enumerate(profile):
        below, above = profile[max(k - 1, 0)], profile[min(k + 1, len(profile) - 1)]
        rise, spread = above[1] - below[1], above[0] - below[0]
        for s in range(segments):
            cosine, sine = math.cos(2 * math.pi * s / segments), math.sin(2 * math.pi * s / segments)
            shape.positions.append((radius * cosine, height, radius * sine))
            shape.normals.append(unit((rise * cosine, -spread, rise * sine)))
    for k in range(len(profile) - 1):
        for s in range(segments):
            a, b = k * segments + s, k * segments + (s + 1) % segments
            shape.triangles += [(a, a + segments, b + segments), (a, b + segments, b)]
    return shape
