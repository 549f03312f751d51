#!/usr/bin/env python3
"""Measures the levels on meshes, draws docs/levels.svg and prints the table of docs/levels.md.

usage: plot_levels.py PICTURE.svg MESH...    (with the Python package: scripts/test-python, then
       PYTHONPATH=build/python/bindings/python)

Triangles and positions alone; one thread; times are of the processor, the least of several runs.
"""

import os
import sys
import time

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams.update({"svg.hashsalt": "clers", "svg.fonttype": "none"})
import matplotlib.pyplot as plt
import matplotlib.ticker
import numpy as np

import clers

LEVELS = (1, 3, 5, 7, 9)  # those between are much alike
PRECISIONS = {"14 bits": 14, "lossless": None}


def least(work):
    """The least time of several runs, of one if that takes long; and what was made."""
    times = []
    while len(times) < 3 and sum(times) < 2:
        start = time.process_time()
        made = work()
        times.append(time.process_time() - start)
    return min(times), made


def measure(paths):
    """(precision, level) -> rows of bytes, encoding and decoding in ns, all a face."""
    rows = {(name, level): [] for name in PRECISIONS for level in LEVELS}
    for path in paths:
        mesh = clers.read(path)
        bare = clers.make_mesh(mesh.faces, mesh.vertices)
        for (name, level), row in rows.items():
            bits = PRECISIONS[name]
            precision = {} if bits is None else {"position": bits}
            encoding, data = least(lambda: clers.encode(bare, level=level, precision=precision))
            decoding, _ = least(lambda: clers.decode(data))
            row.append(np.array([len(data), 1e9 * encoding, 1e9 * decoding]) / bare.face_count)
        print(os.path.basename(path), file=sys.stderr)
    return {key: np.exp(np.log(row).mean(0)) for key, row in rows.items()}


def draw(means, picture):
    figure, axes = plt.subplots(1, 2, figsize=(10, 4.2), constrained_layout=True, sharey=True)
    for axis, column, title in zip(axes, (1, 2), ("encoding", "decoding")):
        for name in PRECISIONS:
            points = np.array([[1e3 / means[name, level][column], means[name, level][0]] for level in LEVELS])
            axis.plot(*points.T, "o-", label=name)
            for level, at in zip(LEVELS, points):
                axis.annotate(str(level), at, textcoords="offset points", xytext=(5, 5), fontsize=9)
        axis.set(xscale="log", xlabel=f"{title}, million triangles a second")
        axis.xaxis.set_major_formatter(matplotlib.ticker.FormatStrFormatter("%g"))
        axis.grid(alpha=0.3)
    axes[0].set(ylabel="bytes a triangle", ylim=(0, 1.15 * max(row[0] for row in means.values())))
    axes[0].legend(loc="lower left")
    figure.savefig(picture, metadata={"Date": None})


def table(means):
    print("| level | " + " | ".join(f"{name}: bytes | encode | decode" for name in PRECISIONS) + " |")
    print("|---|" + "---|---|---|" * len(PRECISIONS))
    for level in LEVELS:
        cells = []
        for name in PRECISIONS:
            size, encoding, decoding = means[name, level]
            cells += [f"{size:.2f}", f"{1e3 / encoding:.1f}", f"{1e3 / decoding:.1f}"]
        print(f"| {level} | " + " | ".join(cells) + " |")


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    found = measure(sys.argv[2:])
    draw(found, sys.argv[1])
    table(found)
