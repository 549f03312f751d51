"""A plugin for ParaView: reads and writes .clers files, by the Python package clers.

    mesh of clers                  vtkPolyData
    vertex attribute "position"    points
    vertex attributes              point data
    corner attributes              point data, of points that are split where corners of a vertex differ
    face attributes                cell data
    name, metadata                 name of the block, field data of one string

Arrays are read where VTK has them, but for 64-bit indices; what was decoded is copied once, into memory of VTK. What
has no place on the other side is said by a warning, what goes wrong by an error.
"""

import os

import numpy as np
from paraview import print_error, print_warning
from paraview.util.vtkAlgorithm import VTKPythonAlgorithmBase, smdomain, smhint, smproperty, smproxy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_BIT, vtkDataArray, vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import (vtkCellArray, vtkCompositeDataSet, vtkDataObject, vtkMultiBlockDataSet,
                                           vtkPartitionedDataSetCollection, vtkPolyData)
from vtkmodules.vtkParallelCore import vtkMultiProcessController

try:
    import clers
    from clers._api import replace
except ImportError as error:
    raise ImportError(f"{error}; the folder of the Python package clers must be on PYTHONPATH") from None

paraview_plugin_name = "clers"
paraview_plugin_version = clers.__version__

NAME = "mesh name"  # of a mesh that is no block: a string in field data
REFUSED = (OSError, ValueError, TypeError, MemoryError, clers.Error)

# What attributes are active, by the names that mesh files, glTF and VTK give them.
NORMALS = ("normal", "normals")
TEXCOORDS = ("texcoord", "texcoord_0", "tcoords", "texture coordinates")


# From clers to VTK

def polydata_of(mesh, warn):
    """A clers.Mesh as vtkPolyData; ``warn`` is told what changed on the way."""
    corners, origin, first_corner = split_along_seams(mesh, warn)
    result = vtkPolyData()
    seen, positions = set(), None
    for attribute in mesh.attributes:
        values = values_of(attribute, warn)
        if attribute.domain == "vertex":
            values = values if origin is None else values[origin]
        elif attribute.domain == "corner":
            values = of_corners(values, first_corner)
        if positions is None and (attribute.name, attribute.domain) == ("position", "vertex"):
            positions = values
        else:
            add_array(result, attribute, values, seen, warn)
    points = vtkPoints()
    count = mesh.vertex_count if origin is None else len(origin)
    points.SetData(to_vtk(three_components(positions, count, result, warn), "Points"))
    result.SetPoints(points)
    result.SetPolys(cells_of(corners, mesh.face_sizes))
    for key, value in mesh.metadata.items():
        add_text(result, key, value, warn)
    return result


def split_along_seams(mesh, warn):
    """Corners by points, the vertex of each point, and a corner of each point, -1: it has none.

    VTK has no values of corners. Corners of a vertex are one point where all their values are the same; the first of
    these points has the vertex's number, others come after all vertices.
    """
    attributes = [a for a in mesh.attributes if a.domain == "corner"]
    if not attributes or len(mesh.corners) == 0:
        return mesh.corners, None, np.full(mesh.vertex_count, -1)
    wedge = mesh.corners.astype(np.int64)
    for attribute in attributes:
        values = distinct(attribute.values)
        if attribute.indices is not None:
            values = np.append(values, len(values))  # what has no value, too, is a value
            values = values[np.minimum(attribute.indices, len(values) - 1)]
        wedge = np.unique(wedge * (int(values.max()) + 1) + values, return_inverse=True)[1]
    first = np.unique(wedge, return_index=True)[1]
    vertex = mesh.corners[first]
    keeps = np.zeros(len(first), bool)
    keeps[np.unique(vertex, return_index=True)[1]] = True
    point = vertex.astype(np.int64)
    point[~keeps] = mesh.vertex_count + np.arange(np.count_nonzero(~keeps))
    if not keeps.all():
        names = ", ".join(f"'{a.name}'" for a in attributes)
        warn(f"{mesh.vertex_count} vertices became {mesh.vertex_count + np.count_nonzero(~keeps)} points: "
             f"values of corners ({names}) differ along seams")
    origin = np.concatenate([np.arange(mesh.vertex_count), vertex[~keeps]])
    first_corner = np.full(len(origin), -1)
    first_corner[point] = first
    return point[wedge].astype(np.uint32), None if keeps.all() else origin, first_corner


