#!/usr/bin/env python3
"""Runs compare and scaling on small meshes and checks what they write.

usage: compare_test.py COMPARE SCALING
"""
import json
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import time

KEYS = {"mesh", "class", "codec", "mode", "bytes", "position_bytes", "bits_per_triangle", "encode_mtri_s", "decode_mtri_s",
        "peak_bytes_per_triangle", "same_mesh"}
LEVELS = {"clers-1", "clers-3", "clers-5", "clers-7", "clers-9"}
DRACO = {"draco-cl5", "draco-cl7", "draco-cl10"}
MESHOPT = {"meshopt-N-vcache-zstd19", "meshopt-N-strip-zstd19"}
PACKED = {"zstd19", "xz9e", "least-rival"}
CODECS = {
    "connectivity": LEVELS - {"clers-7"} | MESHOPT | PACKED |
                    {"draco-standard", "draco-valence", "meshopt-N-vcache", "meshopt-N-strip"},
    "lossless": LEVELS | DRACO | MESHOPT | PACKED | {"openctm-mg1", "fpzip-zstd19"},
    "file": LEVELS | {"file-zstd19", "file-xz9e", "ply-zstd19", "ply-xz9e", "least-rival"}}
for mode in ("q11", "q14", "q16"):
    CODECS[mode] = LEVELS | DRACO | MESHOPT | PACKED | {"openctm-mg2"}


def without_release(codec):
    return re.sub(r"^meshopt-[0-9.]+-", "meshopt-N-", codec)


def run(*command):
    return subprocess.run([str(c) for c in command], check=True, text=True, capture_output=True).stdout


def torus(n):
    """OBJ of n x n squares, cut along either diagonal but for one."""
    random.seed(1)
    lines = [f"v {x} {y} {x * y % 7}" for y in range(n) for x in range(n)]
    for y in range(n):
        for x in range(n):
            a, b, c, d = (1 + (y + j) % n * n + (x + i) % n for i, j in ((0, 0), (1, 0), (1, 1), (0, 1)))
            if (x, y) == (0, 0):
                lines.append(f"f {a} {b} {c} {d}")
            elif random.random() < 0.5:
                lines += [f"f {a} {b} {c}", f"f {a} {c} {d}"]
            else:
                lines += [f"f {a} {b} {d}", f"f {b} {c} {d}"]
    return "\n".join(lines) + "\n"


def check(condition, what):
    if not condition:
        sys.exit(f"compare_test: {what}")


