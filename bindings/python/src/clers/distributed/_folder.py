"""A folder of mesh files -> a folder of .clers files."""

from __future__ import annotations

import os
from dataclasses import dataclass, field
from typing import Any, Dict, Iterator, List, Optional, Tuple

import clers

from .._api import replace
from .._errors import Error
from .._options import native_options
from ._cluster import Bar, Scheduler, connect, run, threads_of
from ._store import Manifest, digest_of

ENDINGS = (".ply", ".obj", ".off", ".stl")
MANIFEST = "clers-manifest.jsonl"


@dataclass
class FolderResult:
    """``encoded`` now, ``kept`` from before; ``failed``: path in the folder -> why. ``bytes_in``, ``bytes_out``: of
    all that is encoded."""

    encoded: List[str] = field(default_factory=list)
    kept: List[str] = field(default_factory=list)
    failed: Dict[str, str] = field(default_factory=dict)
    bytes_in: int = 0
    bytes_out: int = 0


def encode_folder(source: str, target: str, *, scheduler: Scheduler = None, workers: Optional[int] = None,
                  progress: Optional[bool] = None, **options: Any) -> FolderResult:
    """Encodes all mesh files below ``source`` (.ply, .obj, .off, .stl) to the same paths below ``target``, which
    workers must see under the same names; NAME.ply becomes NAME.ply.clers.

    ``scheduler``  address of a Dask scheduler, a Client, or None: ``workers`` processes of this machine
    ``progress``   a bar; None: on a terminal
    ``options``    as of clers.encode: level, order, precision, piece_faces, threads, reject

    Files have the bytes that clers.encode(clers.read(..)) gives. They appear as a whole. A manifest in ``target``
    says what is finished: started again with the same options, files of the same size and time of change whose
    output is there are kept. A worker that dies loses the files it was at, and others do these. A file that cannot
    be read or encoded is in ``failed`` and stops nothing.
    """
    native = native_options(**options)  # errors at once
    native["progress"] = None
    source, target = os.path.abspath(source), os.path.abspath(target)
    os.makedirs(target, exist_ok=True)
    del native["threads"]  # bytes do not depend on it
    manifest = Manifest(os.path.join(target, MANIFEST), {"version": clers.__version__, "options": repr(native)})
    result = FolderResult()
    names = sorted(_mesh_files(source))
    todo: List[Tuple[str, str, str, Dict[str, Any]]] = []
    for name in names:
        known = manifest.get(name)
        if known and known["stamp"] == _stamp(os.path.join(source, name)) and \
                _size(_output(target, name)) == known["bytes_out"]:
            result.kept.append(name)
        else:
            todo.append((source, target, name, options))
    bar = Bar(progress, len(names))
    bar.show(len(result.kept), "files")
    if todo:
        with connect(scheduler, workers) as client:
            for entry in run(client, _encode_file, todo, 4 * threads_of(client)):
                if "failed" in entry:
                    result.failed[entry["name"]] = entry["failed"]
                else:
                    manifest.add(entry)
                    result.encoded.append(entry["name"])
                    result.bytes_in += entry["stamp"][0]
                    result.bytes_out += entry["bytes_out"]
                bar.show(len(result.kept) + len(result.encoded) + len(result.failed), "files")
    result.encoded.sort()
    return result


def _mesh_files(source: str) -> Iterator[str]:
    for folder, _, files in os.walk(source):
        for name in files:
            if name.lower().endswith(ENDINGS):
                yield os.path.relpath(os.path.join(folder, name), source)


def _output(target: str, name: str) -> str:
    return os.path.join(target, name + ".clers")


def _stamp(path: str) -> List[int]:
    status = os.stat(path)
    return [status.st_size, status.st_mtime_ns]


def _size(path: str) -> int:
    return os.path.getsize(path) if os.path.exists(path) else -1


def _encode_file(source: str, target: str, name: str, options: Dict[str, Any]) -> Dict[str, Any]:
    """On a worker. The input is read, and its time looked at, before: one that changes meanwhile is done again."""
    path, output = os.path.join(source, name), _output(target, name)
    try:
        stamp = _stamp(path)
        data = clers.encode(clers.read(path), **options)
        os.makedirs(os.path.dirname(output), exist_ok=True)
        replace(output, data)
    except (Error, OSError, ValueError) as error:
        return {"name": name, "failed": f"{error}"}
    return {"name": name, "stamp": stamp, "bytes_out": len(data), "sha256": digest_of(data)}