def distinct(values):
    """A number for each row: the same one for the same bits."""
    if len(values) == 0:
        return np.zeros(0, np.int64)
    rows = np.ascontiguousarray(values).reshape(len(values), -1)
    return np.unique(rows.view(np.dtype((np.void, rows.dtype.itemsize * rows.shape[1]))), return_inverse=True)[1]


def values_of(attribute, warn):
    """The value of each element; nan or 0 where it has none."""
    if attribute.indices is None:
        return attribute.values
    missing = attribute.indices == clers.NO_VALUE
    if not missing.any():
        return attribute.values[attribute.indices]
    result = nothing((len(missing),) + attribute.values.shape[1:], attribute.values.dtype)
    result[~missing] = attribute.values[attribute.indices[~missing]]
    warn(f"'{attribute.name}' has no value for {np.count_nonzero(missing)} of {len(missing)} elements: "
         f"they are {'nan' if result.dtype.kind == 'f' else 0}")
    return result


def of_corners(values, first_corner):
    """Values of corners, one a point; nan or 0 for a point of no face."""
    result = nothing((len(first_corner),) + values.shape[1:], values.dtype)
    result[first_corner >= 0] = values[first_corner[first_corner >= 0]]
    return result


def nothing(shape, dtype):
    return np.full(shape, np.nan if dtype.kind == "f" else 0, dtype)


def three_components(positions, count, result, warn):
    if positions is None:
        warn("the mesh has no positions: all points are (0, 0, 0)")
        return np.zeros((count, 3), np.float32)
    positions = positions.reshape(count, -1)
    components = positions.shape[1]
    if components < 3:
        warn(f"positions have {components} components: the others are 0")
        return np.pad(positions, ((0, 0), (0, 3 - components)))
    if components > 3:
        warn(f"positions have {components} components: the first 3 are the points, all are in point data 'position'")
        result.GetPointData().AddArray(to_vtk(positions, "position"))
    return positions[:, :3]


def cells_of(corners, sizes):
    if sizes is None:
        offsets = np.arange(0, len(corners) + 1, 3)
    else:
        offsets = np.concatenate([[0], np.cumsum(sizes, dtype=np.int64)])
    kind = np.int32 if len(corners) < 1 << 31 else np.int64
    cells = vtkCellArray()
    cells.SetData(to_vtk(offsets.astype(kind), "offsets"), to_vtk(corners.astype(kind), "corners"))
    return cells


def add_array(result, attribute, values, seen, warn):
    """Point or cell data, under a name that no other has: VTK would put one array in place of the other."""
    of_cells = attribute.domain == "face"
    name, number = attribute.name or "unnamed", 1
    while (of_cells, name) in seen:
        number += 1
        name = f"{attribute.name or 'unnamed'} {number}"
    if name != attribute.name:
        warn(f"attribute '{attribute.name}' is called '{name}'")
    seen.add((of_cells, name))
    data = result.GetCellData() if of_cells else result.GetPointData()
    data.AddArray(to_vtk(values, name))
    components = 1 if values.ndim == 1 else values.shape[1]
    if name.lower() in NORMALS and components == 3 and data.GetNormals() is None:
        data.SetActiveNormals(name)
    elif name.lower() in TEXCOORDS and components <= 3 and data.GetTCoords() is None:
        data.SetActiveTCoords(name)


def to_vtk(values, name):
    """A copy, which VTK owns: copies of arrays in VTK share memory, and know nothing of numpy's."""
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=1)
    array.SetName(name)
    return array


def add_text(result, key, value, warn):
    array = vtkStringArray()
    array.SetName(key)
    try:
        array.InsertNextValue(value.decode())
    except UnicodeDecodeError:
        warn(f"metadata '{key}' is no text, and left out")
        return
    result.GetFieldData().AddArray(array)


# From VTK to clers

