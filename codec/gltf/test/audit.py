#!/usr/bin/env python3
"""Compares two glTFs, of which the second came of the first by clers: is anything lost?
usage: audit.py [--error NAME=E]... [--views] BEFORE AFTER
       audit.py [--error NAME=E]... [--views] --folders BEFORE AFTER    each glTF of one folder with its namesake
  --error  values of attributes of this name may be off by E; vertices are in one order then
  --views  accessors may have other views

Shares no code with the reader that it audits: JSON and struct alone. All of the JSON must be the same token by
token, numbers by their text, but for buffers and for where things are in them; pictures and bytes that no
accessor names byte for byte; values that no primitive names in their order, bit for bit. Primitives that share
accessors must be the same up to one order of their vertices: these are matched by all their values together.
Triangles of a primitive are a multiset of such, each up to its first corner.
"""

import base64
import json
import os
import struct
import sys
from collections import Counter, defaultdict
from urllib.parse import unquote

CODES = {5120: "b", 5121: "B", 5122: "h", 5123: "H", 5124: "i", 5125: "I", 5126: "f", 5130: "d"}
SHAPES = {"SCALAR": (1, 1), "VEC2": (1, 2), "VEC3": (1, 3), "VEC4": (1, 4), "MAT2": (2, 2), "MAT3": (3, 3),
          "MAT4": (4, 4)}


class Different(Exception):
    pass


class Number(str):
    """A number of JSON by its text."""

    def __int__(self):
        return int(str(self)) if self.lstrip("-").isdigit() else int(float(self))


class Gltf:
    def __init__(self, path):
        self.folder = os.path.dirname(path)
        data = open(path, "rb").read()
        self.binary, self.chunks = None, []
        if data[:4] == b"glTF":
            at, text = 12, None
            while at < len(data):
                size, kind = struct.unpack_from("<II", data, at)
                chunk = data[at + 8:at + 8 + size]
                at += 8 + size
                if text is None:
                    text = chunk
                elif kind == 0x004E4942 and self.binary is None and not self.chunks:
                    self.binary = chunk
                else:
                    self.chunks.append((kind, chunk))
        else:
            text = data
        text = text.decode("utf-8-sig").rstrip("\0")
        self.json = json.loads(text, parse_float=Number, parse_int=Number,
                               object_pairs_hook=lambda pairs: pairs if len(dict(pairs)) < len(pairs) else dict(pairs))
        self.buffers = [self.buffer(i, b) for i, b in enumerate(self.json.get("buffers", []))]

    def load(self, uri):
        if uri.startswith("data:"):
            return base64.b64decode(uri.split(",", 1)[1])
        path = os.path.join(self.folder, unquote(uri))
        return open(path, "rb").read() if os.path.exists(path) else None

    def buffer(self, i, buffer):
        if "uri" in buffer:
            return self.load(buffer["uri"])
        return self.binary if i == 0 else None

    def view(self, i):
        """The bytes of a view; None if its buffer has none."""
        v = self.json["bufferViews"][i]
        data = self.buffers[int(v["buffer"])]
        at = int(v.get("byteOffset", 0))
        return None if data is None else data[at:at + int(v["byteLength"])]

    def elements(self, place, kind, shape, count, strided=True):
        """Values as bytes without padding; None if there are none."""
        if "bufferView" not in place:
            return None
        data = self.view(int(place["bufferView"]))
        if data is None:
            return None
        columns, rows = SHAPES[shape]
        code = CODES[kind]
        size = struct.calcsize("<" + code)
        column = rows * size if columns == 1 else (rows * size + 3) // 4 * 4
        whole = (columns - 1) * column + rows * size
        view = self.json["bufferViews"][int(place["bufferView"])]
        stride = int(view.get("byteStride", whole)) if strided else whole
        at = int(place.get("byteOffset", 0))
        return [b"".join(data[at + i * stride + c * column:at + i * stride + c * column + rows * size]
                         for c in range(columns)) for i in range(count)]

    def accessor(self, i):
        """(values without the sparse part, indices of that, its values)"""
        a = self.json["accessors"][i]
        kind, shape, count = int(a["componentType"]), a["type"], int(a["count"])
        base, at, to = self.elements(a, kind, shape, count), None, None
        if "sparse" in a:
            s = a["sparse"]
            n = int(s["count"])
            raw = self.elements(s["indices"], int(s["indices"]["componentType"]), "SCALAR", n, False)
            code = "<" + CODES[int(s["indices"]["componentType"])]
            at = None if raw is None else [struct.unpack(code, x)[0] for x in raw]
            to = self.elements(s["values"], kind, shape, n, False)
        return base, at, to

    def numbers(self, i):
        """Scalars of an accessor."""
        return [x[0] for x in values_of(self, i)]


