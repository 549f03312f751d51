"""Folders and giant meshes by workers: the bytes of one machine, whatever dies on the way."""

import contextlib
import glob
import os
import signal
import threading
import time

import numpy as np
import pytest

import clers
pytest.importorskip("distributed")
from clers import distributed
from clers.distributed import _cluster, _folder, _giant
from shapes import grid

pytestmark = pytest.mark.distributed


@pytest.fixture(scope="module", params=[1, 2])
def client(request):
    with distributed.connect(workers=request.param) as client:
        yield client


@pytest.fixture
def folder(tmp_path):
    os.makedirs(tmp_path / "in" / "deep")
    for i in range(12):
        faces, vertices = grid(30 + i, 30)
        clers.write(tmp_path / "in" / ("deep" if i % 3 == 0 else "") / f"m{i}.{['ply', 'obj', 'off'][i % 3]}",
                    clers.make_mesh(faces, vertices))
    (tmp_path / "in" / "bad.ply").write_bytes(b"ply\nnothing\n")
    (tmp_path / "in" / "readme.txt").write_text("no mesh")
    return str(tmp_path / "in"), str(tmp_path / "out")


def check_folder(source, target, **options):
    outputs = glob.glob(target + "/**/*.clers", recursive=True)
    assert len(outputs) == 12
    for output in outputs:
        path = os.path.join(source, os.path.relpath(output, target)[:-len(".clers")])
        with open(output, "rb") as file:
            assert file.read() == clers.encode(clers.read(path), **options)
    assert not glob.glob(target + "/**/*.part", recursive=True)


def test_folder(client, folder):
    source, target = folder
    result = distributed.encode_folder(source, target, scheduler=client, level=3)
    assert len(result.encoded) == 12 and list(result.failed) == ["bad.ply"] and not result.kept
    check_folder(source, target, level=3)
    os.remove(os.path.join(target, result.encoded[4] + ".clers"))
    os.utime(os.path.join(source, result.encoded[7]), ns=(1, 1))
    with open(os.path.join(target, _folder.MANIFEST), "a") as file:
        file.write('{"name": "cut of')  # as a crash leaves it
    again = distributed.encode_folder(source, target, scheduler=client, level=3)
    assert again.encoded == sorted([result.encoded[4], result.encoded[7]]) and len(again.kept) == 10
    check_folder(source, target, level=3)
    other = distributed.encode_folder(source, target, scheduler=client, level=1)
    assert len(other.encoded) == 12
    check_folder(source, target, level=1)


def test_giant(client, tmp_path):
    faces, vertices = grid(120, 110)
    mesh = clers.make_mesh(faces, vertices, {"heat": np.arange(len(faces), dtype=np.uint16)}, name="wave",
                           metadata={"source": b"a test"})
    options = dict(level=5, piece_faces=3000, precision={"position": 12})
    target = str(tmp_path / "m.clers")
    order = distributed.encode_mesh(mesh, target, scheduler=client, **options)
    expected = clers.encode(mesh, **options)
    with open(target, "rb") as file:
        assert file.read() == expected
    assert all((a == b).all() for a, b in zip(order, expected.permutations[0]))
    assert os.listdir(tmp_path) == ["m.clers"]
    distributed.encode_mesh(mesh, target, scheduler=client, level=5)
    with open(target, "rb") as file:
        assert file.read() == clers.encode(mesh, level=5)


def kill_one(client, when):
    """Kills a worker, once `when` is true, and says whether it did."""
    pids = list(client.run(os.getpid).values())
    killed = []

    def wait_and_kill():
        while not when():
            time.sleep(0.005)
        os.kill(pids[0], signal.SIGKILL)
        killed.append(pids[0])

    thread = threading.Thread(target=wait_and_kill, daemon=True)
    thread.start()
    return thread, killed


def test_killed_worker_of_a_folder(folder):
    source, target = folder
    with distributed.connect(workers=2) as client:
        thread, killed = kill_one(client, lambda: len(glob.glob(target + "/*.clers")) >= 2)
        result = distributed.encode_folder(source, target, scheduler=client, level=9)
        thread.join(10)
    assert killed and len(result.encoded) == 12
    check_folder(source, target, level=9)


def test_killed_worker_of_a_giant(tmp_path):
    mesh = clers.make_mesh(*grid(140, 140))
    target = str(tmp_path / "m.clers")
    options = dict(level=9, piece_faces=3000)
    with distributed.connect(workers=2) as client:
        thread, killed = kill_one(client, lambda: len(glob.glob(target + ".parts/*.piece")) >= 1)
        distributed.encode_mesh(mesh, target, scheduler=client, **options)
        thread.join(10)
    assert killed
    with open(target, "rb") as file:
        assert file.read() == clers.encode(mesh, **options)


def test_giant_goes_on(tmp_path, monkeypatch):
    """The job is ended in the middle, one of its pieces is damaged, and it is started again."""
    mesh = clers.make_mesh(*grid(100, 100))
    target = str(tmp_path / "m.clers")
    options = dict(level=5, piece_faces=2500)
    done = []

    def here(client, work, jobs, most):
        for job in jobs:
            yield work(*job)
            done.append(job[0])

    class Ended(Exception):
        pass

    def ended(client, work, jobs, most):
        for i, result in enumerate(here(client, work, jobs, most)):
            if i == 3:
                raise Ended
            yield result

    monkeypatch.setattr(_giant, "connect", lambda *_: contextlib.nullcontext())
    monkeypatch.setattr(_giant, "threads_of", lambda _: 1)
    monkeypatch.setattr(_giant, "run", ended)
    with pytest.raises(Ended):
        distributed.encode_mesh(mesh, target, **options)
    assert not os.path.exists(target)
    done.clear()
    pieces = glob.glob(target + ".parts/*.piece")
    assert len(pieces) == 3
    with open(target + ".parts/1.piece", "r+b") as file:
        file.seek(100)
        file.write(b"damaged")
    monkeypatch.setattr(_giant, "run", here)
    distributed.encode_mesh(mesh, target, **options)
    assert 1 in done and 0 not in done and 2 not in done
    with open(target, "rb") as file:
        assert file.read() == clers.encode(mesh, **options)


def test_wrong_arguments(tmp_path):
    with pytest.raises(ValueError, match="order"):
        distributed.encode_folder(str(tmp_path), str(tmp_path / "out"), order="kept")


def test_bar(capsys):
    bar = _cluster.Bar(True, 4)
    bar.show(2, "files")
    bar.show(4, "files")
    assert "2/4 files" in capsys.readouterr().err
