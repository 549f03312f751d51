"""What goes in comes out: random meshes, polygons, soups, attributes of all types, files."""

import os

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

import clers
from shapes import apply, grid, same

TYPES = ["int8", "uint8", "int16", "uint16", "int32", "uint32", "int64", "uint64", "float32", "float64"]


@st.composite
def meshes(draw):
    """Any faces on a few vertices: polygons, degenerate and repeated ones, none at all."""
    vertices = draw(st.integers(1, 12))
    vertex = st.integers(0, vertices - 1)
    if draw(st.booleans()):
        faces = draw(st.lists(st.lists(vertex, min_size=3, max_size=3), max_size=20))
        mesh = clers.make_mesh(faces, vertex_count=vertices)
    else:
        faces = draw(st.lists(st.lists(vertex, min_size=1, max_size=6), max_size=20))
        flat = np.array([v for f in faces for v in f], np.uint32)
        mesh = clers.make_mesh((flat, np.array([len(f) for f in faces], np.uint32)), vertex_count=vertices)
    counts = {"vertex": vertices, "corner": len(mesh.corners), "face": mesh.face_count}
    for i, domain in enumerate(draw(st.lists(st.sampled_from(sorted(counts)), max_size=3))):
        components = draw(st.integers(1, 4))
        shape = (counts[domain],) if components == 1 else (counts[domain], components)
        values = draw(hnp.arrays(draw(st.sampled_from(TYPES)), shape))
        mesh.attributes.append(clers.Attribute(f"a{i}", values, domain))
    return mesh


@settings(max_examples=60, deadline=None)
@given(meshes(), st.sampled_from([1, 5, 9]), st.booleans())
def test_random_meshes(mesh, level, keep):
    data = clers.encode(mesh, level=level, order="keep" if keep else "free")
    back = clers.decode(data)
    corners, sizes, values = apply(data.permutations[0], mesh)
    assert back.corners.tolist() == corners.tolist()
    assert (back.face_sizes is None or back.face_sizes.tolist() == sizes.tolist())
    assert back.face_sizes is not None or (sizes == 3).all()
    assert back.vertex_count == mesh.vertex_count
    assert len(back.attributes) == len(values)
    for a, b in zip(values, back.attributes):
        assert (a.name, a.domain, a.values.dtype) == (b.name, b.domain, b.values.dtype)
        assert a.values.tobytes() == b.values.tobytes() and a.values.shape == b.values.shape
    if keep:
        assert back.corners.tolist() == mesh.corners.tolist()
    assert data == clers.encode(mesh, level=level, order="keep" if keep else "free", threads=2)


def test_several_meshes_and_metadata():
    first = clers.make_mesh(*grid(5, 6), name="first", metadata={"source": b"\x00\xff", "note": b"text"})
    second = clers.make_mesh([[0, 1, 2, 3], [0, 1, 2]], vertex_count=5, name="zweites \u00fc")
    data = clers.encode([first, second])
    back = clers.decode_all(data)
    assert [m.name for m in back] == ["first", "zweites \u00fc"]
    assert back[0].metadata == first.metadata
    assert clers.Decoder(data).info().meshes[0].metadata == first.metadata
    assert [m.face_sizes is None for m in back] == [True, False]
    assert len(data.permutations) == len(data.report) == len(data.counts) == 2
    with pytest.raises(ValueError, match="2 meshes"):
        clers.decode(data)


def test_values_by_index():
    faces, vertices = grid(4, 4)
    uv = np.array([[0, 0], [1, 0], [0, 1]], np.float32)
    indices = np.arange(faces.size, dtype=np.uint32) % 3
    indices[5] = clers.NO_VALUE
    mesh = clers.make_mesh(faces, vertices, [clers.Attribute("texcoord", uv, "corner", indices)])
    back = clers.decode(clers.encode(mesh, order="keep"))
    assert (back.attribute("texcoord").indices == indices).all()
    assert (back.attribute("texcoord").values == uv).all()
    with pytest.raises(ValueError, match="no value"):
        back["texcoord"]


