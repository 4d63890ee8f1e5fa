"""Meshes as NumPy arrays: shared memory, checks, columns, files."""

import gc
import inspect
import pickle
import re
import sys
import warnings

import numpy as np
import pytest
import transformesh as tm
from transformesh._advice import advice

TETRAHEDRON = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], dtype=float)
FACES = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])


def tetrahedron():
    return tm.Mesh(TETRAHEDRON, FACES)


def test_arrays_are_the_memory_of_the_mesh():
    mesh = tetrahedron()
    before = tm.info(mesh)["volume"]
    mesh.positions[:] *= 2
    assert tm.info(mesh)["volume"] == pytest.approx(8 * before)
    mesh.faces[:] = mesh.faces[:, ::-1]
    assert tm.info(mesh)["volume"] == pytest.approx(-8 * before)
    assert np.shares_memory(mesh.positions, mesh.positions)


def test_an_array_keeps_its_mesh_alive():
    positions = tm.shape("sphere", faces=5000).positions
    gc.collect()
    filler = [np.ones(1000) for _ in range(100)]
    assert np.allclose(np.linalg.norm(positions, axis=1), np.linalg.norm(positions[0]))
    assert len(filler) == 100


@pytest.mark.parametrize("dtype", [np.int32, np.int64, np.uint32, np.uint64, np.int16])
def test_faces_of_any_integers(dtype):
    assert tm.info(tm.Mesh(TETRAHEDRON, FACES.astype(dtype)))["closed"]


def test_converted_arrays_are_read_from_the_copy():
    ball = tm.shape("sphere", faces=20000)
    mesh = tm.Mesh(np.round(1000 * ball.positions).astype(np.int32), ball.faces.astype(np.int16))
    assert (mesh.faces == ball.faces).all()
    assert (mesh.positions == np.round(1000 * ball.positions)).all()


def test_arrays_of_any_layout():
    columns = np.asfortranarray(TETRAHEDRON)
    every_other = np.repeat(TETRAHEDRON, 2, axis=0)[::2]
    for positions in [columns, every_other, TETRAHEDRON.tolist(), TETRAHEDRON.astype(np.float32)]:
        assert tm.info(tm.Mesh(positions, FACES[::1]))["volume"] == pytest.approx(1 / 6)


@pytest.mark.parametrize(
    "positions, faces, words",
    [
        (TETRAHEDRON[:, :2], FACES, "positions: an array of shape"),
        (TETRAHEDRON, [[0, 1, 4]], "face 0 has vertex index 4, but there are 4"),
        (TETRAHEDRON, [[0, 1, -1]], "face 0 has vertex index -1"),
        (TETRAHEDRON, [[0.0, 1.0, 2.0]], "integers"),
        (TETRAHEDRON, [0, 1, 2], "faces: an array of shape"),
        (TETRAHEDRON * np.nan, FACES, "vertex 0 has a coordinate that is not finite"),
    ],
)
def test_what_is_no_mesh_is_an_input_error(positions, faces, words):
    with pytest.raises(tm.InputError, match=words):
        tm.Mesh(positions, faces)


def test_columns_are_a_dict_of_arrays():
    mesh = tetrahedron()
    columns = mesh.vertex_columns
    columns["heat"] = np.arange(4.0)
    columns["red"] = np.array([1, 2, 3, 255], dtype=np.uint8)
    assert list(columns) == ["heat", "red"] and len(columns) == 2 and "heat" in columns
    assert dict(columns.items())["red"].dtype == np.uint8
    heat = columns["heat"]
    heat[0] = 7
    assert mesh.vertex_columns["heat"][0] == 7
    with pytest.raises(ValueError):
        columns["red"][0] = 1
    with pytest.raises(KeyError):
        columns["nothing"]
    assert columns.get("nothing") is None
    with pytest.raises(tm.InputError, match="an array of 4 numbers"):
        columns["short"] = np.arange(3)
    with pytest.raises(tm.InputError, match="2147483648"):
        columns["large"] = np.array([2**31, 0, 0, 0])
    del columns["heat"]
    assert heat[1] == 1 and list(columns) == ["red"]


