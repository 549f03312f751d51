from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple

version: str

class MeshShape:
    vertices: int
    faces: int
    triangles: int
    isolated_vertices: int
    nonmanifold_edges: int
    nonmanifold_vertices: int
    misoriented_edges: int
    degenerate_faces: int
    duplicate_faces: int
    components: int
    nonorientable_components: int
    boundary_curves: int
    genus: int

class AttributeInfo:
    name: str
    domain: str
    dtype: str
    components: int
    count: int
    bytes: int
    numbers: str
    coder: str
    structure: str
    error: float
    measure: str

class MeshInfo:
    name: str
    vertices: int
    faces: int
    corners: int
    triangles_only: bool
    pieces: int
    copied_vertices: int
    welded_vertices: int
    repeated_faces: int
    degenerate_faces: int
    connectivity_bytes: int
    polygon_bytes: int
    stitching_bytes: int
    order_bytes: int
    position_bytes: int
    attribute_bytes: int
    metadata_bytes: int
    attributes: List[AttributeInfo]
    metadata: Dict[str, bytes]

class CodingCounts:
    reversed_faces: int
    symbols: Dict[str, int]

class FileInfo:
    format: Tuple[int, int]
    level: int
    total_bytes: int
    overhead_bytes: int
    meshes: List[MeshInfo]

class InspectedMesh:
    shape: MeshShape
    counts: CodingCounts

class Inspection:
    file: FileInfo
    meshes: List[InspectedMesh]

class OpenFile:
    mesh_count: int
    piece_count: int
    def __init__(self, data: Any, limits: Dict[str, int], threads: int,
                 progress: Optional[Callable[[str, float], None]]) -> None: ...
    def info(self) -> FileInfo: ...
    def decode_all(self) -> List[Tuple[Any, ...]]: ...
    def decode(self, mesh: int) -> Tuple[Any, ...]: ...
    def decode_into(self, mesh: int, corners: Any, sizes: Any, attributes: Sequence[Any]) -> None: ...
    def decode_piece(self, piece: int) -> Tuple[Any, ...]: ...

def encode(meshes: Sequence[Any], options: Dict[str, Any]) -> Tuple[Any, ...]: ...
def inspect(data: Any, limits: Dict[str, int]) -> Inspection: ...
def measure(mesh: Tuple[Any, ...]) -> MeshShape: ...
def read(data: Any, format: str) -> Tuple[Any, ...]: ...
def write(meshes: Sequence[Any], format: str, text: Optional[bool]) -> Tuple[Any, ...]: ...
def compare(a: Tuple[Any, ...], b: Tuple[Any, ...], tolerances: Sequence[Any]) -> Tuple[str, str]: ...

class Apart:
    count: int
    plan: bytes
    def __init__(self, mesh: Tuple[Any, ...], options: Dict[str, Any]) -> None: ...
    def piece(self, index: int) -> Tuple[Any, ...]: ...
    def join(self, pieces: Sequence[Any]) -> Tuple[bytes, Tuple[Any, ...]]: ...

def encode_piece(piece: Tuple[Any, ...], plan: Any, level: int) -> Tuple[Any, ...]: ...