def values_of(gltf, i):
    """All values with the sparse part in them, as tuples."""
    a = gltf.json["accessors"][i]
    columns, rows = SHAPES[a["type"]]
    n, code = columns * rows, CODES[int(a["componentType"])]
    base, at, to = gltf.accessor(i)
    all_values = base if base is not None else [b"\0" * (n * struct.calcsize("<" + code))] * int(a["count"])
    all_values = list(all_values)
    for k, v in zip(at or [], to or []):
        all_values[k] = v
    return [struct.unpack("<%d%s" % (n, code), x) for x in all_values]


def check(good, what):
    if not good:
        raise Different(what)


def close(a, b, code, error):
    if a == b:
        return True
    if not error:
        return False
    xs, ys = struct.unpack("<%d%s" % (len(a) // struct.calcsize("<" + code), code), a), \
        struct.unpack("<%d%s" % (len(b) // struct.calcsize("<" + code), code), b)
    return all(abs(x - y) <= error for x, y in zip(xs, ys))


def without(member, *keys):
    return {k: v for k, v in member.items() if k not in keys}


def same_json(a, b, path, free):
    """The same tokens, but for what may change."""
    if isinstance(a, dict) and isinstance(b, dict):
        for key in list(a) + [k for k in b if k not in a]:
            where = path + "." + key
            if path == "" and key == "buffers":
                check(len(a.get(key, [])) == len(b.get(key, [])), "buffers: another number")
                for x, y in zip(a[key], b[key]):
                    strip = [{k: v for k, v in z.items() if k not in ("uri", "byteLength")} for z in (x, y)]
                    same_json(strip[0], strip[1], where, free)
                continue
            if path.startswith(".bufferViews[") and key in ("buffer", "byteOffset", "byteLength"):
                continue
            if path.startswith(".accessors[") and key in ("byteOffset",) and path.count("[") == 1:
                continue
            if path.startswith(".images[") and key == "uri" and path.count("[") == 1:
                continue
            check(key in a and key in b, where + ": only in one")
            if path in free and key in ("min", "max"):
                continue  # compared with the values
            same_json(a[key], b[key], where, free)
        check(list(a) == list(b) or path == "", path + ": another order of members")
    elif isinstance(a, list) and isinstance(b, list):
        check(len(a) == len(b), path + ": another length")
        for i, (x, y) in enumerate(zip(a, b)):
            same_json(x, y, "%s[%d]" % (path, i), free)
    else:
        check(type(a) is type(b) and a == b, "%s: %r became %r" % (path, a, b))


def primitives(gltf):
    for m, mesh in enumerate(gltf.json.get("meshes", [])):
        for p, primitive in enumerate(mesh.get("primitives", [])):
            yield "meshes[%d].primitives[%d]" % (m, p), primitive


def vertex_accessors(primitive):
    found = [int(x) for x in primitive.get("attributes", {}).values()]
    for target in primitive.get("targets", []):
        found += [int(x) for x in target.values()]
    return found


def index_accessors(primitive):
    found = [int(primitive["indices"])] if "indices" in primitive else []
    outline = primitive.get("extensions", {}).get("CESIUM_primitive_outline", {})
    return found + ([int(outline["indices"])] if "indices" in outline else [])


def place_of(gltf, i):
    a = gltf.json["accessors"][i]
    return tuple(sorted((k, json.dumps(v)) for k, v in a.items()
                        if k in ("bufferView", "byteOffset", "componentType", "count", "type", "sparse")))


def groups(gltf, places):
    """Primitives that share accessors, directly or not; with `places`, also accessors of the same bytes: where
    views are made anew each accessor has its own, and primitives that name none in common may be renumbered apart."""
    parent = {}

    def find(x):
        while parent.setdefault(x, x) != x:
            x = parent[x]
        return x

    for where, p in primitives(gltf):
        for i in vertex_accessors(p) + index_accessors(p):
            shared = places and "bufferView" in gltf.json["accessors"][i]
            for key in [("a", i)] + ([place_of(gltf, i)] if shared else []):
                parent[find(key)] = find(where)
    result = defaultdict(list)
    for where, p in primitives(gltf):
        result[find(where)].append((where, p))
    return result.values()


def triangles_of(corners):
    result = Counter()
    for i in range(0, len(corners) - 2, 3):
        t = corners[i:i + 3]
        k = min(range(3), key=lambda r: (t[r:] + t[:r]))
        result[tuple(t[k:] + t[:k])] += 1
    return result


def compare_group(before, after, group, errors):
    vertices = sorted({i for _, p in group for i in vertex_accessors(p)})
    names = {}
    for _, p in group:
        for name, i in p.get("attributes", {}).items():
            names.setdefault(int(i), name)
    where = group[0][0]
    counts = {int(before.json["accessors"][i]["count"]) for i in vertices}
    found = [{i: g.accessor(i) for i in vertices} for g in (before, after)]
    if len(counts) != 1 or errors:
        for i in vertices:
            code, error = CODES[int(before.json["accessors"][i]["componentType"])], errors.get(names.get(i), 0)
            for x, y in zip(found[0][i], found[1][i]):
                if x is None or y is None or not error or isinstance(x[0] if x else 0, int):
                    check(x == y, "%s: values of accessor %d" % (where, i))
                else:
                    check(len(x) == len(y) and all(close(a, b, code, error) for a, b in zip(x, y)),
                          "%s: values of accessor %d are off by more than %g" % (where, i, error))
        classes = [list(range(max(counts, default=0)))] * 2
    else:
        classes, known = [], {}
        for values in found:
            keys = [[] for _ in range(next(iter(counts)))]
            for i in vertices:
                base, at, to = values[i]
                over = {} if at is None or to is None else dict(zip(at, to))
                ascends = [v[i][1] is None or v[i][1] == sorted(set(v[i][1])) for v in found]
                check(ascends[1] or not ascends[0], "sparse indices of accessor %d do not ascend" % i)
                for v, key in enumerate(keys):
                    key.append((base[v] if base is not None else None, over.get(v)))
            classes.append([known.setdefault(tuple(k), len(known)) for k in keys])
        check(Counter(classes[0]) == Counter(classes[1]), where + ": other vertices")
    for place, p in group:
        mode = int(p.get("mode", 4))
        corners = []
        for gltf, of in zip((before, after), classes):
            if "indices" in p:
                indices = gltf.numbers(int(p["indices"]))
                corners.append([of[v] if 0 <= v < len(of) else -1 - v for v in indices])
            else:
                corners.append(list(of))
        if corners[0] == corners[1]:
            pass
        elif mode == 4:
            check(triangles_of(corners[0]) == triangles_of(corners[1]), place + ": other triangles")
        elif mode == 0 and "indices" not in p:
            check(Counter(corners[0]) == Counter(corners[1]), place + ": other points")
        else:
            check(corners[0] == corners[1], place + ": other indices")
        for i in index_accessors(p)[1 if "indices" in p else 0:]:
            a, b = ([of[v] if 0 <= v < len(of) else -1 - v for v in g.numbers(i)]
                    for g, of in zip((before, after), classes))
            check(a == b, place + ": other indices of an extension")


def bounds_hold(gltf, i):
    a = gltf.json["accessors"][i]
    values = values_of(gltf, i)
    single = struct.Struct("<f")
    for key, worst in (("min", min), ("max", max)):
        for c, said in enumerate(a.get(key, [])):
            said = float(said)
            if int(a["componentType"]) == 5126:
                said = single.unpack(single.pack(said))[0]
            real = worst(v[c] for v in values) if values else said
            if (real < said) if key == "min" else (real > said):
                return False
    return True


def audit(before_path, after_path, errors, views):
    before, after = Gltf(before_path), Gltf(after_path)
    # Bounds of indices follow the numbers of vertices, and all do where values may be off.
    free = {i for _, p in primitives(before) for i in index_accessors(p)}
    if errors:
        free = set(range(len(before.json.get("accessors", []))))
    if views:
        for gltf in (before, after):
            gltf.all = gltf.json
            gltf.json = without(gltf.json, "bufferViews")
            if "accessors" in gltf.json:
                gltf.json["accessors"] = [without(a, "bufferView", "byteOffset") for a in gltf.json["accessors"]]
    same_json(before.json, after.json, "", {".accessors[%d]" % i for i in free})
    if views:
        for gltf in (before, after):
            gltf.json = gltf.all
    for i in free:
        a = before.json["accessors"][i]
        if "min" in a or "max" in a:
            check(not bounds_hold(before, i) or bounds_hold(after, i), "bounds of accessor %d" % i)
    check(before.chunks == after.chunks, "chunks of a .glb")
    named = set()
    for group in groups(before, not views):
        compare_group(before, after, group, errors)
        for _, p in group:
            named.update(vertex_accessors(p) + index_accessors(p))
    for i in range(len(before.json.get("accessors", []))):
        if i not in named:
            check(before.accessor(i) == after.accessor(i), "values of accessor %d" % i)
    used = set()
    for a in before.json.get("accessors", []):
        for place in [a] + [a["sparse"][k] for k in ("indices", "values") if "sparse" in a]:
            if "bufferView" in place:
                used.add(int(place["bufferView"]))
    for i in range(len(before.json.get("bufferViews", []))):
        if i not in used:
            check(before.view(i) == after.view(i), "bytes of bufferViews[%d]" % i)
    for i, image in enumerate(before.json.get("images", [])):
        if "uri" in image:
            check(before.load(image["uri"]) == after.load(after.json["images"][i]["uri"]), "images[%d]" % i)
    return len(before.json.get("accessors", []))


def main(arguments):
    errors, folders, views, paths = {}, False, False, []
    while arguments:
        a = arguments.pop(0)
        if a == "--error":
            name, _, value = arguments.pop(0).partition("=")
            errors[name] = float(value)
        elif a == "--views":
            views = True
        elif a == "--folders":
            folders = True
        else:
            paths.append(a)
    if len(paths) != 2:
        print(__doc__.split("\n\n")[0], file=sys.stderr)
        return 2
    pairs = [tuple(paths)]
    if folders:
        names = sorted(n for n in os.listdir(paths[0]) if n.endswith((".glb", ".gltf")))
        pairs = [tuple(os.path.join(p, n) for p in paths) for n in names]
    bad = 0
    for before, after in pairs:
        try:
            audit(before, after, errors, views)
        except (Different, OSError) as why:
            print("%s: %s" % (after, why))
            bad += 1
    print("%d of %d are the same" % (len(pairs) - bad, len(pairs)))
    return 1 if bad or not pairs else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
