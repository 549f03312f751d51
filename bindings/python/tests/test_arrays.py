"""Arrays are read where they lie; what other packages call a mesh is taken."""

import numpy as np
import pytest

import clers
from clers._mesh import packed_words, rows
from shapes import grid, meshio_like, same, trimesh_like


@pytest.mark.parametrize("dtype", [np.uint32, np.int32, np.uint16])
def test_faces_are_not_copied(dtype):
    faces = grid(5, 5)[0].astype(dtype)
    assert np.shares_memory(packed_words(faces, "faces"), faces)


def test_values_are_not_copied():
    packed = grid(5, 5)[1]
    structs = np.zeros(25, [("place", np.float32, 3), ("weight", np.float64)])
    for values in (packed, structs["place"], structs["weight"], packed[:, :2], packed[::2]):
        assert np.shares_memory(rows(values, "values"), values)


def test_results_own_what_was_decoded():
    mesh = clers.decode(clers.encode(*grid(5, 5)))
    for array in (mesh.corners, mesh.vertices):
        base = array
        while isinstance(base.base, np.ndarray):
            base = base.base
        assert type(base.base).__name__ == "PyCapsule"
        assert array.flags.writeable


@pytest.mark.parametrize("dtype", [np.int64, np.uint64, np.int16, np.uint8, ">u4"])
def test_other_types_of_indices(dtype):
    faces, vertices = grid(5, 5)
    assert clers.encode(faces.astype(dtype), vertices) == clers.encode(faces, vertices)


def test_any_strides():
    faces, vertices = grid(5, 5)
    expected = clers.encode(faces, vertices)
    wide = np.zeros((25, 6), np.float32)
    wide[:, ::2] = vertices
    structs = np.zeros(25, [("pad", np.uint8), ("place", np.float32, 3)])
    structs["place"] = vertices
    for same_values in (wide[:, ::2], np.asfortranarray(vertices), vertices[::-1][::-1], structs["place"],
                        vertices.astype(">f4"), vertices.tolist()):
        given = same_values if isinstance(same_values, np.ndarray) else np.array(same_values, np.float32)
        assert clers.encode(faces, given) == expected
    assert clers.encode(np.asfortranarray(faces), vertices) == expected
    backwards = clers.decode(clers.encode(faces, vertices[::-1], order="keep"))
    assert (backwards.vertices == vertices[::-1]).all()


def test_broadcast_and_empty():
    faces, _ = grid(3, 3)
    same_place = np.broadcast_to(np.float32([1, 2, 3]), (9, 3))
    assert (clers.decode(clers.encode(faces, same_place)).vertices == [1, 2, 3]).all()
    nothing = clers.decode(clers.encode(np.zeros((0, 3), np.uint32), np.zeros((0, 3), np.float32)))
    assert nothing.vertex_count == nothing.face_count == 0
    points = clers.decode(clers.encode([], np.eye(3)))
    assert points.vertex_count == 3 and points.face_count == 0


def test_quads_and_polygons():
    quads = clers.decode(clers.encode(np.array([[0, 1, 2, 3], [3, 2, 4, 5]]), np.eye(6)[:, :3], order="keep"))
    assert quads.faces.tolist() == [[0, 1, 2, 3], [3, 2, 4, 5]]
    mixed = clers.decode(clers.encode([[0, 1, 2, 3], [3, 2, 4]], np.eye(5)[:, :3], order="keep"))
    assert [f.tolist() for f in mixed.face_list()] == [[0, 1, 2, 3], [3, 2, 4]]
    with pytest.raises(ValueError, match="face_list"):
        mixed.faces


def test_domain_by_count():
    faces, vertices = grid(3, 5)
    counts = {"vertex": 15, "corner": faces.size, "face": len(faces)}
    mesh = clers.make_mesh(faces, vertices, {domain: np.zeros(n) for domain, n in counts.items()})
    assert all(a.name == a.domain for a in mesh.attributes[1:])
    with pytest.raises(ValueError, match="7 values"):
        clers.make_mesh(faces, vertices, {"a": np.zeros(7)})
    with pytest.raises(ValueError, match="vertex or face"):
        clers.make_mesh(np.array([[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]]), np.eye(4), {"a": np.zeros(4)})


def test_trimesh():
    faces, vertices = grid(4, 5, np.float64)
    colors = np.arange(80, dtype=np.uint8).reshape(20, 4)
    given = trimesh_like(faces.astype(np.int64), vertices, vertex_attributes={"heat": np.arange(20.0)},
                         face_attributes={"part": np.zeros(len(faces), np.int64)},
                         visual=trimesh_like(None, None, kind="vertex", vertex_colors=colors))
    back = clers.decode(clers.encode(given, order="keep"))
    assert (back["heat"] == np.arange(20)).all() and (back["color"] == colors).all()
    assert back.attribute("part").domain == "face" and (back.faces == faces).all()
    uv = np.arange(40.0).reshape(20, 2)
    given.visual = trimesh_like(None, None, kind="texture", uv=uv)
    assert (clers.decode(clers.encode(given, order="keep"))["texcoord"] == uv).all()


def test_meshio():
    faces, vertices = grid(4, 5)
    given = meshio_like(vertices, [("triangle", faces[:6]), ("quad", np.array([[0, 1, 2, 3]])), ("triangle", faces[6:])],
                        {"heat": np.arange(20)}, {"part": [np.zeros(6), np.ones(1), np.full(len(faces) - 6, 2.0)]})
    back = clers.decode(clers.encode(given, order="keep"))
    assert back.face_list()[6].tolist() == [0, 1, 2, 3] and back["part"][6] == 1 and len(back["heat"]) == 20
    only = meshio_like(vertices, [("triangle", faces)])
    assert clers.decode(clers.encode(only)).face_sizes is None
    same(clers.as_mesh(only), clers.decode(clers.encode(only)))
    for kind in ("tetra", "line", "triangle6"):
        with pytest.raises(ValueError, match=kind):
            clers.encode(meshio_like(vertices, [(kind, faces)]))


def test_what_is_no_mesh():
    faces, vertices = grid(3, 3)
    with pytest.raises(TypeError, match="no mesh"):
        clers.encode(object())
    with pytest.raises(ValueError, match="expected integers"):
        clers.encode(faces.astype(float), vertices)
    with pytest.raises(ValueError, match="-1"):
        clers.encode(faces.astype(np.int64) - 1, vertices)
    with pytest.raises(TypeError, match="float16"):
        clers.encode(faces, vertices.astype(np.float16))
    with pytest.raises(ValueError, match="dimensions"):
        clers.encode(faces, vertices.reshape(3, 3, 3))
    with pytest.raises(ValueError, match="domain"):
        clers.encode(clers.make_mesh(faces, vertices, [clers.Attribute("a", np.zeros(9), "edge")]))
