"""clers compresses meshes: faces of any kind, positions, and all attributes by their names.

    import clers
    data = clers.encode(faces, vertices)            # bytes of a .clers file
    mesh = clers.decode(data)                       # mesh.faces, mesh.vertices, mesh["normal"]

Files: read, write. Parts of a file: Decoder. Many files, or one giant mesh, on many machines: clers.distributed.
"""

from ._api import (Comparison, Decoder, Encoded, Note, Permutation, Piece, Warning, compare, decode, decode_all,
                   encode, inspect, measure, read, read_bytes, write, write_bytes)
from ._clers import AttributeInfo, CodingCounts, FileInfo, InspectedMesh, Inspection, MeshInfo, MeshShape
from ._clers import version as __version__
from ._errors import Error
from ._mesh import NO_VALUE, Attribute, Mesh, as_mesh, make_mesh
from ._options import Precision, bits, directions, error, grid, lossless, recomputed, step

__all__ = [
    "Attribute", "AttributeInfo", "CodingCounts", "Comparison", "Decoder", "Encoded", "Error", "FileInfo",
    "InspectedMesh", "Inspection", "Mesh", "MeshInfo", "MeshShape", "NO_VALUE", "Note", "Permutation", "Piece",
    "Precision", "Warning", "as_mesh", "bits", "compare", "decode", "decode_all", "directions", "encode", "error",
    "grid", "inspect", "lossless", "make_mesh", "measure", "read", "read_bytes", "recomputed", "step", "write",
    "write_bytes", "__version__",
]
