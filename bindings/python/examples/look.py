#!/usr/bin/env python3
"""A mesh in pictures: its faces in the order of the codec, and what levels and bits cost.

usage: look.py MESH [PICTURE.png]
"""

import sys
import time

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import clers


def triangles_of(mesh):
    """Polygons as fans."""
    if mesh.face_sizes is None:
        return mesh.faces
    return np.array([[f[0], f[i], f[i + 1]] for f in mesh.face_list() for i in range(1, len(f) - 1)])


def draw_order(axes, mesh):
    """Faces from the first (dark) to the last (bright) as they are decoded."""
    faces, places = triangles_of(mesh), mesh.vertices.astype(float)
    corners = places[faces]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    length = np.linalg.norm(normals, axis=1)
    light = np.abs(normals @ [0.3, 0.4, 0.86]) / np.where(length == 0, 1, length)
    depth = corners[:, :, 2].mean(1)
    back_to_front = np.argsort(depth)
    colors = plt.cm.viridis(np.linspace(0, 1, len(faces)))
    colors[:, :3] *= (0.35 + 0.65 * light)[:, None]
    patches = matplotlib.collections.PolyCollection(corners[back_to_front][:, :, :2],
                                                    facecolors=colors[back_to_front], linewidths=0)
    axes.add_collection(patches)
    axes.autoscale()
    axes.set_aspect("equal")
    axes.axis("off")
    axes.set_title("faces in the order in which they are decoded")


def main(path, picture):
    mesh = clers.read(path)
    bare = clers.make_mesh((mesh.corners, mesh.face_sizes) if mesh.face_sizes is not None else mesh.faces, mesh.vertices)
    figure, (left, middle, right) = plt.subplots(1, 3, figsize=(15, 4.5), constrained_layout=True)
    draw_order(left, clers.decode(clers.encode(bare)))

    levels, sizes, seconds = range(1, 10), [], []
    for level in levels:
        start = time.process_time()
        sizes.append(8 * len(clers.encode(bare, level=level)) / bare.face_count)
        seconds.append(time.process_time() - start)
    middle.plot(seconds, sizes, "o-")
    for level, x, y in zip(levels, seconds, sizes):
        middle.annotate(str(level), (x, y), textcoords="offset points", xytext=(4, 4))
    middle.set(xscale="log", xlabel="seconds to encode", ylabel="bits a face", title="levels 1 to 9, without loss")

    depths = range(8, 19)
    data = [clers.encode(bare, precision={"position": bits}) for bits in depths]
    errors = [d.report[0].attributes[0].error for d in data]
    right.plot(errors, [8 * len(d) / bare.face_count for d in data], "o-")
    for bits, x, y in zip(depths, errors, data):
        right.annotate(str(bits), (x, 8 * len(y) / bare.face_count), textcoords="offset points", xytext=(4, 4))
    right.set(xscale="log", xlabel="largest error of a coordinate", ylabel="bits a face", title="bits of positions, level 5")
    figure.suptitle(f"{path.rsplit('/', 1)[-1]}: {bare.vertex_count} vertices, {bare.face_count} faces")
    figure.savefig(picture, dpi=90)


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2] if len(sys.argv) == 3 else "look.png")
