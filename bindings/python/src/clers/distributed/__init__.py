"""Many meshes, or one giant mesh, on many machines, by Dask.

    from clers import distributed
    distributed.encode_folder("meshes", "out")                                # this machine, a worker a core
    distributed.encode_folder("meshes", "out", scheduler="tcp://host:8786")   # a cluster that runs
    distributed.encode_mesh("giant.ply", "giant.clers", piece_faces=200_000)

Both give the bytes that one machine gives. What is finished is kept: a job that is started again goes on.
"""

from ._cluster import connect
from ._folder import FolderResult, encode_folder
from ._giant import encode_mesh

__all__ = ["FolderResult", "connect", "encode_folder", "encode_mesh"]