def test_precision():
    faces, vertices = grid(20, 30)
    normals = np.tile(np.float32([0.6, 0, 0.8]), (len(vertices), 1))
    mesh = clers.make_mesh(faces, vertices, [clers.Attribute("normal", normals)])
    data = clers.encode(mesh, precision={"position": 10, ("normal", "vertex"): clers.directions(8)})
    assert len(data) < len(clers.encode(mesh))
    told = {a.name: a for a in data.report[0].attributes}
    assert 0 < told["position"].error <= 1 / 1023 and told["normal"].measure == "angle"
    same(mesh, clers.make_mesh(faces, vertices, [clers.Attribute("normal", normals)]))
    back = clers.decode(data)
    assert np.abs(back.vertices - vertices[data.permutations[0].vertices]).max() <= told["position"].error * 1.000001
    for precision in (clers.error(1e-3), clers.step(1e-3), clers.grid([0, 0, 0], 1e-3), clers.lossless()):
        back = clers.decode(clers.encode(faces, vertices, precision={"position": precision}))
        same(clers.make_mesh(faces, vertices), back, position=1e-3)
    with pytest.raises(clers.Error, match="none of that name"):
        clers.encode(faces, vertices, precision={"colour": 8})


def test_parts_and_pieces():
    faces, vertices = grid(60, 70)
    heat = np.arange(len(faces), dtype=np.uint16)
    data = clers.encode(faces, vertices, attributes={"heat": heat}, piece_faces=2000, threads=2)
    decoder = clers.Decoder(data, threads=2)
    whole = decoder.decode(0)
    assert decoder.piece_count == decoder.info().meshes[0].pieces > 2
    numbers = 0
    for k in range(decoder.piece_count):
        piece = decoder.decode_piece(k)
        number = np.full(piece.mesh.vertex_count, -1)
        number[piece.seam_vertices] = piece.seam_numbers
        number[number < 0] = piece.first_vertex + np.arange((number < 0).sum())
        mine = slice(piece.first_face, piece.first_face + piece.mesh.face_count)
        assert (number[piece.mesh.faces] == whole.faces[mine]).all()
        assert (piece.mesh.vertices == whole.vertices[number]).all()
        assert (piece.mesh["heat"] == whole["heat"][mine]).all()
        numbers += piece.mesh.vertex_count - len(piece.seam_vertices)
    assert numbers == len(vertices)
    part = decoder.decode_part(0, faces=False, attributes=["heat"])
    assert len(part.corners) == 0 and (part["heat"] == whole["heat"]).all() and "position" not in part
    assert (decoder.decode_part(0).faces == whole.faces).all()
    with pytest.raises(KeyError):
        decoder.decode_part(0, attributes=["cold"])
    with pytest.raises(IndexError):
        decoder.decode_part(1)


def test_shapes_and_counts():
    faces, vertices = grid(9, 9)
    data = clers.encode(faces, vertices)
    seen = clers.inspect(data)
    shape = seen.meshes[0].shape
    assert (shape.components, shape.boundary_curves, shape.genus) == (1, 1, 0)
    assert sum(seen.meshes[0].counts.symbols.values()) == len(faces)
    assert data.counts[0].symbols == seen.meshes[0].counts.symbols
    assert clers.measure(clers.decode(data)).triangles == len(faces)


@pytest.mark.parametrize("ending", ["clers", "ply", "obj", "off", "stl"])
def test_files(tmp_path, ending):
    faces, vertices = grid(6, 7)
    mesh = clers.make_mesh(faces, vertices)
    path = tmp_path / f"m.{ending.upper()}"
    clers.write(path, mesh)
    same(mesh, clers.read(path))
    assert os.listdir(tmp_path) == [path.name]


def test_notes():
    faces, vertices = grid(3, 3)
    notes = []
    clers.write_bytes(clers.make_mesh(faces, vertices, {"heat": np.arange(9.0)}), "stl", notes=notes)
    assert any(n.loss for n in notes)


CORPUS = os.environ.get("CLERS_CORPUS", "")
FILES = sorted(f for f in os.listdir(CORPUS) if f.endswith((".ply", ".obj", ".off", ".stl"))) if CORPUS else []


@pytest.mark.corpus
@pytest.mark.parametrize("name", FILES)
def test_corpus(name):
    mesh = clers.read(os.path.join(CORPUS, name))
    level = 9 if mesh.face_count < 2000 else 3
    kept = clers.decode(clers.encode(mesh, level=level, order="keep", threads=2))
    assert kept.corners.tobytes() == mesh.corners.astype(np.uint32).tobytes()
    for a, b in zip(mesh.attributes, kept.attributes):
        assert (a.name, a.domain, a.values.tobytes()) == (b.name, b.domain, b.values.tobytes())
    same(mesh, clers.decode(clers.encode(mesh, level=level)))
