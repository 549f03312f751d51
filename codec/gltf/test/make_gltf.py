#!/usr/bin/env python3
"""Makes random glTFs that have everything that glTF 2.0 has, and some things that it should not.
usage: make_gltf.py FOLDER COUNT [FIRST-SEED]          files 0.glb, 1.gltf ..
       make_gltf.py --mutate FOLDER COUNT [FIRST-SEED]  the same with some bytes or numbers changed

The same seed makes the same file.
"""

import base64
import json
import os
import random
import struct
import sys

CODES = {5120: "b", 5121: "B", 5122: "h", 5123: "H", 5125: "I", 5126: "f"}
SHAPES = {"SCALAR": (1, 1), "VEC2": (1, 2), "VEC3": (1, 3), "VEC4": (1, 4), "MAT2": (2, 2), "MAT3": (3, 3),
          "MAT4": (4, 4)}


class Raw(str):
    """A number whose text json.dumps would not write."""


class Maker:
    def __init__(self, seed, mutate=False):
        self.r = random.Random(seed)
        self.mutate = mutate
        self.form = self.r.choice(["glb", "glb", "gltf"])
        self.buffers = [bytearray()]
        if self.r.random() < 0.3:
            self.buffers.append(bytearray())
        self.views, self.accessors, self.images = [], [], []
        self.files = {}

    def chance(self, p):
        return self.r.random() < p

    # ---- Bytes

    def view(self, data, **more):
        b = self.r.randrange(len(self.buffers))
        buffer = self.buffers[b]
        while len(buffer) % 4:
            buffer.append(self.r.choice([0, 0, 0, 7]))
        if self.chance(0.1):
            buffer += bytes(self.r.randrange(256) for _ in range(4 * self.r.randrange(1, 9)))
        view = {"buffer": b, "byteOffset": len(buffer), "byteLength": len(data)}
        if len(buffer) == 0 and self.chance(0.5):
            del view["byteOffset"]
        view.update(more)
        buffer += data
        if self.chance(0.1):
            view["name"] = "view \u00e9"
        self.views.append(view)
        return len(self.views) - 1

    def packed(self, values, kind, shape):
        columns, rows = SHAPES[shape]
        code = "<%d%s" % (rows, CODES[kind])
        out = []
        for v in values:
            parts = []
            for c in range(columns):
                part = struct.pack(code, *v[c * rows:c * rows + rows])
                if columns > 1:
                    part += b"\0" * (-len(part) % 4)
                parts.append(part)
            x = b"".join(parts)
            out.append(x)
        return out

    def number(self, kind, smooth):
        r = self.r
        if kind == 5126:
            x = r.choice([smooth, round(smooth, 3), r.uniform(-1, 1)]) if not self.chance(0.002) else \
                r.choice([float("nan"), float("inf"), -0.0, 1e-40, 3e38])
            return x
        size = struct.calcsize(CODES[kind])
        low, high = (0, 2 ** (8 * size) - 1) if CODES[kind].isupper() else (-2 ** (8 * size - 1), 2 ** (8 * size - 1) - 1)
        return max(low, min(high, int(abs(smooth) * 100) if self.chance(0.9) else r.randint(low, high)))

    def values(self, count, kind, shape):
        columns, rows = SHAPES[shape]
        step = self.r.uniform(0.01, 1)
        if self.chance(0.1):
            same = tuple(self.number(kind, 1.5) for _ in range(columns * rows))
            return [same] * count
        values = [tuple(self.number(kind, step * (i + 3 * c)) for c in range(columns * rows)) for i in range(count)]
        if self.chance(0.3):  # some twice
            for _ in range(count // 4):
                values[self.r.randrange(count)] = values[self.r.randrange(count)]
        return values

    # ---- Accessors

    def describe(self, values, kind, shape, view, offset, **more):
        a = {}
        if view is not None:
            a["bufferView"] = view
            if offset or self.chance(0.5):
                a["byteOffset"] = offset
        a.update({"componentType": kind, "count": len(values), "type": shape})
        a.update(more)
        if kind != 5126 and shape != "SCALAR" and self.chance(0.3):
            a["normalized"] = self.chance(0.8)
        if values and self.chance(0.6) and all(x == x and abs(x) < 1e39 for v in values for x in v):
            columns = list(zip(*values))
            low, high = [min(c) for c in columns], [max(c) for c in columns]
            if kind == 5126:
                low, high = ([struct.unpack("<f", struct.pack("<f", x))[0] for x in side] for side in (low, high))
            style = self.r.randrange(5)
            if style == 0:
                low, high = ([Raw("%.7g" % x) for x in side] for side in (low, high))
            if style == 1:
                low[0] = low[0] + 1  # wrong
            if style == 2:
                low, high = ([int(x) if x == int(x) else x for x in side] for side in (low, high))
            a["min"], a["max"] = low, high
        if self.chance(0.1):
            a["name"] = "accessor"
        if self.chance(0.05):
            a["extras"] = {"why": [1, Raw("2.50"), Raw("1E+2"), None]}
        self.accessors.append(a)
        return len(self.accessors) - 1

    def accessor(self, values, kind, shape, **more):
        rows = self.packed(values, kind, shape)
        size = len(rows[0]) if rows else 4
        pad = self.r.choice([0, 0, 0, 4, 12]) + (-size % 4) if self.chance(0.3) else 0
        filling = bytes([self.r.choice([0, 0xAB])]) * pad
        data = b"".join(x + filling for x in rows)
        view = self.view(data, **({"byteStride": size + pad} if pad else {}))
        a = self.describe(values, kind, shape, view, 0, **more)
        if self.chance(0.15) and values:
            self.sparse(a, values, kind, shape)
        return a

    def sparse(self, accessor, values, kind, shape, without_base=None):
        a = self.accessors[accessor]
        count = a["count"]
        n = self.r.randint(1, max(1, count // 3))
        at = sorted(self.r.sample(range(count), min(n, count)))
        if self.chance(0.03):
            self.r.shuffle(at)
        code = 5121 if count <= 255 and self.chance(0.5) else self.r.choice([5123, 5125])
        indices = self.view(struct.pack("<%d%s" % (len(at), CODES[code]), *at))
        other = self.packed(self.values(len(at), kind, shape), kind, shape)
        a["sparse"] = {"count": len(at), "indices": {"bufferView": indices, "componentType": code},
                       "values": {"bufferView": self.view(b"".join(other))}}
        a.pop("min", None), a.pop("max", None)
        if without_base or (without_base is None and self.chance(0.4)):
            a.pop("bufferView", None), a.pop("byteOffset", None)

    def interleaved(self, columns):
        """Accessors of one view: columns of (values, kind, shape)."""
        packed = [self.packed(v, k, s) for v, k, s in columns]
        parts, offsets, at = [], [], 0
        for p in packed:
            at += -at % 4
            offsets.append(at)
            at += len(p[0])
        stride = at + -at % 4 + self.r.choice([0, 0, 4])
        data = bytearray(stride * len(columns[0][0]))
        for p, offset in zip(packed, offsets):
            for i, x in enumerate(p):
                data[i * stride + offset:i * stride + offset + len(x)] = x
        view = self.view(bytes(data), byteStride=stride, target=34962)
        return [self.describe(v, k, s, view, o) for (v, k, s), o in zip(columns, offsets)]

    # ---- Meshes

    def attributes(self, count):
        r = self.r
        wanted = [("POSITION", r.choice([5126, 5126, 5126, 5122]), "VEC3")]
        for name, kinds, shape in [("NORMAL", [5126, 5120], "VEC3"), ("TANGENT", [5126], "VEC4"),
                                   ("TEXCOORD_0", [5126, 5121, 5123], "VEC2"), ("TEXCOORD_1", [5123], "VEC2"),
                                   ("COLOR_0", [5121, 5126], r.choice(["VEC3", "VEC4"])),
                                   ("JOINTS_0", [5121, 5123], "VEC4"), ("WEIGHTS_0", [5126, 5121], "VEC4"),
                                   ("_FEATURE_ID_0", [5126, 5123, 5125], "SCALAR"), ("_M", [5121, 5126], r.choice(["MAT2", "MAT3"]))]:
            if self.chance(0.35):
                wanted.append((name, r.choice(kinds), shape))
        columns = [(self.values(count, k, s), k, s) for _, k, s in wanted]
        if self.chance(0.35):
            found = self.interleaved(columns)
        else:
            found = [self.accessor(v, k, s) for v, k, s in columns]
        return {name: a for (name, _, _), a in zip(wanted, found)}

    def triangles(self, count):
        r = self.r
        side = max(2, int(count ** 0.5))
        faces = []
        for i in range(count):
            if i % side + 1 < side and i + side + 1 < count:
                faces += [(i, i + 1, i + side), (i + 1, i + side + 1, i + side)]
        if not faces:
            faces = [tuple(r.randrange(count) for _ in range(3)) for _ in range(3)]
        if self.chance(0.3):
            faces += [tuple(r.randrange(count) for _ in range(3)) for _ in range(r.randrange(4))]
        if self.chance(0.2):
            faces.append((0, 0, count - 1))
            faces.append(faces[0])
        if self.chance(0.3):
            r.shuffle(faces)
        return [v for f in faces for v in f]

    def indices(self, indices, count):
        kinds = [k for k, top in ((5121, 255), (5123, 65535), (5125, 1 << 32)) if count <= top]
        if self.chance(0.02):
            indices = indices + [0]
        kind = self.r.choice(kinds)
        if self.chance(0.01):
            indices = indices[:-1] + [count]
        return self.accessor([(i,) for i in indices], kind, "SCALAR")

    def primitive(self, attributes, count, others):
        r = self.r
        p = {"attributes": dict(attributes)}
        mode = r.choice([4] * 12 + [0, 1, 2, 3, 5, 6])
        if self.chance(0.8) or count % 3:
            if others and self.chance(0.3):
                p["indices"] = r.choice(others)
            elif mode == 4:
                p["indices"] = self.indices(self.triangles(count), count)
            else:
                p["indices"] = self.indices([r.randrange(count) for _ in range(2 * r.randint(1, count))], count)
            others.append(p["indices"])
        if mode != 4 or self.chance(0.5):
            p["mode"] = mode
        if self.chance(0.4):
            p["material"] = 0
        if self.chance(0.05):
            p["extensions"] = {"ACME_unknown": {"vertices": [0, 1]}}
        if self.chance(0.05):
            p["extensions"] = {"CESIUM_primitive_outline": {"indices": self.indices([0, count - 1], count)}}
        if self.chance(0.1):
            p["extensions"] = {"EXT_mesh_features": {"featureIds": [{"featureCount": 4, "attribute": 0}]}}
        return p

    def targets(self, count, attributes):
        targets = []
        for _ in range(self.r.randint(1, 3)):
            target = {}
            for name in ("POSITION", "NORMAL"):
                if name in attributes and self.chance(0.8):
                    a = self.accessor(self.values(count, 5126, "VEC3"), 5126, "VEC3")
                    if self.chance(0.5) and "sparse" not in self.accessors[a]:
                        self.sparse(a, None, 5126, "VEC3")
                    target[name] = a
            targets.append(target)
        return targets

    def mesh(self, i):
        primitives, others = [], []
        count = self.r.choice([3, 4, 6, 9, 12, 30, 60, 300])
        attributes = self.attributes(count)
        for _ in range(self.r.choice([1, 1, 1, 2, 3])):
            if primitives and self.chance(0.4):
                count = self.r.choice([3, 6, 30, 99])
                attributes, others = self.attributes(count), []
            used = attributes
            if self.chance(0.2):
                used = {k: v for k, v in attributes.items() if k == "POSITION" or self.chance(0.5)}
            p = self.primitive(used, count, others)
            if self.chance(0.25):
                p["targets"] = self.targets(count, used)
            primitives.append(p)
        mesh = {"primitives": primitives}
        if self.chance(0.7):
            mesh["name"] = "mesh %d \u00fc" % i
        if self.chance(0.2):
            mesh["extras"] = {"targetNames": ["smile"], "n": Raw("-0.0"), "big": Raw("123456789012345678901234567890")}
        return mesh

    # ---- The rest of a scene

    def animation(self, nodes):
        samplers, channels = [], []
        times = [self.accessor([(0.1 * i,) for i in range(n)], 5126, "SCALAR") for n in (4, 7)]
        for _ in range(self.r.randint(1, 4)):
            path, shape = self.r.choice([("translation", "VEC3"), ("rotation", "VEC4"), ("scale", "VEC3"), ("weights", "SCALAR")])
            t = self.r.choice(times)
            way = self.r.choice(["LINEAR", "STEP", "CUBICSPLINE"])
            n = self.accessors[t]["count"] * (3 if way == "CUBICSPLINE" else 1) * (2 if path == "weights" else 1)
            samplers.append({"input": t, "interpolation": way, "output": self.accessor(self.values(n, 5126, shape), 5126, shape)})
            channels.append({"sampler": len(samplers) - 1, "target": {"node": self.r.randrange(nodes), "path": path}})
        return {"samplers": samplers, "channels": channels}

    def picture(self, i):
        data = bytes([0x89, 0x50]) + bytes(self.r.randrange(256) for _ in range(self.r.randrange(300)))
        way = self.r.choice(["view", "data", "file"])
        if way == "view":
            return {"bufferView": self.view(data), "mimeType": "image/png"}
        if way == "data":
            return {"uri": "data:image/png;base64," + base64.b64encode(data).decode()}
        name = "%s picture %d.png" % (self.name, i)
        self.files[name] = data
        return {"uri": name.replace(" ", "%20"), "name": "file"}

    def run(self, folder, name):
        r = self.r
        self.name = name
        meshes = [self.mesh(i) for i in range(r.randint(1, 3))]
        nodes = [{"name": "node %d" % i} for i in range(r.randint(1, 4))]
        for i, node in enumerate(nodes):
            if self.chance(0.7):
                node["mesh"] = r.randrange(len(meshes))
            if self.chance(0.3):
                node["translation"] = [Raw("1.50"), Raw("2e-3"), -4]
            if self.chance(0.1):
                node["extensions"] = {"EXT_mesh_gpu_instancing": {"attributes": {
                    "TRANSLATION": self.accessor(self.values(5, 5126, "VEC3"), 5126, "VEC3"),
                    "_ID": self.accessor(self.values(5, 5123, "SCALAR"), 5123, "SCALAR")}}}
        document = {"asset": {"version": "2.0", "generator": "make_gltf \"quoted\" \\ / \t \u20ac \U0001f600"}}
        document["scene"] = 0
        document["scenes"] = [{"nodes": list(range(len(nodes)))}]
        document["nodes"], document["meshes"] = nodes, meshes
        document["materials"] = [{"name": "red", "pbrMetallicRoughness": {"baseColorFactor": [1, 0, Raw("0.10"), 1]}}]
        if self.chance(0.4):
            document["animations"] = [self.animation(len(nodes)) for _ in range(r.randint(1, 2))]
        if self.chance(0.3):
            document["skins"] = [{"joints": [0], "inverseBindMatrices": self.accessor(self.values(1, 5126, "MAT4"), 5126, "MAT4")}]
        if self.chance(0.5):
            document["images"] = [self.picture(i) for i in range(r.randint(1, 3))]
        if self.chance(0.2):
            document["extensions"] = {"ACME_data": {"view": self.view(b"unknown bytes" * r.randrange(1, 5))}}
            document["extensionsUsed"] = ["ACME_data"]
        if self.chance(0.15) and len(self.accessors) > 1:  # the same values twice
            self.accessors.append(dict(r.choice(self.accessors)))
            meshes[0]["primitives"].append({"attributes": {"POSITION": len(self.accessors) - 1}, "mode": 0})
        if self.chance(0.1):  # values that reach into others
            for a in self.accessors[:]:
                if a["type"] == "VEC3" and a["count"] > 4 and "bufferView" in a and "sparse" not in a:
                    b = {k: v for k, v in a.items() if k not in ("min", "max")}
                    b["count"] = a["count"] - 2
                    self.accessors.append(b)
                    meshes[-1]["primitives"].append({"attributes": {"POSITION": len(self.accessors) - 1}, "mode": 0})
                    break
        if self.chance(0.1) and self.views:
            self.views[r.randrange(len(self.views))]["extensions"] = {"ACME_view": {}}
        document["accessors"], document["bufferViews"] = self.accessors, self.views
        return self.write(document, folder, name)

    def write(self, document, folder, name):
        document["buffers"] = []
        for i, data in enumerate(self.buffers):
            buffer = {"byteLength": len(data)}
            if self.form == "gltf" or i > 0:
                if self.chance(0.5):
                    buffer["uri"] = "data:application/octet-stream;base64," + base64.b64encode(data).decode()
                else:
                    buffer["uri"] = "%s_%d.bin" % (name, i)
                    self.files[buffer["uri"]] = bytes(data)
            document["buffers"].append(buffer)
        if self.mutate:
            mutate_numbers(document, random.Random(-self.r.random()))
        text = self.dumps(document)
        for file, data in self.files.items():
            with open(os.path.join(folder, file), "wb") as out:
                out.write(data)
        if self.form == "gltf":
            return text.encode()
        text = text.encode()
        text += b" " * (-len(text) % 4)
        chunks = [(0x4E4F534A, text), (0x004E4942, bytes(self.buffers[0]) + b"\0" * (-len(self.buffers[0]) % 4))]
        if self.chance(0.1):
            chunks.append((0x12345678, b"chunk of"))
        body = b"".join(struct.pack("<II", len(c), kind) + c for kind, c in chunks)
        return struct.pack("<4sII", b"glTF", 2, 12 + len(body)) + body

    def dumps(self, document):
        raws = []

        def marked(x):
            if isinstance(x, Raw):
                raws.append(str(x))
                return "\u0001%d\u0001" % (len(raws) - 1)
            if isinstance(x, dict):
                return {k: marked(v) for k, v in x.items()}
            if isinstance(x, (list, tuple)):
                return [marked(v) for v in x]
            return x

        text = json.dumps(marked(document), ensure_ascii=self.chance(0.5), indent=self.r.choice([None, 2]))
        for i, raw in enumerate(raws):
            text = text.replace('"\\u0001%d\\u0001"' % i, raw)
        return text


def mutate_numbers(document, r):
    """Other sizes, places, types and indices."""
    numbers = []

    def look(x):
        for key, value in (x.items() if isinstance(x, dict) else enumerate(x)):
            if isinstance(value, (dict, list)):
                look(value)
            elif isinstance(value, (int, float, str)):
                numbers.append((x, key))

    for key in ("accessors", "bufferViews", "buffers", "meshes", "animations", "skins", "images", "nodes"):
        look(document.get(key, []))
    for _ in range(r.choice([1, 1, 2, 4])):
        x, key = r.choice(numbers)
        n = x[key] if isinstance(x[key], int) else 7
        x[key] = r.choice([0, 1, n + 1, n - 1, 2 * n, n // 2, n + 4, -1, 255, 65535, 2 ** 31, 2 ** 32 - 1, 2 ** 53,
                           2 ** 64, 1.5, None, "SCALAR", "MAT4", [], {}, True, 5121, 5126])


def mutated(data, r):
    data = bytearray(data)
    for _ in range(r.choice([1, 1, 2, 5])):
        way = r.randrange(4)
        if way == 0:
            data[r.randrange(len(data))] = r.randrange(256)
        elif way == 1:  # a number of the JSON
            digits = [i for i, b in enumerate(data[:20000]) if 48 <= b <= 57]
            if digits:
                data[r.choice(digits)] = r.choice(b"0123456789")
        elif way == 2:
            del data[r.randrange(len(data)):]
            if len(data) < 20:
                data += b"{}" * 10
        else:
            at = r.randrange(len(data))
            data[at:at] = data[r.randrange(len(data)):][:r.randrange(9)]
    if data[:4] == b"glTF" and r.random() < 0.7:
        data[8:12] = struct.pack("<I", len(data))
    return bytes(data)


def main(arguments):
    mutate = "--mutate" in arguments
    arguments = [a for a in arguments if a != "--mutate"]
    folder, count = arguments[0], int(arguments[1])
    first = int(arguments[2]) if len(arguments) > 2 else 0
    os.makedirs(folder, exist_ok=True)
    for seed in range(first, first + count):
        numbers = mutate and seed % 3 > 0
        maker = Maker(seed, numbers)
        data = maker.run(folder, str(seed))
        if mutate and not numbers:
            data = mutated(data, random.Random(-seed - 1))
        with open(os.path.join(folder, "%d.%s" % (seed, maker.form)), "wb") as out:
            out.write(data)


if __name__ == "__main__":
    main(sys.argv[1:])
