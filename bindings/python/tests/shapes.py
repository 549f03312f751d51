"""Meshes for tests, and stand-ins of what other packages call a mesh."""

from types import SimpleNamespace

import numpy as np

import clers


def grid(n, m, dtype=np.float32):
    """A wavy rectangle of triangles: (faces, vertices)."""
    i = np.arange((n - 1) * (m - 1))
    a = i // (m - 1) * m + i % (m - 1)
    faces = np.stack([a, a + 1, a + m, a + m, a + 1, a + m + 1], 1).reshape(-1, 3).astype(np.uint32)
    y, x = np.divmod(np.arange(n * m), m)
    vertices = np.stack([x / m, y / m, np.sin(x / 7) * np.cos(y / 5) / 9], 1).astype(dtype)
    return faces, vertices


def trimesh_like(faces, vertices, **rest):
    return SimpleNamespace(faces=faces, vertices=vertices, **rest)


def meshio_like(points, cells, point_data=None, cell_data=None):
    blocks = [SimpleNamespace(type=kind, data=data) for kind, data in cells]
    return SimpleNamespace(points=points, cells=blocks, point_data=point_data or {}, cell_data=cell_data or {})


def same(a, b, **tolerance):
    result = clers.compare(a, b, tolerance=tolerance)
    assert result, result


def apply(order, mesh):
    """What decoding must give of a mesh without values by index: its arrays in the new order."""
    sizes = np.full(mesh.face_count, 3) if mesh.face_sizes is None else mesh.face_sizes
    begin = np.concatenate([[0], np.cumsum(sizes)]).astype(int)
    new = np.empty(mesh.vertex_count, int)
    new[order.vertices] = np.arange(mesh.vertex_count)
    corners = [begin[f] + (first + np.arange(sizes[f])) % max(sizes[f], 1)
               for f, first in zip(order.faces, order.first_corners)]
    corners = np.concatenate(corners).astype(int) if corners else np.zeros(0, int)
    by = {"vertex": order.vertices, "face": order.faces, "corner": corners}
    values = [clers.Attribute(a.name, a.values[by[a.domain]], a.domain) for a in mesh.attributes]
    return new[mesh.corners[corners]] if len(corners) else corners, sizes[order.faces], values