def main():
    compare, scaling = map(pathlib.Path, sys.argv[1:])
    with tempfile.TemporaryDirectory() as folder:
        at = pathlib.Path(folder)
        (at / "cad-torus.obj").write_text(torus(64) + "v 9 9 9\n")  # a vertex of no face, which is left out
        # Three triangles at an edge, and one that uses a vertex twice.
        (at / "nonmanifold-book.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 1 1\n"
                                                 "f 1 2 3\nf 1 2 4\nf 1 2 5\nf 1 1 2\n")
        # A torus with fins: its edges have three faces here and there.
        (at / "nonmanifold-fins.obj").write_text(torus(40) + "".join(f"v {k} 50 50\nf {k} {k + 1} {1600 + k}\n" for k in range(1, 39)))
        (at / "broken.obj").write_text("f 1 2 3\n")
        (at / "notes.txt").write_text("not a mesh")
        out = run(compare, "--repeats", "2", "--min-time", "0", "--json", at / "r.json", at)
        run(scaling, "--max", "3200", "--repeats", "1", "--json", at / "s.json")
        run(compare, "--from", at / "r.json", "--scaling", at / "s.json", "--html", at / "p.html")

        data = json.loads((at / "r.json").read_text())
        check({"machine", "compiler", "flags", "versions", "results"} <= set(data), "the JSON lacks a key")
        check(all(data["versions"].values()), "a version is empty")
        rows = data["results"]
        newer = {f"meshopt-{data['versions']['meshoptimizer-npm'].split(' ')[0]}-strip-zstd19"}
        for r in rows:
            check(KEYS <= set(r), f"a result lacks {KEYS - set(r)}")
            untimed = r["codec"] == "least-rival" or r["codec"] in newer
            check("failed" in r or r["bytes"] > 0 and (untimed or r["encode_mtri_s"] > 0 and r["decode_mtri_s"] > 0), f"no figures: {r}")
            check(not untimed or r["encode_mtri_s"] is None, f"a speed of nothing: {r}")
        for mode, codecs in CODECS.items():
            seen = {without_release(r["codec"]) for r in rows if r["mode"] == mode and r["mesh"] == "cad-torus"}
            check(codecs <= seen, f"{mode}: no rows of {codecs - seen}")
            check(all("debian" in c for c in seen - codecs), f"{mode}: unknown rows {seen - codecs}")
        for r in rows:
            if r["mesh"] == "cad-torus":
                check(r["class"] == "cad" and r["manifold"] and r["fanned"] and r["triangles"] == 8192 and r["vertices"] == 4096, f"misread: {r}")
                check(r["same_mesh"], f"another mesh comes back: {r}")
            elif r["codec"].startswith("clers"):
                check(r["same_mesh"] and not r["manifold"], f"clers loses something: {r}")
            if r["codec"] == "least-rival" and "failed" not in r:
                rivals = [o for o in rows if (o["mesh"], o["mode"]) == (r["mesh"], r["mode"]) and not o["codec"].startswith("clers") and "failed" not in o]
                exact = [o["bytes"] for o in rivals if o["triangles_lost"] + o["triangles_added"] + o["vertices_added"] + o["positions_off"] == 0]
                check(r["bytes"] == min(exact), f"not the least rival: {r}")
        for mode in ("q11", "q14", "q16", "lossless"):
            for codec in LEVELS | {"xz9e"}:
                r = next(r for r in rows if (r["mesh"], r["mode"], r["codec"]) == ("cad-torus", mode, codec))
                check(0 < r["position_bytes"] < r["bytes"], f"positions take nothing, or all: {r}")
        draco = [r for r in rows if r["mesh"] == "nonmanifold-book" and r["codec"] == "draco-valence"]
        check(not draco[0]["same_mesh"] and draco[0]["triangles_lost"] == 1, f"Draco's loss is not seen: {draco}")
        book = next(r for r in rows if r["mesh"] == "nonmanifold-book" and r["mode"] == "file" and r["codec"] == "file-zstd19")
        check(book["same_mesh"], f"a file is not the same after zstd: {book}")
        fins = {r["codec"]: r for r in rows if r["mesh"] == "nonmanifold-fins" and r["mode"] == "connectivity"}
        check(all(r["groups"] == ["not manifold"] for r in fins.values()), f"not in its group: {fins}")
        check(fins["draco-valence"]["vertices_added"] > 0, "Draco's doubled vertices are not seen")
        check(re.search(r"nonmanifold-fins +3238 ", out) and re.search(r"clers-5 +/ draco-cl10 ", out) and re.search(r"comes back +meshes +same", out),
              "meshes that are not manifold have no rows of their own")
        only = run(compare, "--group", "not manifold", "--modes", "connectivity", "--codecs", "clers-1,draco-valence", "--repeats", "1",
                   "--min-time", "0", at)
        check("nonmanifold-fins, " in only and "cad-torus, " not in only, "--group takes the wrong meshes")
        start = time.monotonic()
        run(compare, "--minutes", "0.001", "--modes", "q11", "--codecs", "clers-5,draco-cl10", "--json", at / "short.json", at)
        short = json.loads((at / "short.json").read_text())["results"]
        check(all(r["encode_samples"] == 1 for r in short if r["mesh"] == "cad-torus" and r["codec"] != "least-rival"),
              "samples are taken when the time is over")
        check(time.monotonic() - start < 60, "--minutes does not end the run")
        (at / "README.md").write_text("<!-- bench:begin --><!-- bench:end -->")
        run(pathlib.Path(__file__).parents[2] / "scripts" / "readme-table", at / "r.json", at / "README.md")
        check("1 meshes that are not manifold" in (at / "README.md").read_text(), "README's tables lack what is not manifold")
        check("meshoptimizer" in out and "connectivity: ratios to draco-valence" in out, "the tables are incomplete")

        points, fits = (json.loads((at / "s.json").read_text())[k] for k in ("points", "fits"))
        check(len({p["shape"] for p in points}) >= 27 and fits, "scaling lacks a shape")
        for p in points:
            costs = ["verify_ns", "verify_peak_bytes"] if p["codec"] == "verify" else ["encode_ns", "decode_ns", "encode_peak_bytes", "decode_peak_bytes"]
            if not p["codec"].startswith("draco"):
                check(all(p[c] and p[c] > 0 for c in costs), f"scaling lacks a cost: {p}")

        page = (at / "p.html").read_text()
        check("@RESULTS@" not in page and "@SCALING@" not in page, "the page has no data")
        check(not re.search(r"""(src|href)\s*=|@import|url\(|https?://(?!www\.w3\.org)""", page), "the page is not self-contained")

        failing = subprocess.run([compare, "--modes", "q12", at], text=True, capture_output=True)
        check(failing.returncode == 2 and "no such mode" in failing.stderr, "a wrong mode is taken")
        failing = subprocess.run([compare, at / "broken.obj"], text=True, capture_output=True)
        check(failing.returncode == 1 and "left out" in failing.stderr, "a broken mesh is not told")


main()
