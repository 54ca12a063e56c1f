"""Writes small glTF 2.0 files (.gltf + .bin), PNG and Radiance HDR images with the standard library alone.

Every number is rounded before it is stored and images are not left to a compressor's taste, so the bytes
are the same on every machine. Formats: Khronos, "glTF 2.0 Specification"; "Portable Network Graphics" (RFC
2083); Ward 1991 (RGBE).
"""

import json
import math
import os
import struct
import zlib

FLOAT, UINT16 = 5126, 5123
VERTEX_TARGET, INDEX_TARGET = 34962, 34963


def rounded(values):
    return [round(float(v), 6) + 0.0 for v in values]  # + 0.0 turns -0.0 into 0.0


class Gltf:
    """One glTF asset under construction: add materials, meshes and nodes, then write()."""

    def __init__(self, name):
        self.name = name
        self.bytes = bytearray()
        self.extensions = set()
        self.images = {}  # file name -> bytes
        self.json = {"asset": {"version": "2.0", "generator": "scenes/generate.py", "copyright": "CC0"},
                     "scene": 0, "scenes": [{"name": name, "nodes": []}]}

    def _add(self, key, value):
        self.json.setdefault(key, []).append(value)
        return len(self.json[key]) - 1

    def _accessor(self, rows, kind, component, target, bounds=False):
        flat = [x for row in rows for x in row]
        code = "f" if component == FLOAT else "H"
        values = rounded(flat) if component == FLOAT else flat
        data = struct.pack("<%d%s" % (len(values), code), *values)
        view = self._add("bufferViews", {"buffer": 0, "byteOffset": len(self.bytes), "byteLength": len(data),
                                         "target": target})
        self.bytes += data + bytes(-len(data) % 4)
        count = len(values) // {"SCALAR": 1, "VEC2": 2, "VEC3": 3}[kind]
        accessor = {"bufferView": view, "componentType": component, "count": count, "type": kind}
        if bounds:
            # As stored: a bound is checked against the float32 in the buffer.
            stored = struct.unpack("<%df" % len(values), data)
            accessor["min"] = [min(stored[k::3]) for k in range(3)]
            accessor["max"] = [max(stored[k::3]) for k in range(3)]
        return self._add("accessors", accessor)

    def _use_extension(self, name):
        self.extensions.add(name)
        return name

    def material(self, name, color=(1, 1, 1), metallic=0.0, roughness=1.0, specular=None, emission=None,
                 **more):
        """emission is a radiance in W/(m^2 sr); specular 0 with roughness 1 is exactly Lambert's law."""
        pbr = {"baseColorFactor": rounded(list(color) + [1]), "metallicFactor": metallic,
               "roughnessFactor": roughness}
        pbr.update(more.pop("pbr", {}))
        material = {"name": name, "pbrMetallicRoughness": pbr}
        extensions = {}
        if specular is not None:
            extensions[self._use_extension("KHR_materials_specular")] = {"specularFactor": specular}
        if emission is not None:
            strength = max(emission)
            material["emissiveFactor"] = rounded([e / strength for e in emission])
            strength_extension = self._use_extension("KHR_materials_emissive_strength")
            extensions[strength_extension] = {"emissiveStrength": strength}
        if extensions:
            material["extensions"] = extensions
        material.update(more)
        return self._add("materials", material)

    def lambert(self, name, color, **more):
        return self.material("lambert_" + name, color, specular=0, **more)

    def emitter(self, name, radiance):
        return self.material("emit_" + name, (0, 0, 0), specular=0, emission=radiance)

    def texture(self, file_name, data, sampler=None):
        self.images[file_name] = data
        texture = {"source": self._add("images", {"uri": file_name})}
        if sampler:
            texture["sampler"] = self._add("samplers", sampler)
        return {"index": self._add("textures", texture)}

    def attributes(self, shape):
        """Stores a shape's vertices and indices; primitives may share them. Without normals it is flat."""
        accessors = {"POSITION": self._accessor(shape.positions, "VEC3", FLOAT, VERTEX_TARGET, bounds=True)}
        if shape.normals:
            accessors["NORMAL"] = self._accessor(shape.normals, "VEC3", FLOAT, VERTEX_TARGET)
        if shape.uvs:
            accessors["TEXCOORD_0"] = self._accessor(shape.uvs, "VEC2", FLOAT, VERTEX_TARGET)
        return {"attributes": accessors,
                "indices": self._accessor(shape.triangles, "SCALAR", UINT16, INDEX_TARGET)}

    def mesh(self, name, *parts, **more):
        """parts: pairs of (Shape or stored attributes, material)."""
        primitives = []
        for shape, material in parts:
            stored = shape if isinstance(shape, dict) else self.attributes(shape)
            primitives.append({**stored, "material": material})
        return self._add("meshes", {"name": name, "primitives": primitives, **more})

    def node(self, name, **content):
        index = self._add("nodes", {"name": name, **content})
        self.json["scenes"][0]["nodes"].append(index)
        return index

    def object(self, name, shape, material, **placement):
        return self.node(name, mesh=self.mesh(name, (shape, material)), **placement)

    def camera(self, eye, target, yfov_degrees, name="camera"):
        camera = self._add("cameras", {"name": name, "type": "perspective", "perspective": {
            "yfov": round(math.radians(yfov_degrees), 6), "znear": 0.01}})
        return self.node(name, camera=camera, matrix=look_at(eye, target))

    def light(self, name, kind, place, direction, color, intensity, **more):
        """KHR_lights_punctual; intensity in W/sr, of a directional light in W/m^2."""
        name_used = self._use_extension("KHR_lights_punctual")
        lights = self.json.setdefault("extensions", {}).setdefault(name_used, {"lights": []})["lights"]
        lights.append({"name": name, "type": kind, "color": rounded(color), "intensity": intensity, **more})
        toward = tuple(p + d for p, d in zip(place, direction))
        return self.node(name, matrix=look_at(place, toward),
                         extensions={name_used: {"light": len(lights) - 1}})

    def write(self, folder, readme):
        os.makedirs(folder, exist_ok=True)
        self.json["buffers"] = [{"uri": self.name + ".bin", "byteLength": len(self.bytes)}]
        if self.extensions:
            self.json["extensionsUsed"] = sorted(self.extensions)
        indent = 1 if len(self.json["nodes"]) < 500 else None  # small files are for reading, too
        text = json.dumps(self.json, indent=indent, sort_keys=True) + "\n"
        files = {self.name + ".gltf": text.encode(), self.name + ".bin": bytes(self.bytes),
                 "README.md": readme.encode(), **self.images}
        for file_name, data in files.items():
            with open(os.path.join(folder, file_name), "wb") as file:
                file.write(data)