def test_a_column_survives_a_file(tmp_path):
    mesh = tetrahedron()
    mesh.face_columns["label"] = np.array([3, 1, 4, 1], dtype=np.int32)
    tm.write(mesh, tmp_path / "a b=c.ply")
    read = tm.read(tmp_path / "a b=c.ply")
    assert read.face_columns["label"].tolist() == [3, 1, 4, 1]
    assert np.array_equal(read.positions, mesh.positions)


def test_formats_follow_the_name_or_the_word(tmp_path):
    mesh = tetrahedron()
    for name, start in [("t.off", b"OFF"), ("t.obj", b"v "), ("t.stl", None), ("t.ply", b"ply")]:
        tm.write(mesh, tmp_path / name)
        assert start is None or (tmp_path / name).read_bytes().startswith(start)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            assert tm.info(tm.stitch(tm.read(tmp_path / name)))["closed"]
    tm.write(mesh, tmp_path / "text.ply", format="ply-ascii", scalar="float")
    assert b"property float x" in (tmp_path / "text.ply").read_bytes()


def test_comments_are_kept_whatever_their_bytes(tmp_path):
    mesh = tetrahedron()
    mesh.comments = ["made by hand", "gr\udcfc\udcdf"]
    assert b"comment gr\xfc\xdf" in mesh.to_bytes()
    assert tm.parse(mesh.to_bytes()).comments == mesh.comments


def test_copies_and_pickles_are_meshes_of_their_own():
    mesh = tm.shape("torus", faces=500)
    for other in [mesh.copy(), pickle.loads(pickle.dumps(mesh)), tm.parse(mesh.to_bytes())]:
        assert np.array_equal(other.positions, mesh.positions)
        other.positions[:] = 0
    assert np.abs(mesh.positions).max() > 0


def test_what_reading_changes_is_a_warning(tmp_path):
    (tmp_path / "square.off").write_text("OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n")
    with pytest.warns(UserWarning):
        assert len(tm.read(tmp_path / "square.off").faces) == 2


def test_errors_have_four_types_and_the_programs_sentences(tmp_path):
    (tmp_path / "bad.off").write_text("OFF\n1 1 0\n0 0 0\n3 0 1 2\n")
    with pytest.raises(tm.InputError, match="face 0 has vertex index 1, but there is 1 vertex"):
        tm.read(tmp_path / "bad.off")
    with pytest.raises(tm.UsageError, match="method"):
        tm.clean(tetrahedron(), method="best")
    with pytest.raises(tm.GoalError, match="enclose nothing|winding number"):
        tm.clean(tm.stitch(tetrahedron(), flip=True))
    with pytest.raises(tm.OutputError):
        tm.write(tetrahedron(), tmp_path / "nowhere" / "t.ply")
    assert issubclass(tm.InputError, ValueError) and issubclass(tm.OutputError, OSError)
    assert issubclass(tm.GoalError, tm.Error)


def test_no_warning_where_nothing_is_changed(tmp_path):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        tm.write(tetrahedron(), tmp_path / "t.ply")
        tm.read(tmp_path / "t.ply")


def test_references_are_not_leaked():
    mesh = tetrahedron()
    before = sys.getrefcount(mesh)
    for _ in range(100):
        mesh.positions, mesh.vertex_columns, tm.info(mesh)
    assert sys.getrefcount(mesh) == before


def test_functions_and_arguments_in_remedies_exist():
    remedies = advice.values()
    functions = {name: getattr(tm, name) for name in tm.__all__ if inspect.isfunction(getattr(tm, name))}
    signatures = {name: f"{inspect.signature(function)} {function.__doc__}" for name, function in functions.items()}
    named = {name for text in remedies for name in re.findall(r"(\w+)\(", text)}
    assert {"fill", "stitch", "clean", "transform"} <= named <= signatures.keys()
    for text in remedies:
        for name, arguments in re.findall(r"(\w+)\(([^)]*)\)", text):
            for keyword in re.findall(r"(\w+)=", arguments):
                assert re.search(rf"\b{keyword}[:=]", signatures[name]), text
        for keyword in re.findall(r"(\w+)=", text):
            assert any(re.search(rf"\b{keyword}[:=]", signature) for signature in signatures.values()), text
