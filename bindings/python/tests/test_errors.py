"""Errors say what and where; any bytes are an error or a mesh; the GIL is free meanwhile."""

import pickle
import threading

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import clers
from shapes import grid

GOOD = clers.encode(*grid(12, 13), attributes={"heat": np.arange(156, dtype=np.uint16)})


def test_codes_and_places():
    faces, vertices = grid(3, 3)
    faces[2, 1] = 9
    with pytest.raises(clers.Error) as caught:
        clers.encode(faces, vertices)
    error = caught.value
    assert (error.code, error.place, error.at) == ("inconsistent_mesh", "corner", 7) or error.place in str(error)
    again = pickle.loads(pickle.dumps(error))
    assert str(again) == str(error) and (again.code, again.at) == (error.code, error.at)
    with pytest.raises(clers.Error) as caught:
        clers.decode(GOOD[:50])
    assert caught.value.code == "truncated" and caught.value.place == "byte"
    with pytest.raises(clers.Error) as caught:
        clers.decode(GOOD, limits={"vertices": 100})
    assert (caught.value.code, caught.value.limited, caught.value.needed) == ("limit", "vertices", 156)
    with pytest.raises(clers.Error) as caught:
        clers.encode([[0, 1, 1]], reject="degenerate")
    assert caught.value.code == "degenerate_face" and caught.value.at == 0
    with pytest.raises(clers.Error) as caught:
        clers.read_bytes(b"ply\nformat ascii 1.0\nelement vertex x\n", "ply")
    assert caught.value.code == "malformed" and caught.value.place == "line"


def test_options():
    for wrong, kind in (({"level": 10}, clers.Error), ({"order": "kept"}, ValueError), ({"reject": "holes"}, ValueError),
                        ({"piece_faces": 0}, clers.Error), ({"precision": {"position": 31}}, clers.Error)):
        with pytest.raises(kind):
            clers.encode(*grid(3, 3), **wrong)
    with pytest.raises(ValueError, match="corners"):
        clers.Decoder(GOOD, limits={"corners": 1})


@settings(max_examples=150, deadline=None)
@given(st.integers(0, len(GOOD) - 1), st.integers(1, 255), st.booleans())
def test_hostile_bytes(at, flip, cut):
    data = GOOD[:at] if cut else GOOD[:at] + bytes([GOOD[at] ^ flip]) + GOOD[at + 1:]
    with pytest.raises(clers.Error):
        clers.decode(data)
    with pytest.raises(clers.Error):
        clers.inspect(data)


@settings(max_examples=100, deadline=None)
@given(st.binary(max_size=200), st.sampled_from(["ply", "obj", "off", "stl"]))
def test_any_bytes(data, format):
    for read in (clers.decode, lambda d: clers.read_bytes(d, format)):
        try:
            read(data)
        except clers.Error as error:
            assert error.code and str(error)


def test_buffers():
    for data in (bytes(GOOD), bytearray(GOOD), memoryview(GOOD), np.frombuffer(GOOD, np.uint8)):
        assert clers.decode(data).vertex_count == 156
    with pytest.raises((BufferError, ValueError, TypeError)):
        clers.decode(memoryview(GOOD)[::2])


def test_progress_ends_the_work():
    seen = []

    def stop(stage, done):
        seen.append(done)
        raise KeyError(stage)

    with pytest.raises(KeyError):
        clers.encode(*grid(50, 50), progress=stop)
    assert len(seen) == 1
    seen.clear()
    data = clers.encode(*grid(50, 50), progress=lambda stage, done: seen.append(done))
    assert seen == sorted(seen) and seen[-1] == 1.0
    clers.decode(data, progress=lambda stage, done: seen.append(done))


def test_other_threads_run():
    """While one thread encodes, another counts: it could not if the GIL were held."""
    faces, vertices = grid(300, 300)
    done = threading.Event()
    worker = threading.Thread(target=lambda: (clers.encode(faces, vertices), done.set()))
    worker.start()
    turns = 0
    while not done.is_set():
        turns += 1
    worker.join()
    assert turns > 1000


def test_one_decoder_in_two_threads():
    decoder = clers.Decoder(GOOD)
    results = []
    threads = [threading.Thread(target=lambda: results.append(decoder.decode(0).vertices.tobytes())) for _ in range(4)]
    for t in threads:
        t.start()
    for t in threads:
        t.join()
    assert len(results) == 4 and len(set(results)) == 1