def look_at(eye, target):
    """Column-major camera-to-world matrix: looks along its -Z with +Y up."""
    def unit(v):
        length = math.sqrt(sum(x * x for x in v))
        return [x / length for x in v]

    def cross(a, b):
        return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]

    z = unit([e - t for e, t in zip(eye, target)])
    x = unit(cross([0, 1, 0], z))
    y = cross(z, x)
    return rounded(x + [0] + y + [0] + z + [0] + list(eye) + [1])


def png(rows, channels):
    """An 8-bit PNG (3: RGB, 4: RGBA) of rows of bytes. Not compressed: the same bytes everywhere."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    raw = b"".join(b"\0" + bytes(row) for row in rows)
    blocks = [raw[i:i + 65535] for i in range(0, len(raw), 65535)]
    stream = b"\x78\x01"
    for i, block in enumerate(blocks):
        stream += struct.pack("<BHH", i == len(blocks) - 1, len(block), len(block) ^ 0xffff) + block
    stream += struct.pack(">I", zlib.adler32(raw))
    size = struct.pack(">IIBBBBB", len(rows[0]) // channels, len(rows), 8, {3: 2, 4: 6}[channels], 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", size) + chunk(b"IDAT", stream) + chunk(b"IEND", b"")


def rgbe(pixel):
    """Shared exponent: a channel is mantissa * 2^(exponent - 136)."""
    largest = max(pixel)
    if largest < 1e-32:
        return (0, 0, 0, 0)
    exponent = math.frexp(largest * 256 / 255.5)[1]  # the largest mantissa must round to 255 at most
    return tuple(int(c * 256.0 / 2.0 ** exponent + 0.5) for c in pixel) + (exponent + 128,)


def through_rgbe(pixel):
    """The colour that a reader of the file gets."""
    r, g, b, exponent = rgbe(pixel)
    return tuple(c * 2.0 ** (exponent - 136) for c in (r, g, b))


def hdr(rows):
    """A Radiance RGBE picture from rows of (r, g, b), in the run-length container with literal spans only."""
    width = len(rows[0])
    out = bytearray(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y %d +X %d\n" % (len(rows), width))
    for row in rows:
        encoded = [rgbe(pixel) for pixel in row]
        out += struct.pack(">BBH", 2, 2, width)
        for channel in range(4):
            for first in range(0, width, 128):
                span = bytes(e[channel] for e in encoded[first:first + 128])
                out += bytes([len(span)]) + span
    return bytes(out)
