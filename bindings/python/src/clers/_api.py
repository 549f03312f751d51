"""Encoding, decoding, measuring, files."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any, Dict, Iterable, List, Mapping, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np

from . import _clers
from ._mesh import Array, Attributes, Attribute, Mesh, as_mesh, from_native, make_mesh, to_native
from ._options import Precisions, Progress, native_options

Limits = Mapping[str, int]


class Permutation(NamedTuple):
    """Where the elements of a decoded mesh were in the input.

    ``vertices[new]`` and ``faces[new]`` are old numbers; ``first_corners[new]`` is the corner of the old face
    that comes first now.
    """

    vertices: np.ndarray
    faces: np.ndarray
    first_corners: np.ndarray


class Warning(NamedTuple):
    """What encoding did as it was asked, though nobody may want it."""

    mesh: int
    attribute: str
    domain: str
    at: int
    what: str


class Encoded(bytes):
    """The bytes of a .clers file, and what encoding has to say of it.

    ``permutations``, ``report``, ``counts``: one for each mesh, in their order.
    """

    permutations: List[Permutation]
    report: List[_clers.MeshInfo]
    counts: List[_clers.CodingCounts]
    warnings: List[Warning]


def encode(mesh: Any, vertices: Optional[Array] = None, *, attributes: Optional[Attributes] = None,
           level: int = 5, order: str = "free", precision: Optional[Precisions] = None,
           piece_faces: Optional[int] = None, threads: int = 1, reject: Iterable[str] = (), name: str = "",
           metadata: Optional[Mapping[str, bytes]] = None, progress: Optional[Progress] = None) -> Encoded:
    """Encodes a mesh, or a list of meshes, into a .clers file, held in memory.

        data = clers.encode(faces, vertices)
        data = clers.encode(faces, vertices, attributes={"normal": normals}, precision={"position": 14})
        data = clers.encode(trimesh_or_meshio_mesh)
        data = clers.encode([first, second])

    ``mesh``         faces: an array (n, k), a list of faces of any sizes, or (corners, sizes); then ``vertices``,
                     ``attributes``, ``name`` and ``metadata`` are of it. Or a mesh: see clers.as_mesh. Or a list
                     of meshes
    ``vertices``     positions, shape (n, components)
    ``attributes``   name -> values, or a list of clers.Attribute
    ``level``        1 fastest .. 9 smallest
    ``order``        "free": vertices and faces come back in the codec's order, which ``permutations`` says; "keep":
                     as they were
    ``precision``    name, or (name, domain) -> clers.bits(14), .step(..), .error(..), .directions(..), ..; a number
                     is bits. What is not named comes back bit for bit
    ``piece_faces``  a mesh of more faces is coded in pieces of about so many, each of which decodes alone
    ``threads``      0: one a core. The bytes do not depend on it
    ``reject``       of "nonmanifold", "degenerate", "duplicate": what to refuse instead of keeping it
    ``progress``     called with a stage and a share, 0 to 1; what it raises ends the work

    Raises clers.Error for what the library refuses; TypeError and ValueError for arrays that are no mesh. Other
    threads of Python run meanwhile; arrays must not change. Cost: linear. Arrays are read where they lie, but for
    64-bit indices and rows that are not packed, which are copied.
    """
    meshes = _meshes_of(mesh, vertices, attributes, name, metadata)
    options = native_options(level=level, order=order, precision=precision, piece_faces=piece_faces,
                             threads=threads, reject=reject, progress=progress)
    data, permutations, report, counts, warnings = _clers.encode([to_native(m) for m in meshes], options)
    encoded = Encoded(data)
    encoded.permutations = [Permutation(*p) for p in permutations]
    encoded.report, encoded.counts = report, counts
    encoded.warnings = [Warning(*w) for w in warnings]
    return encoded


def _meshes_of(mesh: Any, vertices: Optional[Array], attributes: Optional[Attributes], name: str,
               metadata: Optional[Mapping[str, bytes]]) -> List[Mesh]:
    is_faces = vertices is not None or isinstance(mesh, np.ndarray) or (
        isinstance(mesh, (list, tuple)) and (not mesh or isinstance(mesh[0], (list, tuple, np.ndarray))))
    if is_faces:
        return [make_mesh(mesh, vertices, attributes, name=name, metadata=metadata)]
    if attributes is not None or name or metadata is not None:
        raise TypeError("attributes, name and metadata go with faces; a mesh has its own")
    return [as_mesh(m) for m in mesh] if isinstance(mesh, (list, tuple)) else [as_mesh(mesh)]


@dataclass(frozen=True, eq=False)
class Piece:
    """A part of a file that decodes alone: a piece of a mesh, or a mesh that is not in pieces.

    Vertex ``seam_vertices[i]`` of it is vertex ``seam_numbers[i]`` of the whole mesh; its others are numbered from
    ``first_vertex`` on in their order, its faces from ``first_face`` on.
    """

    mesh: Mesh
    mesh_index: int
    index: int
    count: int
    seam_vertices: np.ndarray
    seam_numbers: np.ndarray
    first_vertex: int
    first_face: int


class Decoder:
    """A .clers file whose headers were read and checked, decoded as a whole or in parts.

    ``data``      bytes, a memoryview, an mmap or an array: read where it lies, and must not change
    ``limits``    of "meshes", "vertices", "faces", "memory" (bytes): what exceeds one is refused with clers.Error
    ``threads``   0: one a core

    Trusts no byte. May be used by several threads at a time, if ``progress`` allows it.
    """

    def __init__(self, data: Any, *, limits: Optional[Limits] = None, threads: int = 1,
                 progress: Optional[Progress] = None) -> None:
        self._file = _clers.OpenFile(data, _checked(limits), threads, progress)

    @property
    def mesh_count(self) -> int:
        return self._file.mesh_count

    @property
    def piece_count(self) -> int:
        """Of all meshes; a mesh that is not in pieces is one."""
        return self._file.piece_count

    def info(self) -> _clers.FileInfo:
        """Sizes, attributes, names, metadata and what they cost: all that is known without decoding."""
        return self._file.info()

    def decode(self, mesh: Optional[int] = None) -> Union[Mesh, List[Mesh]]:
        """One mesh, or all of them."""
        if mesh is None:
            return [from_native(m) for m in self._file.decode_all()]
        return from_native(self._file.decode(mesh))

    def decode_piece(self, piece: int) -> Piece:
        """One piece, counted over all meshes, in the memory of it alone."""
        mesh, *rest = self._file.decode_piece(piece)
        return Piece(from_native(mesh), *rest)

    def decode_part(self, mesh: int = 0, *, faces: bool = True, attributes: Iterable[str] = ()) -> Mesh:
        """The faces of a mesh, some of its attributes, or both: the others are not decoded. Values by index come
        one for each element; where an element has none they are 0. KeyError for an attribute that is not there.
        """
        meshes = self.info().meshes
        if not 0 <= mesh < len(meshes):
            raise IndexError(f"mesh {mesh}, and the file has {len(meshes)}")
        info = meshes[mesh]
        count = {"vertex": info.vertices, "corner": info.corners, "face": info.faces}
        chosen: List[Attribute] = []
        for name in attributes:
            found = next((a for a in info.attributes if a.name == name), None)
            if found is None:
                raise KeyError(name)
            shape = (count[found.domain],) if found.components == 1 else (count[found.domain], found.components)
            chosen.append(Attribute(name, np.zeros(shape, found.dtype), found.domain))
        corners = np.zeros(info.corners if faces else 0, np.uint32)
        sizes = np.zeros(info.faces, np.uint32) if faces and not info.triangles_only else None
        self._file.decode_into(mesh, corners if faces else None, sizes, [(a.name, a.domain, a.values) for a in chosen])
        return Mesh(info.vertices, corners, sizes, chosen, info.name, info.metadata)


def decode(data: Any, *, limits: Optional[Limits] = None, threads: int = 1,
           progress: Optional[Progress] = None) -> Mesh:
    """Decodes a .clers file of one mesh. ValueError if it has none or several: see decode_all. Arguments and errors
    are those of clers.Decoder."""
    meshes = decode_all(data, limits=limits, threads=threads, progress=progress)
    if len(meshes) != 1:
        raise ValueError(f"the file has {len(meshes)} meshes: use decode_all")
    return meshes[0]


def decode_all(data: Any, *, limits: Optional[Limits] = None, threads: int = 1,
               progress: Optional[Progress] = None) -> List[Mesh]:
    """All meshes of a .clers file."""
    file = _clers.OpenFile(data, _checked(limits), threads, progress)
    return [from_native(m) for m in file.decode_all()]


def inspect(data: Any, *, limits: Optional[Limits] = None) -> _clers.Inspection:
    """Decodes the faces of all meshes of a .clers file, not their attributes, and measures them."""
    return _clers.inspect(data, _checked(limits))


def measure(mesh: Any) -> _clers.MeshShape:
    """Components, boundaries, genus and defects of a mesh."""
    return _clers.measure(to_native(as_mesh(mesh)))


class Comparison(NamedTuple):
    """``verdict``: "same", "different" or "undecided"; ``what``: the first difference, for people."""

    verdict: str
    what: str

    def __bool__(self) -> bool:
        return self.verdict == "same"


def compare(a: Any, b: Any, *, tolerance: Optional[Mapping[str, float]] = None) -> Comparison:
    """Are two meshes the same up to the order of vertices and faces and the corner a face starts with? Attributes
    that ``tolerance`` names may be so far apart, others not by a bit."""
    return Comparison(*_clers.compare(to_native(as_mesh(a)), to_native(as_mesh(b)), list((tolerance or {}).items())))


def _checked(limits: Optional[Limits]) -> Dict[str, int]:
    unknown = set(limits or {}) - {"meshes", "vertices", "faces", "memory"}
    if unknown:
        raise ValueError(f"no limits are called {sorted(unknown)}, expected meshes, vertices, faces or memory")
    return dict(limits or {})


@dataclass(frozen=True)
class Note:
    """What happened to one kind of thing in reading or writing. ``loss``: the result does not have it."""

    loss: bool
    count: int
    what: str
    text: str


def read(path: Union[str, "os.PathLike[str]"], *, notes: Optional[List[Note]] = None) -> Mesh:
    """Reads a mesh file by its ending: .clers, .ply, .obj, .off or .stl. What a reader left out or took in another
    form is appended to ``notes``. Raises OSError, clers.Error, ValueError for another ending."""
    ending = os.path.splitext(os.fspath(path))[1].lower()
    with open(path, "rb") as file:
        data = file.read()
    if ending == ".clers":
        return decode(data)
    return read_bytes(data, ending[1:], notes=notes)


def read_bytes(data: Any, format: str, *, notes: Optional[List[Note]] = None) -> Mesh:
    """A mesh file held in memory: "ply", "obj", "off" or "stl"."""
    meshes, found = _clers.read(data, format)
    if notes is not None:
        notes += [Note(*n) for n in found]
    return from_native(meshes[0])


def write(path: Union[str, "os.PathLike[str]"], mesh: Any, *, text: Optional[bool] = None,
          notes: Optional[List[Note]] = None, **options: Any) -> None:
    """Writes a mesh by the ending of the file; ``options`` are those of clers.encode, for .clers. The file is there
    as a whole or not at all."""
    ending = os.path.splitext(os.fspath(path))[1].lower()
    if ending == ".clers":
        data: bytes = encode(mesh, **options)
    elif options:
        raise TypeError(f"{sorted(options)} are for files that end in .clers")
    else:
        data = write_bytes(mesh, ending[1:], text=text, notes=notes)
    replace(path, data)


def write_bytes(mesh: Any, format: str, *, text: Optional[bool] = None,
                notes: Optional[List[Note]] = None) -> bytes:
    """A mesh, or for "obj" a list of them, as a file held in memory. ``text``: of ply and stl."""
    meshes: Sequence[Any] = mesh if isinstance(mesh, (list, tuple)) else [mesh]
    data, found = _clers.write([to_native(as_mesh(m)) for m in meshes], format, text)
    if notes is not None:
        notes += [Note(*n) for n in found]
    return data


def replace(path: Union[str, "os.PathLike[str]"], data: bytes) -> None:
    """Writes a file beside it and renames that: whoever looks sees the old one or the new one."""
    beside = f"{os.fspath(path)}.{os.getpid()}.part"
    try:
        with open(beside, "wb") as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        os.replace(beside, path)
    except BaseException:
        if os.path.exists(beside):
            os.remove(beside)
        raise
