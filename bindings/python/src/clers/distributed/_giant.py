"""One mesh by pieces: cut here, encoded by workers, joined here.

    mesh -- cut --> piece 0 --> worker --> PARTS/0.piece --+-- join --> target
                +-> piece 1 --> worker --> PARTS/1.piece --+

A worker has one piece at a time. The bytes are those of clers.encode: cutting is a function of mesh and options.
"""

from __future__ import annotations

import io
import os
import shutil
from typing import Any, Dict, Iterator, Optional, Tuple

import numpy as np

import clers

from .. import _clers
from .._api import Permutation, read, replace
from .._mesh import as_mesh, to_native
from .._options import native_options
from ._cluster import Bar, Scheduler, connect, run, threads_of
from ._store import Manifest, digest_of


def encode_mesh(mesh: Any, target: str, *, scheduler: Scheduler = None, workers: Optional[int] = None,
                progress: Optional[bool] = None, **options: Any) -> Permutation:
    """Encodes one mesh, or mesh file, to the file ``target``, by pieces on workers; returns how it was renumbered.

    ``mesh``       what clers.encode takes as a mesh, or the path of a mesh file
    ``scheduler``  address of a Dask scheduler, a Client, or None: ``workers`` processes of this machine
    ``options``    as of clers.encode; ``piece_faces`` says how large pieces are

    The mesh is in the memory of this process, and a piece in that of a worker. Pieces that are finished lie in
    ``target``.parts, checked by their digests, until the file is there: started again with the same mesh and
    options, only the others are encoded. A worker that dies loses the piece it was at, and another does it. By
    options that do not part the mesh it is encoded here, as a whole.
    """
    whole = read(mesh) if isinstance(mesh, (str, os.PathLike)) else as_mesh(mesh)
    native = to_native(whole)
    given = native_options(**options)
    apart = _clers.Apart(native, given)
    if apart.count == 0:
        encoded = clers.encode(whole, **options)
        replace(target, encoded)
        return encoded.permutations[0]
    parts = target + ".parts"
    os.makedirs(parts, exist_ok=True)
    manifest = Manifest(os.path.join(parts, "manifest.jsonl"), {
        "version": clers.__version__, "mesh": _digest_of_mesh(native), "level": given["level"], "piece_faces": given["piece_faces"],
        "plan": digest_of(apart.plan), "pieces": apart.count})
    coded: Dict[int, Tuple[Any, ...]] = {}
    for k in range(apart.count):
        kept = _load(_path(parts, k), manifest.get(str(k)))
        if kept is not None:
            coded[k] = kept
    bar = Bar(progress, apart.count)
    bar.show(len(coded), "pieces")
    missing = [k for k in range(apart.count) if k not in coded]
    if missing:
        def jobs() -> Iterator[Tuple[Any, ...]]:
            for k in missing:
                yield k, apart.piece(k), apart.plan, given["level"]

        with connect(scheduler, workers) as client:
            for k, piece in run(client, _encode_piece, jobs(), threads_of(client) + 1):
                data = _packed(piece)
                replace(_path(parts, k), data)
                manifest.add({"name": str(k), "sha256": digest_of(data)})
                coded[k] = piece
                bar.show(len(coded), "pieces")
    data, order = apart.join([coded[k] for k in range(apart.count)])
    replace(target, data)
    shutil.rmtree(parts)
    return Permutation(*order)


def _encode_piece(k: int, piece: Tuple[Any, ...], plan: bytes, level: int) -> Tuple[int, Tuple[Any, ...]]:
    """On a worker."""
    return k, _clers.encode_piece(piece, plan, level)


def _digest_of_mesh(native: Tuple[Any, ...]) -> str:
    """Of all that decides bytes."""
    vertex_count, corners, sizes, attributes, name, metadata = native
    told = repr((vertex_count, corners.dtype, sizes is None, name, metadata,
                 [(n, d, v.dtype.str, v.shape, i is None) for n, d, v, i in attributes])).encode()
    arrays = [corners, sizes, *(a for row in attributes for a in row[2:])]
    digests = [digest_of(np.ascontiguousarray(a)) for a in arrays if a is not None]
    return digest_of(told + "".join(digests).encode())


def _path(parts: str, k: int) -> str:
    return os.path.join(parts, f"{k}.piece")


def _packed(piece: Tuple[Any, ...]) -> bytes:
    out = io.BytesIO()
    np.savez(out, data=np.frombuffer(piece[0], np.uint8), vertices=piece[1], faces=piece[2], first_corners=piece[3])
    return out.getvalue()


def _load(path: str, entry: Optional[Dict[str, Any]]) -> Optional[Tuple[Any, ...]]:
    """A piece that was finished before; None if it is not, or not as the manifest says."""
    if entry is None or not os.path.exists(path):
        return None
    with open(path, "rb") as file:
        data = file.read()
    if digest_of(data) != entry["sha256"]:
        return None
    with np.load(io.BytesIO(data), allow_pickle=False) as arrays:
        return arrays["data"].tobytes(), arrays["vertices"], arrays["faces"], arrays["first_corners"]
