"""Meshes as arrays of numpy, and what other packages call a mesh.

Arrays of a decoded mesh own the memory that the library decoded into; arrays that are given are read where
they lie, if they are of a type that the library has and rows of them are packed.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np

Array = Any  # whatever numpy makes an array of


@dataclass(eq=False)
class Attribute:
    """Named values of vertices, corners or faces.

    ``values``   shape (n,) or (n, components), of int8 .. int64, uint8 .. uint64, float32 or float64
    ``domain``   "vertex", "corner" or "face": what there is one value for
    ``indices``  None: element i has value i. Else which value each element has; 2**32 - 1: it has none
    """

    name: str
    values: np.ndarray
    domain: str = "vertex"
    indices: Optional[np.ndarray] = None

    def per_element(self) -> np.ndarray:
        """The value of each element, by index or not. ValueError where an element has none."""
        if self.indices is None:
            return self.values
        if (self.indices == NO_VALUE).any():
            raise ValueError(f"attribute '{self.name}' has no value for some elements")
        return self.values[self.indices]


NO_VALUE = 2**32 - 1


@dataclass(eq=False)
class Mesh:
    """Faces as cycles of vertex indices, counterclockwise seen from outside, and named values.

    ``corners``     the vertices of all faces, one face after the other: uint32 or uint16
    ``face_sizes``  corners of each face; None: all are triangles
    ``attributes``  in their order. Vertex attribute "position" has the places of vertices
    """

    vertex_count: int
    corners: np.ndarray
    face_sizes: Optional[np.ndarray] = None
    attributes: List[Attribute] = field(default_factory=list)
    name: str = ""
    metadata: Dict[str, bytes] = field(default_factory=dict)

    @property
    def face_count(self) -> int:
        return len(self.corners) // 3 if self.face_sizes is None else len(self.face_sizes)

    @property
    def faces(self) -> np.ndarray:
        """Shape (n, k), a view of the corners. ValueError if faces have different sizes: see face_list()."""
        if self.face_sizes is None:
            return self.corners.reshape(-1, 3)
        sizes = np.unique(self.face_sizes)
        if len(sizes) > 1 or (len(sizes) == 1 and sizes[0] == 0):
            raise ValueError(f"faces have {sizes.tolist()} corners: no rectangular array has them; use face_list()")
        return self.corners.reshape(-1, int(sizes[0]) if len(sizes) else 3)

    def face_list(self) -> List[np.ndarray]:
        """One array a face, views of the corners."""
        if self.face_sizes is None:
            return list(self.faces)
        return np.split(self.corners, np.cumsum(self.face_sizes, dtype=np.int64)[:-1]) if len(self.face_sizes) else []

    @property
    def vertices(self) -> np.ndarray:
        """The positions. KeyError if there are none."""
        return self["position"]

    def attribute(self, name: str, domain: Optional[str] = None) -> Attribute:
        """The first attribute of this name, and domain if one is given. KeyError if there is none."""
        for a in self.attributes:
            if a.name == name and domain in (None, a.domain):
                return a
        raise KeyError(name if domain is None else f"{domain} {name}")

    def __getitem__(self, name: str) -> np.ndarray:
        """The value that each element has of the first attribute of this name."""
        return self.attribute(name).per_element()

    def __contains__(self, name: str) -> bool:
        return any(a.name == name for a in self.attributes)


def packed_words(values: Array, what: str) -> np.ndarray:
    """Indices as uint32 or uint16: the same memory where these already are such, or int32. ValueError for what
    is no index."""
    array = np.asarray(values)
    if array.size == 0:
        return np.zeros(0, np.uint32)
    if array.dtype.kind not in "iu":
        raise ValueError(f"{what} of type {array.dtype}, expected integers")
    array = array.reshape(-1)
    if array.dtype == np.int32 and array.flags.c_contiguous:
        return array.view(np.uint32)  # a negative one is greater than any vertex, and refused so
    if array.dtype not in (np.uint32, np.uint16):
        if array.min() < 0 or array.max() > 0xFFFFFFFF:
            raise ValueError(f"{what} from {array.min()} to {array.max()}, expected 0 to {0xFFFFFFFF}")
        array = array.astype(np.uint32)
    return np.ascontiguousarray(array)


def rows(values: Array, what: str) -> np.ndarray:
    """Values as the library takes them: the same memory where rows are packed, at any stride."""
    array = np.asarray(values)
    if array.ndim not in (1, 2):
        raise ValueError(f"{what} have {array.ndim} dimensions, expected 1 or 2")
    if not array.dtype.isnative:
        array = array.astype(array.dtype.newbyteorder("="))
    width = array.dtype.itemsize if array.ndim == 1 else array.dtype.itemsize * array.shape[1]
    packed = array.ndim == 1 or array.shape[1] <= 1 or array.strides[1] == array.dtype.itemsize
    if len(array) > 1 and (not packed or array.strides[0] < width):
        array = np.ascontiguousarray(array)
    return array if len(array) > 1 else np.ascontiguousarray(array)


def corners_of(faces: Array) -> Tuple[np.ndarray, Optional[np.ndarray]]:
    """Faces given as (n, k), as a sequence of faces of any sizes, or as a pair (corners, sizes) of arrays."""
    if isinstance(faces, tuple) and len(faces) == 2 and all(np.ndim(part) == 1 for part in faces):
        return packed_words(faces[0], "corners"), words32(faces[1], "face sizes")
    if not isinstance(faces, np.ndarray):
        faces = list(faces)
        sizes = [len(face) for face in faces]
        if len(set(sizes)) > 1 or 0 in sizes:
            flat = [v for face in faces for v in face]
            return packed_words(flat, "faces"), np.array(sizes, np.uint32)
        faces = np.asarray(faces)
    if faces.size == 0 and (faces.ndim != 2 or len(faces) == 0):
        return np.zeros(0, np.uint32), None
    if faces.ndim != 2:
        raise ValueError(f"faces have {faces.ndim} dimensions, expected 2: (faces, corners)")
    corners = packed_words(faces, "faces")
    return corners, None if faces.shape[1] == 3 else np.full(len(faces), faces.shape[1], np.uint32)


def words32(values: Array, what: str) -> np.ndarray:
    """As packed_words, never of 16 bits."""
    return packed_words(values, what).astype(np.uint32, copy=False)


Attributes = Union[Mapping[str, Array], Sequence[Attribute]]


def _attribute(name: str, values: Array, vertices: int, corners: int, faces: int) -> Attribute:
    """The domain is the one that has so many elements. ValueError where two have."""
    array = rows(values, f"values of '{name}'")
    fit = [d for d, n in (("vertex", vertices), ("corner", corners), ("face", faces)) if n == len(array)]
    if not fit:
        raise ValueError(f"attribute '{name}' has {len(array)} values, and there are {vertices} vertices, "
                         f"{corners} corners and {faces} faces")
    if len(fit) > 1:
        raise ValueError(f"attribute '{name}' may be of each {' or '.join(fit)}: give clers.Attribute(.., domain=..)")
    return Attribute(name, array, fit[0])


def make_mesh(faces: Array, vertices: Optional[Array] = None, attributes: Optional[Attributes] = None, *,
              vertex_count: Optional[int] = None, name: str = "",
              metadata: Optional[Mapping[str, bytes]] = None) -> Mesh:
    """A mesh of arrays, which are not copied where they can be read as they are.

    ``faces``         (n, k) integers; or a sequence of faces of any sizes; or (corners, sizes)
    ``vertices``      (n, components) positions; None: connectivity alone
    ``attributes``    name -> values, of the domain that has so many elements; or a list of clers.Attribute
    ``vertex_count``  where no vertices are given; else one more than the greatest that is named
    """
    corners, sizes = corners_of(faces)
    all_attributes: List[Attribute] = []
    if vertices is not None:
        all_attributes.append(Attribute("position", rows(vertices, "vertices")))
        vertex_count = len(all_attributes[0].values)
    elif vertex_count is None:
        vertex_count = int(corners.max()) + 1 if len(corners) else 0
    mesh = Mesh(vertex_count, corners, sizes, all_attributes, name, dict(metadata or {}))
    if isinstance(attributes, Mapping):
        all_attributes += [_attribute(n, v, vertex_count, len(corners), mesh.face_count) for n, v in attributes.items()]
    else:
        all_attributes += list(attributes or [])
    return mesh


def as_mesh(given: Any) -> Mesh:
    """A clers.Mesh as it is; what has points and cells as meshio's meshes have, or vertices and faces as
    trimesh's. TypeError for anything else.

    Of trimesh: vertex_attributes, face_attributes, and uv and vertex colours of its visual where it has them.
    Of meshio: cells of two dimensions, point_data and cell_data; of other cells (lines, volumes) ValueError.
    """
    if isinstance(given, Mesh):
        return given
    if hasattr(given, "points") and hasattr(given, "cells"):
        return _from_meshio(given)
    if hasattr(given, "vertices") and hasattr(given, "faces"):
        return _from_trimesh(given)
    raise TypeError(f"{type(given).__name__} is no mesh: expected clers.Mesh, or an object with vertices and faces "
                    f"(as trimesh's) or points and cells (as meshio's)")


def _from_trimesh(given: Any) -> Mesh:
    mesh = make_mesh(np.asarray(given.faces), np.asarray(given.vertices))
    for domain in ("vertex", "face"):
        for name, values in (getattr(given, domain + "_attributes", None) or {}).items():
            mesh.attributes.append(Attribute(name, rows(values, f"values of '{name}'"), domain))
    visual: Any = getattr(given, "visual", None)
    kind = getattr(visual, "kind", None)
    if kind == "texture" and getattr(visual, "uv", None) is not None:
        mesh.attributes.append(Attribute("texcoord", rows(visual.uv, "texture coordinates")))
    elif kind in ("vertex", "face"):
        colors = getattr(visual, kind + "_colors")
        mesh.attributes.append(Attribute("color", rows(colors, "colours"), kind))
    return mesh


_FLAT = {"triangle": 3, "quad": 4, "polygon": None}


def _from_meshio(given: Any) -> Mesh:
    blocks: List[np.ndarray] = []
    for block in given.cells:
        kind, data = (block.type, block.data) if hasattr(block, "type") else block
        if kind.rstrip("0123456789") not in _FLAT or kind.startswith(("triangle", "quad")) and kind not in _FLAT:
            raise ValueError(f"cells of type {kind}, expected triangle, quad or polygon")
        blocks.append(np.asarray(data))
    if len(blocks) == 1:
        mesh = make_mesh(blocks[0], given.points)
    else:
        corners = np.concatenate([words32(b, "cells") for b in blocks]) if blocks else np.zeros(0, np.uint32)
        sizes = [np.full(len(b), b.shape[1], np.uint32) for b in blocks]
        uniform = all(b.shape[1] == 3 for b in blocks)
        mesh = make_mesh((corners, np.concatenate(sizes)) if blocks and not uniform else corners.reshape(-1, 3),
                         given.points)
    for name, values in (getattr(given, "point_data", None) or {}).items():
        mesh.attributes.append(Attribute(name, rows(values, f"values of '{name}'")))
    for name, parts in (getattr(given, "cell_data", None) or {}).items():
        values = parts[0] if len(parts) == 1 else np.concatenate([np.asarray(p) for p in parts])
        mesh.attributes.append(Attribute(name, rows(values, f"values of '{name}'"), "face"))
    return mesh


def to_native(mesh: Mesh) -> Tuple[Any, ...]:
    """The tuple that the C++ side takes."""
    attributes = [(a.name, a.domain, rows(a.values, f"values of '{a.name}'"),
                   None if a.indices is None else words32(a.indices, "indices")) for a in mesh.attributes]
    sizes = None if mesh.face_sizes is None else words32(mesh.face_sizes, "face sizes")
    return (mesh.vertex_count, packed_words(mesh.corners, "corners"), sizes, attributes, mesh.name,
            list(mesh.metadata.items()))


def from_native(given: Tuple[Any, ...]) -> Mesh:
    vertex_count, corners, sizes, attributes, name, metadata = given
    return Mesh(vertex_count, corners, sizes, [Attribute(n, v, d, i) for n, d, v, i in attributes], name,
                dict(metadata))