def mesh_of(data, name, warn):
    """vtkPolyData as a clers.Mesh. ValueError if it has other cells than polygons."""
    for kind, count, advice in (("vertices", data.GetNumberOfVerts(), ""), ("lines", data.GetNumberOfLines(), ""),
                                ("triangle strips", data.GetNumberOfStrips(), "; Triangulate makes triangles of them")):
        if count:
            raise ValueError(f"{kind} as cells ({count}): a .clers file has faces alone{advice}")
    polys = data.GetPolys()
    corners, sizes = from_vtk(polys.GetConnectivityArray()), np.diff(from_vtk(polys.GetOffsetsArray()))
    faces = corners.reshape(-1, 3) if (sizes == 3).all() else (corners, sizes)
    points = data.GetPoints()
    positions = np.zeros((0, 3), np.float32) if points is None else from_vtk(points.GetData())
    attributes = []
    for values, domain in ((data.GetPointData(), "vertex"), (data.GetCellData(), "face")):
        for i in range(values.GetNumberOfArrays()):
            array = values.GetAbstractArray(i)
            array_name = array.GetName() or ""
            if not isinstance(array, vtkDataArray) or array.GetDataType() == VTK_BIT:
                warn(f"array '{array_name}' is of type {array.GetDataTypeAsString()}, and left out")
                continue
            for active, wanted in ((values.GetNormals(), "normal"), (values.GetTCoords(), "texcoord")):
                if array is active and not values.HasArray(wanted):
                    array_name = wanted
            attributes.append(clers.Attribute(array_name, from_vtk(array), domain))
    metadata = {}
    fields = data.GetFieldData()
    for i in range(fields.GetNumberOfArrays()):
        array = fields.GetAbstractArray(i)
        if not isinstance(array, vtkStringArray) or array.GetNumberOfValues() != 1:
            warn(f"field data '{array.GetName()}' is no single string, and left out")
        elif array.GetName() == NAME:
            name = name or array.GetValue(0)
        else:
            metadata[array.GetName() or ""] = array.GetValue(0).encode()
    return clers.make_mesh(faces, positions, attributes, name=name, metadata=metadata)


def from_vtk(array):
    """The same memory, unless VTK has each component apart or computes the values."""
    if not array.HasStandardMemoryLayout():
        copy = vtkDataArray.CreateDataArray(array.GetDataType())
        copy.DeepCopy(array)
        array = copy
    return vtk_to_numpy(array)


def polydata_in(data, warn, name=""):
    """Pairs of a name and vtkPolyData: blocks in their order. ValueError for what is none."""
    if isinstance(data, vtkPolyData):
        return [(name, data)]
    if isinstance(data, vtkPartitionedDataSetCollection):
        blocks = [(data.GetMetaData(i) if data.HasMetaData(i) else None, data.GetPartition(i, j))
                  for i in range(data.GetNumberOfPartitionedDataSets()) for j in range(data.GetNumberOfPartitions(i))]
    elif isinstance(data, vtkMultiBlockDataSet):
        blocks = [(data.GetMetaData(i) if data.HasMetaData(i) else None, data.GetBlock(i))
                  for i in range(data.GetNumberOfBlocks())]
    else:
        kind = "nothing" if data is None else data.GetClassName()
        raise ValueError(f"{name + ' is ' if name else ''}{kind}, expected vtkPolyData; Extract Surface makes it")
    result = []
    for i, (about, block) in enumerate(blocks):
        label = about.Get(vtkCompositeDataSet.NAME()) if about is not None else None
        if block is None:
            warn(f"block {i} is empty, and left out")
        else:
            if isinstance(block, vtkMultiBlockDataSet):
                warn(f"the blocks in block {i} are written beside the others")
            result += polydata_in(block, warn, label or "")
    return result


# What ParaView sees

@smproxy.reader(name="ClersReader", label="Clers Reader", extensions="clers", file_description="clers meshes",
                support_reload=False)
