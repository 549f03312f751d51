"""Tests of the plugin for ParaView, which scripts/test-paraview runs: pvpython bindings/paraview/test.py [MESH]...

Each MESH is read by the plugin, written, and compared with itself.
"""

import gc
import os
import sys
import tempfile
import unittest

import numpy as np

import clers
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import (vtkLogger, vtkOutputWindow, vtkPoints, vtkSOADataArrayTemplate, vtkStringArray,
                                      vtkStringOutputWindow)
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkMultiBlockDataSet, vtkPolyData, vtkUnstructuredGrid

vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)  # tests read what vtkOutputWindow is told
simple.LoadPlugin(os.path.join(os.path.dirname(os.path.abspath(__file__)), "clers_paraview.py"), ns=globals())

TETRAHEDRON = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
POINTS = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], np.float32)
TYPES = ["int8", "int16", "int32", "int64", "uint8", "uint16", "uint32", "uint64", "float32", "float64"]


def polydata(faces, points, point_data=(), cell_data=()):
    """Of arrays, without the plugin."""
    result = vtkPolyData()
    result.SetPoints(vtkPoints())
    result.GetPoints().SetData(numpy_to_vtk(points, deep=1))
    cells = vtkCellArray()
    for face in faces:
        cells.InsertNextCell(len(face), [int(v) for v in face])
    result.SetPolys(cells)
    for data, arrays in ((result.GetPointData(), point_data), (result.GetCellData(), cell_data)):
        for name, values in dict(arrays).items():
            array = numpy_to_vtk(values, deep=1)
            array.SetName(name)
            data.AddArray(array)
    return result


def faces_of(data):
    polys = data.GetPolys()
    ends = vtk_to_numpy(polys.GetOffsetsArray())
    corners = vtk_to_numpy(polys.GetConnectivityArray())
    return [corners[a:b].tolist() for a, b in zip(ends, ends[1:])]


def array(data, name):
    found = data.GetArray(name)
    return None if found is None else vtk_to_numpy(found)


def grid(n):
    """n by n quadrilaterals."""
    at = np.arange((n + 1) * (n + 1)).reshape(n + 1, n + 1)
    faces = np.stack([at[:-1, :-1], at[:-1, 1:], at[1:, 1:], at[1:, :-1]], -1).reshape(-1, 4)
    x, y = np.meshgrid(np.arange(n + 1.0), np.arange(n + 1.0))
    return faces, np.stack([x, y, np.sin(x) * y], -1).reshape(-1, 3)


