#!/usr/bin/env python3
"""Do two binary PLY files have the same triangles, corner by corner bit for bit, in any order?
usage: same_triangles.py [--points] A.ply B.ply
A is of draco_decoder, which has all values by vertex; B of clers, which may have some by corner: lists of faces.
  --points  the same vertices, in the same order, as far as A has their values"""

import struct
import sys

TYPES = {"char": "b", "int8": "b", "uchar": "B", "uint8": "B", "short": "h", "int16": "h", "ushort": "H",
         "uint16": "H", "int": "i", "int32": "i", "uint": "I", "uint32": "I", "float": "f", "float32": "f",
         "double": "d", "float64": "d"}
# What draco_decoder calls them, and clers.
NAMES = {"texture_u": "s", "texture_v": "t", "u": "s", "v": "t"}
KEPT = ("x", "y", "z", "nx", "ny", "nz", "s", "t")


def read(path):
    """Rows of elements by name, each a dictionary of properties."""
    with open(path, "rb") as f:
        data = f.read()
    end = data.index(b"end_header\n") + 11
    elements = []
    for line in data[:end].decode().splitlines():
        words = line.split()
        if words[0] == "element":
            elements.append((words[1], int(words[2]), []))
        elif words[0] == "property":
            elements[-1][2].append(words[1:])
    rows, at = {}, end
    for name, count, properties in elements:
        rows[name] = []
        for _ in range(count):
            row = {}
            for p in properties:
                key = NAMES.get(p[-1], p[-1])
                if p[0] == "list":
                    n, = struct.unpack_from("<" + TYPES[p[1]], data, at)
                    at += struct.calcsize(TYPES[p[1]])
                    size = struct.calcsize(TYPES[p[2]])
                    row[key] = [data[at + k * size:at + (k + 1) * size] for k in range(n)]
                    if key in ("vertex_indices", "vertex_index"):
                        row["corners"] = [struct.unpack("<" + TYPES[p[2]], b)[0] for b in row[key]]
                    at += n * size
                else:
                    size = struct.calcsize(TYPES[p[0]])
                    row[key] = data[at:at + size]
                    at += size
            rows[name].append(row)
    return rows


def corner(rows, face, k):
    """All values of a corner, by name."""
    found = {key: value for key, value in rows["vertex"][face["corners"][k]].items() if key in KEPT}
    for name, keys in (("texcoord", ("s", "t")), ("normal", ("nx", "ny", "nz"))):
        if name in face:
            values = face[name]
            width = len(values) // 3
            found.update(zip(keys, values[k * width:(k + 1) * width]))
    return tuple(found.get(key, b"") for key in KEPT)


def triangles(rows):
    all_of_them = []
    for face in rows["face"]:
        t = [corner(rows, face, k) for k in range(3)]
        all_of_them.append(min(tuple(t[first:] + t[:first]) for first in range(3)))
    return sorted(all_of_them)


def main(arguments):
    points = arguments[:1] == ["--points"]
    a, b = (read(path) for path in arguments[points:])
    if points:
        kept = [key for key in KEPT if key in a["vertex"][0]]
        a, b = ([tuple(v.get(key, b"") for key in kept) for v in rows["vertex"]] for rows in (a, b))
    else:
        a, b = triangles(a), triangles(b)
    if not a or a != b:
        sys.exit(f"{len(a)} and {len(b)}, {sum(x != y for x, y in zip(a, b))} of them different")


main(sys.argv[1:])