class ClersReader(VTKPythonAlgorithmBase):
    """vtkPolyData if the file has one mesh or one is chosen, else a vtkMultiBlockDataSet of all."""

    def __init__(self):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType="vtkDataObject")
        self._path, self._mesh, self._file, self._state = None, -1, None, None

    @smproperty.stringvector(name="FileName")
    @smdomain.filelist()
    @smhint.filechooser(extensions="clers", file_description="clers meshes")
    def SetFileName(self, path):
        if path != self._path:
            self._path = path
            self.Modified()

    @smproperty.intvector(name="Mesh", default_values=-1)
    @smdomain.intrange(min=-1)
    @smdomain.xml("<Documentation>Which mesh of the file, from 0; -1: all of them, as blocks.</Documentation>")
    def SetMesh(self, mesh):
        if mesh != self._mesh:
            self._mesh = mesh
            self.Modified()

    def _open(self):
        """The decoder of the file as it is now."""
        if not self._path or self._path == "None":
            raise ValueError("no file name")
        with open(self._path, "rb") as file:
            status = os.fstat(file.fileno())
            state = (self._path, status.st_ino, status.st_mtime_ns, status.st_size)
            if self._state != state:
                self._file = clers.Decoder(file.read(), threads=0)
                self._state = state
        return self._file

    def RequestDataObject(self, request, inInfo, outInfo):
        try:
            several = self._mesh < 0 and self._open().mesh_count != 1
        except REFUSED:
            several = False  # RequestData says why
        kind = vtkMultiBlockDataSet if several else vtkPolyData
        if type(vtkDataObject.GetData(outInfo)) is not kind:
            outInfo.GetInformationObject(0).Set(vtkDataObject.DATA_OBJECT(), kind())
        return 1

    def RequestData(self, request, inInfo, outInfo):
        output = vtkDataObject.GetData(outInfo)
        try:
            file = self._open()
            if isinstance(output, vtkPolyData):
                mesh = file.decode(max(self._mesh, 0))
                made = polydata_of(mesh, self._warner(""))
                if mesh.name:
                    add_text(made, NAME, mesh.name.encode(), print_warning)
                output.ShallowCopy(made)
            else:
                for i in range(file.mesh_count):
                    mesh = file.decode(i)
                    output.SetBlock(i, polydata_of(mesh, self._warner(f"mesh {i}: ")))
                    if mesh.name:
                        output.GetMetaData(i).Set(vtkCompositeDataSet.NAME(), mesh.name)
        except REFUSED + (IndexError,) as error:
            output.Initialize()
            print_error(f"{self._path}: {error}")
            return 0
        return 1

    def _warner(self, which):
        return lambda text: print_warning(f"{self._path}: {which}{text}")


@smproxy.writer(name="ClersWriter", label="Clers Writer", extensions="clers", file_description="clers meshes",
                support_reload=False)
@smproperty.input(name="Input", port_index=0)
@smdomain.datatype(dataTypes=["vtkPolyData", "vtkPartitionedDataSetCollection", "vtkMultiBlockDataSet"],
                   composite_data_supported=True)
class ClersWriter(VTKPythonAlgorithmBase):
    """vtkPolyData, or blocks of it, a mesh each. Active normals are called normal, texture coordinates texcoord."""

    def __init__(self):
        # Any type, or the pipeline would hand in one block after the other.
        super().__init__(nInputPorts=1, nOutputPorts=0, inputType="vtkDataObject")
        self._path, self._level, self._keep_order, self._bits = None, 5, False, 0

    @smproperty.stringvector(name="FileName", panel_visibility="never")
    @smdomain.filelist()
    def SetFileName(self, path):
        self._path = path
        self.Modified()

    @smproperty.intvector(name="Level", default_values=5)
    @smdomain.intrange(min=1, max=9)
    @smdomain.xml("<Documentation>1: fastest .. 9: smallest.</Documentation>")
    def SetLevel(self, level):
        self._level = level
        self.Modified()

    @smproperty.intvector(name="KeepOrder", default_values=0)
    @smdomain.xml('<BooleanDomain name="bool"/>')
    @smdomain.xml("<Documentation>Points and cells come back in their order; else in one that takes less."
                  "</Documentation>")
    def SetKeepOrder(self, keep):
        self._keep_order = bool(keep)
        self.Modified()

    @smproperty.intvector(name="PositionBits", default_values=0)
    @smdomain.intrange(min=0, max=30)
    @smdomain.xml("<Documentation>Steps of the longest side of the bounding box, as a power of 2. "
                  "0: bit for bit.</Documentation>")
    def SetPositionBits(self, bits):
        self._bits = bits
        self.Modified()

    def RequestData(self, request, inInfo, outInfo):
        def warn(text):
            print_warning(f"{self._path}: {text}")

        try:
            controller = vtkMultiProcessController.GetGlobalController()
            if controller is not None and controller.GetNumberOfProcesses() > 1:
                raise ValueError("written by one process alone, and there are several")
            data = polydata_in(vtkDataObject.GetData(inInfo[0], 0), warn)
            precision = {("position", "vertex"): self._bits} if self._bits else None
            encoded = clers.encode([mesh_of(block, name, warn) for name, block in data], level=self._level,
                                   order="keep" if self._keep_order else "free", precision=precision, threads=0)
            for warning in encoded.warnings:
                warn(f"mesh {warning.mesh}: {warning.domain} attribute '{warning.attribute}': {warning.what}")
            replace(self._path, encoded)
        except REFUSED as error:
            print_error(f"{self._path}: {error}")
            return 0
        return 1

    def Write(self):
        self.Modified()
        self.Update()