class Plugin(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = os.path.join(folder.name, "a.clers")
        self.said = vtkStringOutputWindow()
        before = vtkOutputWindow.GetInstance()
        vtkOutputWindow.SetInstance(self.said)
        self.addCleanup(vtkOutputWindow.SetInstance, before)

    def read(self, **properties):
        reader = ClersReader(FileName=self.path, **properties)
        self.addCleanup(simple.Delete, reader)
        reader.UpdatePipeline()
        return servermanager.Fetch(reader)

    def write(self, data, **properties):
        producer = simple.TrivialProducer()
        producer.GetClientSideObject().SetOutput(data)
        self.addCleanup(simple.Delete, producer)
        producer.UpdatePipeline()
        simple.SaveData(self.path, producer, **properties)

    def encode(self, *meshes, **options):
        with open(self.path, "wb") as file:
            file.write(clers.encode(list(meshes), order="keep", **options))

    def says(self, *texts):
        for text in texts:
            self.assertIn(text, self.said.GetOutput())

    def is_silent(self):
        self.assertEqual(self.said.GetOutput(), "")

    def test_triangles_come_back_in_their_order(self):
        self.write(polydata(TETRAHEDRON, POINTS), KeepOrder=1)
        back = self.read()
        self.assertEqual(faces_of(back), TETRAHEDRON.tolist())
        np.testing.assert_array_equal(vtk_to_numpy(back.GetPoints().GetData()), POINTS)
        self.assertEqual(vtk_to_numpy(back.GetPoints().GetData()).dtype, np.float32)
        self.is_silent()

    def test_polygons_in_the_order_of_the_codec(self):
        faces, points = grid(9)
        faces = faces.tolist()
        faces[:2] = [[0, 1, 2, 12, 11, 10]]  # two quadrilaterals become a hexagon
        self.write(polydata(faces, points), Level=9)
        mesh = clers.read(self.path)
        self.assertTrue(clers.compare(mesh, clers.make_mesh(faces, points)))
        back = self.read()
        self.assertEqual(faces_of(back), [f.tolist() for f in mesh.face_list()])
        self.assertEqual(back.GetCell(0).GetNumberOfPoints(), len(mesh.face_list()[0]))
        np.testing.assert_array_equal(vtk_to_numpy(back.GetPoints().GetData()), points[self.old_points(mesh, points)])
        self.is_silent()

    def old_points(self, mesh, points):
        return [int(np.flatnonzero((points == p).all(1))[0]) for p in mesh.vertices]

    def test_data_of_every_type(self):
        faces, points = grid(5)
        random = np.random.default_rng(1)

        def values(kind, shape):
            if kind[0] == "f":
                return random.normal(size=shape).astype(kind)
            limits = np.iinfo(kind)
            return random.integers(limits.min, limits.max, shape, kind, endpoint=True)

        at_points = {"p" + t: values(t, (len(points),)) for t in TYPES}
        at_cells = {"c" + t: values(t, (len(faces), 4)) for t in TYPES}
        self.write(polydata(faces, points, at_points, at_cells), KeepOrder=1)
        back = self.read()
        gc.collect()  # arrays live on in VTK
        for data, given in ((back.GetPointData(), at_points), (back.GetCellData(), at_cells)):
            self.assertEqual(data.GetNumberOfArrays(), len(given))
            for name, expected in given.items():
                np.testing.assert_array_equal(array(data, name), expected)
                self.assertEqual(array(data, name).dtype, expected.dtype, name)
        self.is_silent()

    def test_normals_and_texture_coordinates_are_active(self):
        data = polydata(TETRAHEDRON, POINTS, {"Normals": POINTS, "TCoords": POINTS[:, :2].copy()},
                        {"Normals": POINTS})
        data.GetPointData().SetActiveNormals("Normals")
        data.GetPointData().SetActiveTCoords("TCoords")
        data.GetCellData().SetActiveNormals("Normals")
        self.write(data, KeepOrder=1)
        self.assertEqual([(a.name, a.domain) for a in clers.read(self.path).attributes],
                         [("position", "vertex"), ("normal", "vertex"), ("texcoord", "vertex"), ("normal", "face")])
        back = self.read()
        np.testing.assert_array_equal(vtk_to_numpy(back.GetPointData().GetNormals()), POINTS)
        np.testing.assert_array_equal(vtk_to_numpy(back.GetPointData().GetTCoords()), POINTS[:, :2])
        np.testing.assert_array_equal(vtk_to_numpy(back.GetCellData().GetNormals()), POINTS)
        self.is_silent()

    def test_bits_of_positions(self):
        faces, points = grid(9)
        self.write(polydata(faces, points, {"position": points}), KeepOrder=1, PositionBits=8)
        back = self.read()
        off = np.abs(vtk_to_numpy(back.GetPoints().GetData()) - points).max()
        self.assertGreater(off, 0)
        self.assertLess(off, 9 / 255)

    def test_corners_split_at_seams(self):
        corner = np.zeros((12, 2), np.float32)
        corner[1] = [1, 2]  # of vertex 2 in the first face alone
        self.encode(clers.make_mesh(TETRAHEDRON, POINTS, [clers.Attribute("texcoord", corner, "corner"),
                                                          clers.Attribute("heat", np.arange(4.0))]))
        back = self.read()
        self.assertEqual(back.GetNumberOfPoints(), 5)
        self.assertEqual(back.GetNumberOfCells(), 4)
        faces, points = np.array(faces_of(back)), vtk_to_numpy(back.GetPoints().GetData())
        np.testing.assert_array_equal(points[faces], POINTS[TETRAHEDRON])
        np.testing.assert_array_equal(points[:4], POINTS)
        np.testing.assert_array_equal(array(back.GetPointData(), "heat"), [0, 1, 2, 3, 2])
        np.testing.assert_array_equal(vtk_to_numpy(back.GetPointData().GetTCoords())[faces].reshape(-1, 2), corner)
        self.says("4 vertices became 5 points", "'texcoord'")

    def test_corners_that_agree_are_points(self):
        self.encode(clers.make_mesh(TETRAHEDRON, np.vstack([POINTS, [[5, 5, 5]]]).astype(np.float32),
                                    [clers.Attribute("id", TETRAHEDRON.reshape(-1).astype(np.int32), "corner")]))
        back = self.read()
        self.assertEqual(faces_of(back), TETRAHEDRON.tolist())
        np.testing.assert_array_equal(array(back.GetPointData(), "id"), [0, 1, 2, 3, 0])
        self.is_silent()

    def test_values_by_index_and_missing_ones(self):
        none = clers.NO_VALUE
        by_index = np.array([0, 1, 1, none] * 3, np.uint32)
        self.encode(clers.make_mesh(TETRAHEDRON, POINTS, [
            clers.Attribute("a", np.array([1.5, 2.5]), "corner", by_index),
            clers.Attribute("b", np.array([7, 8], np.int16), "face", np.array([1, none, 0, 0], np.uint32))]))
        back = self.read()
        expected = np.array([1.5, 2.5, 2.5, np.nan] * 3)
        np.testing.assert_array_equal(array(back.GetPointData(), "a")[np.array(faces_of(back)).reshape(-1)], expected)
        np.testing.assert_array_equal(array(back.GetCellData(), "b"), [8, 0, 7, 7])
        self.says("'a' has no value for 3 of 12", "'b' has no value for 1 of 4")

    def test_names_that_repeat_and_positions_of_two_components(self):
        self.encode(clers.make_mesh(TETRAHEDRON, POINTS[:, :2], [clers.Attribute("x", np.zeros(4)),
                                                                 clers.Attribute("x", np.ones(4))]))
        back = self.read()
        np.testing.assert_array_equal(array(back.GetPointData(), "x"), np.zeros(4))
        np.testing.assert_array_equal(array(back.GetPointData(), "x 2"), np.ones(4))
        np.testing.assert_array_equal(vtk_to_numpy(back.GetPoints().GetData())[:, 2], np.zeros(4))
        self.says("'x' is called 'x 2'", "positions have 2 components")

    def test_no_positions_and_no_faces(self):
        self.encode(clers.make_mesh(TETRAHEDRON, vertex_count=4))
        self.assertEqual(faces_of(self.read()), TETRAHEDRON.tolist())
        self.says("no positions")
        self.write(polydata([], POINTS), KeepOrder=1)
        back = self.read()
        self.assertEqual((back.GetNumberOfPoints(), back.GetNumberOfCells()), (4, 0))
        self.write(vtkPolyData())
        self.assertEqual(self.read().GetNumberOfPoints(), 0)

    def test_faces_of_few_corners(self):
        faces = [[0, 2, 1], [3], [], [1, 2]]
        self.encode(clers.make_mesh(faces, POINTS, [clers.Attribute("c", np.arange(6.0), "corner")]))
        back = self.read()
        self.assertEqual([len(f) for f in faces_of(back)], [3, 1, 0, 2])
        np.testing.assert_array_equal(array(back.GetPointData(), "c")[sum(faces_of(back), [])], np.arange(6.0))
        self.encode(clers.make_mesh([], POINTS, [clers.Attribute("c", np.zeros((0, 2)), "corner")]))
        np.testing.assert_array_equal(array(self.read().GetPointData(), "c"), np.full((4, 2), np.nan))

    def test_components_apart_and_polygons_of_32_bits(self):
        data = polydata(TETRAHEDRON, POINTS)
        data.GetPolys().ConvertTo32BitStorage()
        apart = vtkSOADataArrayTemplate["float64"]()
        apart.SetName("apart")
        apart.SetNumberOfComponents(3)
        for point in POINTS:
            apart.InsertNextTuple(point.astype(float).tolist())
        data.GetPointData().AddArray(apart)
        self.write(data, KeepOrder=1)
        back = self.read()
        self.assertEqual(faces_of(back), TETRAHEDRON.tolist())
        np.testing.assert_array_equal(array(back.GetPointData(), "apart"), POINTS)
        self.is_silent()

    def test_what_is_no_polydata_is_refused(self):
        simple.SaveData(self.path, simple.ExtractSurface(Input=simple.Wavelet()))
        self.assertGreater(clers.read(self.path).face_count, 0)
        os.remove(self.path)
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, vtkUnstructuredGrid())
        self.write(blocks)
        self.assertFalse(os.path.exists(self.path))
        self.says("vtkUnstructuredGrid, expected vtkPolyData")

    def test_names_and_metadata(self):
        self.encode(clers.make_mesh(TETRAHEDRON, POINTS, name="héro",
                                    metadata={"author": "Ä".encode(), "raw": b"\xff"}))
        back = self.read()
        fields = back.GetFieldData()
        self.assertEqual(fields.GetAbstractArray("mesh name").GetValue(0), "héro")
        self.assertEqual(fields.GetAbstractArray("author").GetValue(0), "Ä")
        self.says("metadata 'raw' is no text")
        lost = numpy_to_vtk(np.arange(3), deep=1)
        lost.SetName("time")
        fields.AddArray(lost)
        words = vtkStringArray()
        words.SetName("words")
        words.SetNumberOfValues(4)
        back.GetPointData().AddArray(words)
        self.write(back)
        mesh = clers.read(self.path)
        self.assertEqual((mesh.name, mesh.metadata), ("héro", {"author": "Ä".encode()}))
        self.says("field data 'time'", "array 'words'")

    def test_several_meshes(self):
        faces, points = grid(3)
        self.encode(clers.make_mesh(TETRAHEDRON, POINTS, name="first"), clers.make_mesh(faces, points, name="second"))
        back = self.read()
        self.assertEqual(back.GetClassName(), "vtkMultiBlockDataSet")
        self.assertEqual([back.GetBlock(i).GetNumberOfCells() for i in range(2)], [4, 9])
        self.write(back, KeepOrder=1)
        with open(self.path, "rb") as file:
            again = clers.decode_all(file.read())
        self.assertEqual([m.name for m in again], ["first", "second"])
        np.testing.assert_array_equal(again[1].faces, faces)
        chosen = self.read(Mesh=1)
        self.assertEqual(chosen.GetClassName(), "vtkPolyData")
        self.assertEqual(faces_of(chosen), faces.tolist())
        self.is_silent()
        self.read(Mesh=2)
        self.says("mesh 2")

    def test_blocks_in_blocks(self):
        inner, outer = vtkMultiBlockDataSet(), vtkMultiBlockDataSet()
        inner.SetBlock(0, polydata(TETRAHEDRON, POINTS))
        outer.SetBlock(0, polydata(TETRAHEDRON[:1], POINTS))
        outer.SetBlock(1, inner)
        outer.SetBlock(3, polydata(TETRAHEDRON[:2], POINTS))
        self.write(outer)
        with open(self.path, "rb") as file:
            self.assertEqual([m.face_count for m in clers.decode_all(file.read())], [1, 4, 2])
        self.says("block 2 is empty", "the blocks in block 1")

    def test_other_cells_are_refused(self):
        for kind in ("Verts", "Lines", "Strips"):
            data = polydata(TETRAHEDRON, POINTS)
            cells = vtkCellArray()
            cells.InsertNextCell(4, [0, 1, 2, 3])
            getattr(data, "Set" + kind)(cells)
            self.write(data)
            self.assertFalse(os.path.exists(self.path))
        self.says("vertices as cells (1)", "lines as cells (1)", "triangle strips as cells (1)", "Triangulate")

    def test_a_file_that_changes_is_read_anew(self):
        self.encode(clers.make_mesh(TETRAHEDRON, POINTS))
        reader = ClersReader(FileName=self.path)
        self.addCleanup(simple.Delete, reader)
        reader.UpdatePipeline()
        self.encode(clers.make_mesh(TETRAHEDRON[:1], POINTS), clers.make_mesh(TETRAHEDRON[:2], POINTS))
        simple.ReloadFiles(reader)
        reader.UpdatePipeline()
        self.assertEqual(reader.GetClientSideObject().GetOutputDataObject(0).GetNumberOfCells(), 3)
        self.assertEqual(reader.GetDataInformation().GetNumberOfCells(), 3)

    def test_hostile_bytes_are_errors(self):
        good = bytes(clers.encode(*grid(9)))
        bad = [b"", b"solid nothing", good[:-1], good[:len(good) // 2], good + b"x"]
        bad += [good[:i] + bytes([good[i] ^ 0x40]) + good[i + 1:] for i in range(0, len(good), 7)]
        for data in bad:
            with open(self.path, "wb") as file:
                file.write(data)
            with self.assertRaises(clers.Error) as refused:
                clers.decode_all(data)
            before = self.said.GetOutput()
            back = self.read()
            self.assertEqual(back.GetNumberOfPoints() if back else 0, 0)
            self.assertIn(f"{self.path}: {refused.exception}", self.said.GetOutput()[len(before):])

    def test_files_that_are_not_there(self):
        self.read()
        self.says("No such file")
        self.path = "/nowhere/at/all.clers"
        self.write(polydata(TETRAHEDRON, POINTS))
        self.assertEqual(self.said.GetOutput().count("No such file"), 2)

    def test_one_process_reads(self):
        self.encode(clers.make_mesh(TETRAHEDRON, POINTS))
        reader = ClersReader(FileName=self.path).GetClientSideObject()
        reader.UpdatePiece(1, 2, 0)
        self.assertEqual(reader.GetOutputDataObject(0).GetNumberOfPoints(), 0)
        reader.UpdatePiece(0, 2, 0)
        self.assertEqual(reader.GetOutputDataObject(0).GetNumberOfPoints(), 4)


def of_file(mesh):
    def test(self):
        given = clers.read(mesh)
        self.encode(given)
        back = self.read()
        self.assertEqual(back.GetNumberOfCells(), given.face_count)
        at = np.concatenate([np.zeros(0, int)] + [np.array(f, int) for f in faces_of(back)])
        np.testing.assert_array_equal(vtk_to_numpy(back.GetPoints().GetData())[at], given.vertices[given.corners])
        first = self.said.GetOutput()
        self.write(back, KeepOrder=1)
        again = self.read()
        self.assertEqual(faces_of(again), faces_of(back))
        for data in ("GetPointData", "GetCellData"):
            one, other = getattr(back, data)(), getattr(again, data)()
            self.assertEqual(one.GetNumberOfArrays(), other.GetNumberOfArrays())
            for i in range(one.GetNumberOfArrays()):
                self.assertEqual(one.GetArray(i).GetName(), other.GetArray(i).GetName())
                np.testing.assert_array_equal(vtk_to_numpy(one.GetArray(i)), vtk_to_numpy(other.GetArray(i)))
        self.assertEqual(self.said.GetOutput(), first)
    return test


if __name__ == "__main__":
    for number, path in enumerate(sys.argv[1:]):
        setattr(Plugin, f"test_mesh_{number}_{os.path.basename(path)}", of_file(path))
    unittest.main(argv=sys.argv[:1], verbosity=2)
