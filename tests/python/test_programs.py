"""Functions make what the programs make, byte for byte, and take no longer."""

import csv
import json
import os
import subprocess
import sys
import threading
import time
import warnings

import numpy as np
import pytest
import transformesh as tm
from programs import BUILD, run, same, shape


@pytest.fixture(scope="module")
def crossing():
    return shape("folded", "--faces", 3000, "--noise", "60%")


@pytest.mark.parametrize(
    "options, words",
    [
        ({}, []),
        ({"outermost": True}, ["--outermost"]),
        ({"merge_flat": True}, ["--merge-flat"]),
        ({"level": 2}, ["--level", 2]),
        ({"method": "static"}, ["--method", "static"]),
        ({"separate": "0.01x"}, ["--separate", "0.01x"]),
        ({"source": True, "source_face": True}, ["--source", "--source-face"]),
        ({"box": [-9, -9, -9, 9, 9, 0]}, ["--box", "-9,-9,-9,9,9,0"]),
        ({"box": [(0, -9, -9), (9, 9, 9)], "only": True}, ["--box", "0,-9,-9,9,9,9", "--only"]),
    ],
)
def test_clean(crossing, options, words, tmp_path):
    cleaned = tm.clean(tm.parse(crossing), **options)
    words += ["--report", tmp_path / "report"]
    assert same(cleaned, "tm-clean", *words, stdin=crossing)
    report = json.loads((tmp_path / "report").read_text())["result"]
    # A separation changes the mesh in the program's eyes.
    cleaned.report["changed"] |= cleaned.report["separated_vertices"] > 0
    assert cleaned.report == {key: report[key] for key in cleaned.report}
    assert ("box" in options) == ("box_faces" in cleaned.report)


@pytest.mark.parametrize(
    "options, words",
    [
        ({}, []),
        ({"smooth": 0.1, "iterations": 3}, ["--smooth", 0.1, "--iterations", 3]),
        ({"min_edge": "0.5x", "max_edge": 0.2}, ["--min-edge", "0.5x", "--max-edge", 0.2]),
        ({"adaptive": "0.1%"}, ["--adaptive", "0.1%"]),
        ({"flip": "angle", "smooth": "none"}, ["--flip", "angle", "--smooth", "none"]),
        ({"only": "smooth", "project": True}, ["--only", "smooth", "--project"]),
        ({"smooth": (0.5, 0.2)}, ["--smooth2", "0.5,0.2"]),
        ({"source": True}, ["--source"]),
        ({"curved": True}, ["--curved"]),
        ({"curved": True, "smooth": "tangential"}, ["--curved", "--smooth", "tangential"]),
        ({"curved": True, "flip": "valence"}, ["--curved", "--flip", "valence"]),
        ({"min_film": "0.3x", "pinch": "6x"}, ["--min-film", "0.3x", "--pinch", "6x"]),
    ],
)
def test_remesh(options, words):
    ball = shape("dented", "--faces", 2000)
    assert same(tm.remesh(tm.parse(ball), **options), "tm-remesh", *words, stdin=ball)


@pytest.mark.parametrize(
    "angle, words, kept",
    [
        ("auto", [], 40),
        (180, ["--feature-angle", 180], 180),
        (20, ["--feature-angle", 20], 20),
    ],
)
def test_feature_angle(angle, words, kept):
    box = shape("box", 1, 1, 3, "--faces", 1000)
    result = tm.remesh(tm.parse(box), feature_angle=angle)
    assert same(result, "tm-remesh", *words, stdin=box)
    assert result.report["feature_angle"] == kept
    with pytest.raises(tm.UsageError, match="feature_angle"):
        tm.remesh(tm.parse(box), feature_angle="sharp")


def test_joins_places(tmp_path):
    ball = tm.shape("sphere", faces=500)
    corners = np.arange(3 * len(ball.faces))
    soup = tm.Mesh(ball.positions[ball.faces.ravel()], corners.reshape(-1, 3))
    path = tmp_path / "soup.ply"
    tm.write(soup, path)
    for function, words in [
        (tm.remesh, ["tm-remesh"]),
        (lambda mesh: tm.decimate(mesh, 200), ["tm-remesh", "--faces", 200]),
        (tm.fill, ["tm-fill"]),
        (tm.handles, ["tm-handles"]),
        (lambda mesh: tm.offset(mesh, 0.2), ["tm-offset", "--distance", 0.2]),
    ]:
        with pytest.warns(UserWarning, match="vertices joined with others in the same place"):
            result = function(tm.read(path))
        assert same(result, *words, stdin=path.read_bytes())
        assert result.report["joined_vertices"] == len(corners) - len(ball.positions)
    with pytest.raises(tm.InputError, match=r"; join them with stitch\(\)$") as refusal:
        tm.displace(soup, normal_speed=0.1)
    assert refusal.value.kind == "not_joined"
    assert refusal.value.data["counts"] == [len(corners)]


def test_decimate():
    ball = shape("torus", "--faces", 3000)
    assert same(tm.decimate(tm.parse(ball), 500), "tm-remesh", "--faces", 500, stdin=ball)
    close = tm.decimate(tm.parse(ball), error="0.2%")
    assert same(close, "tm-remesh", "--error", "0.2%", stdin=ball)
    assert 0 < close.report["error_bound"] <= 0.002 * np.linalg.norm(np.ptp(tm.parse(ball).positions, axis=0))
    both = ["tm-remesh", "--error", 0.1, "--faces", 1000]
    assert same(tm.decimate(tm.parse(ball), 1000, error=0.1), *both, stdin=ball)


@pytest.fixture(scope="module")
def kernel():
    """A ball in the torus's hole."""
    return tm.shape("sphere", radius=0.5, faces=1000)


KEPT = [
    ("remesh", {"max_edge": 0.5}, ["tm-remesh", "--max-edge", 0.5], "kept_out"),
    ("decimate", {"faces": 300}, ["tm-remesh", "--faces", 300], "kept_out"),
    ("displace", {"normal_speed": 0.1}, ["tm-displace", "--normal-speed", 0.1], "held_back"),
]


@pytest.mark.parametrize("function, options, words, refused", KEPT)
def test_keep_out(kernel, function, options, words, refused, tmp_path):
    torus = shape("torus", "--faces", 2000)
    tm.write(kernel, tmp_path / "kernel.ply")
    kept = getattr(tm, function)(tm.parse(torus), **options, keep_out=kernel, gap=0.03)
    words = words + ["--keep-out", tmp_path / "kernel.ply", "--gap", 0.03]
    assert same(kept, *words, stdin=torus)
    assert kept.report[refused] > 0
    assert len(tm.intersect(tm.cat(kept, kernel))) == 0


def test_remesh_aligned(tmp_path):
    box = shape("box", "--faces", 1500)
    (tmp_path / "box.ply").write_bytes(box)
    blunt = tm.remesh(tm.parse(box), iterations=5, smooth=0.5, feature_angle=180).to_bytes()
    sharp = tm.remesh(tm.parse(blunt), align=tm.parse(box), source=True)
    assert same(sharp, "tm-remesh", "--align", tmp_path / "box.ply", "--source", stdin=blunt)
    assert sharp.report["corners"] == 8
    assert tm.info(sharp)["volume"] > tm.info(tm.parse(blunt))["volume"]
    with pytest.raises(tm.UsageError, match="align aligns and project remeshes"):
        tm.remesh(tm.parse(blunt), align=tm.parse(box), project=True)


def test_carry(crossing, tmp_path):
    first = tm.parse(crossing)
    first.vertex_columns["height"] = first.positions[:, 2].copy()
    first.face_columns["label"] = np.arange(len(first.faces), dtype=np.int32)
    between = tm.clean(first, source=True)
    del between.face_columns["label"]
    last = tm.remesh(between, iterations=2, source=True)
    for name, mesh in [("first", first), ("between", between), ("last", last)]:
        tm.write(mesh, tmp_path / f"{name}.ply")
    words = ["--from", tmp_path / "first.ply", tmp_path / "between.ply", tmp_path / "last.ply"]
    carried = tm.carry(first, between, last)
    assert same(carried, "tm-carry", *words, stdin=b"")
    assert carried.report == {"vertex_columns": 1, "face_columns": 1}
    words += ["--columns", "label", "--closest"]
    near = tm.carry(first, tm.Mesh(last.positions, last.faces), columns=["label"], closest=True)
    assert near.report == {"vertex_columns": 0, "face_columns": 1}
    assert same(tm.carry(first, between, last, columns=["label"], closest=True), "tm-carry", *words, stdin=b"")
    with pytest.raises(tm.InputError, match="mesh 2 has no source points of its vertices and faces"):
        tm.carry(first, tm.Mesh(last.positions, last.faces))


def test_stitch(crossing, tmp_path):
    (tmp_path / "soup.ply").write_bytes(crossing)
    run("tm-convert", "-o", tmp_path / "soup.stl", tmp_path / "soup.ply")
    soup = (tmp_path / "soup.stl").read_bytes()
    with pytest.warns(UserWarning):
        mesh = tm.read(tmp_path / "soup.stl")
    expected = run("tm-stitch", "--no-provenance", "--flip", "--format", "ply", stdin=soup)
    assert tm.stitch(mesh, flip=True).to_bytes(format="ply") == expected


def test_cat(crossing, tmp_path):
    ball = shape("sphere", "--faces", 100)
    (tmp_path / "ball.ply").write_bytes(ball)
    both = tm.cat(tm.parse(crossing), tm.parse(ball))
    assert same(both, "tm-cat", "-", tmp_path / "ball.ply", stdin=crossing)


def test_displace(crossing):
    moved = tm.displace(tm.parse(crossing), normal_speed="1%", curvature_speed=0.01, alpha=0.3)
    words = ["--normal-speed", "1%", "--curvature-speed", 0.01, "--alpha", 0.3]
    assert same(moved, "tm-displace", *words, stdin=crossing)


def test_displace_masked(crossing):
    mesh = tm.parse(crossing)
    mesh.vertex_columns["free"] = (mesh.positions[:, 0] > 0).astype(float)
    moved = tm.displace(mesh, normal_speed=0.01, mask="free")
    assert same(moved, "tm-displace", "--normal-speed", 0.01, "--mask", "free", stdin=mesh.to_bytes())


def test_displace_by_velocities_is_that_by_columns():
    mesh = tm.shape("sphere", faces=500)
    velocities = np.random.default_rng(1).normal(size=mesh.positions.shape) * 0.01
    moved = tm.displace(mesh, velocities)
    for name, column in zip("xyz", velocities.T):
        mesh.vertex_columns["v" + name] = column
    assert np.array_equal(tm.displace(mesh).positions, moved.positions)


def test_offset():
    box = shape("box", "--faces", 300)
    assert same(tm.offset(tm.parse(box), "5%"), "tm-offset", "--distance", "5%", stdin=box)


def test_mitered_offset():
    box = shape("box", "--faces", 300)
    mitered = tm.offset(tm.parse(box), 0.1, miter=True)
    assert same(mitered, "tm-offset", "--miter", "--distance", 0.1, stdin=box)
    before = tm.info(tm.parse(box))
    sides = np.subtract(before["bbox_max"], before["bbox_min"])
    assert tm.info(mitered)["volume"] == pytest.approx(np.prod(sides + 0.2))


def sheet():
    box = tm.parse(shape("box", 2, 2, 1))
    return tm.select(box, where=(box.positions[box.faces][:, :, 2] > 0.49).all(axis=1))


def test_thicken():
    solid = tm.thicken(sheet(), 0.1)
    assert same(solid, "tm-offset", "--thicken", 0.1, stdin=sheet().to_bytes())
    assert tm.info(solid)["volume"] == pytest.approx(2 * 2 * 0.1)


@pytest.mark.parametrize("cap", [False, True])
def test_cut(cap):
    ball = shape("sphere", "--faces", 2000)
    words = ["--plane", "0,0,1,0.5"] + (["--cap"] if cap else [])
    part = tm.cut(tm.parse(ball), (0, 0, 1, 0.5), cap=cap)
    assert same(part, "tm-select", *words, stdin=ball)
    assert part.positions[:, 2].min() == pytest.approx(0.5)
    with pytest.raises(tm.UsageError, match="plane"):
        tm.cut(part, (0, 0, 1))


def test_section():
    segments = tm.section(tm.shape("sphere", faces=5000), (0, 0, 1, 0.5))
    assert segments.shape[1:] == (2, 3)
    assert np.allclose(segments[:, :, 2], 0.5)
    length = np.linalg.norm(segments[:, 0] - segments[:, 1], axis=1).sum()
    assert length == pytest.approx(2 * np.pi * 0.75**0.5, rel=0.01)


def test_capped_sheet(tmp_path):
    ball = shape("sphere", "--radius", 0.8, "--faces", 2000)
    (tmp_path / "ball.ply").write_bytes(ball)
    words = ["cut", "--inside", "--cap", "-", tmp_path / "ball.ply"]
    below = tm.boolean("cut", sheet(), tm.parse(ball), inside=True, cap=True)
    assert same(below, "tm-boolean", *words, stdin=sheet().to_bytes())
    with pytest.raises(tm.UsageError, match="cap"):
        tm.boolean("union", below, cap=True)


@pytest.fixture(scope="module")
def holes():
    """A torus without two patches of faces, and so with two holes."""
    mesh = tm.parse(shape("torus", "--faces", 2000))
    x = mesh.positions[mesh.faces][:, :, 0].min(axis=1)
    keep = (x < 0.9 * x.max()) & (x > 0.9 * x.min())
    return tm.select(mesh, where=keep).to_bytes()


@pytest.mark.parametrize(
    "options, words",
    [
        ({}, []),
        ({"fair": False}, ["--no-fair"]),
        ({"refine": False}, ["--no-refine"]),
        ({"allow_crossings": True, "max_edges": 3}, ["--allow-crossings", "--max-edges", 3]),
        ({"max_diameter": "1%"}, ["--max-diameter", "1%"]),
    ],
)
def test_fill(holes, options, words, tmp_path):
    filled = tm.fill(tm.parse(holes), **options)
    words += ["--report", tmp_path / "report"]
    assert same(filled, "tm-fill", *words, stdin=holes)
    assert filled.report == json.loads((tmp_path / "report").read_text())["result"]
    assert filled.report["holes"] == 2
    assert filled.report["filled"] == (0 if "max_edges" in options or "max_diameter" in options else 2)


def test_align(tmp_path):
    ball = shape("dented", "--faces", 3000)
    turned = tm.transform(tm.parse(ball), rotate=(1, 2, 3, 15), translate=(0.1, 0, 0))
    tm.write(turned, tmp_path / "turned.ply")
    (tmp_path / "ball.ply").write_bytes(ball)
    words = ["--reference", tmp_path / "ball.ply", "--report", tmp_path / "report"]
    placed = tm.align(turned, tm.parse(ball))
    assert same(placed, "tm-align", *words, stdin=(tmp_path / "turned.ply").read_bytes())
    report = json.loads((tmp_path / "report").read_text())["result"]
    assert placed.report["matrix"].ravel().tolist() == report["matrix"]
    assert np.abs(placed.positions - tm.parse(ball).positions).max() < 1e-6


@pytest.mark.parametrize("operation", ["union", "intersection", "difference", "xor", "cut"])
def test_boolean(operation, tmp_path):
    ball, box = shape("sphere", "--faces", 2000), shape("box", 1, 1, 3, "--faces", 500)
    (tmp_path / "box.ply").write_bytes(box)
    options = {"source_operand": True, "merge_flat": False, "inside": operation == "cut"}
    combined = tm.boolean(operation, tm.parse(ball), tm.parse(box), **options)
    words = [operation, "-", tmp_path / "box.ply", "--source-operand", "--no-merge-flat", "--report", tmp_path / "report"]
    words += ["--inside"] if operation == "cut" else []
    assert same(combined, "tm-boolean", *words, stdin=ball)
    assert combined.report == json.loads((tmp_path / "report").read_text())["result"]
    assert set(combined.face_columns["source_operand"]) <= {0, 1}


def test_boolean_refuses():
    ball = tm.shape("sphere", faces=500)
    with pytest.raises(tm.UsageError, match="operation"):
        tm.boolean("sum", ball)
    with pytest.raises(tm.UsageError, match="at least one mesh"):
        tm.boolean("union")
    with pytest.raises(tm.InputError, match="mesh 1 has 1 border"):
        tm.boolean("union", ball, tm.Mesh(ball.positions, ball.faces[1:]))


@pytest.mark.parametrize("options, words", [({}, []), ({"keep_open": True}, ["--keep-open"])])
def test_repair(holes, options, words):
    repaired = tm.repair(tm.parse(holes), **options)
    assert same(repaired, "tm-repair", *words, stdin=holes)
    assert tm.info(repaired)["boundary_loops"] == (2 if options else 0)
    with pytest.raises(tm.GoalError, match="away from the input"):
        tm.repair(tm.parse(holes), max_change=1e-6)


@pytest.mark.parametrize(
    "name, options, words",
    [
        ("deformation", {"time": 0.5, "period": 2}, ["--time", 0.5, "--period", 2]),
        (
            "rotation",
            {"center": (1, 2, 3), "direction": (0, 1, 1), "speed": -2},
            ["--center", "1,2,3", "--direction", "0,1,1", "--speed=-2"],
        ),
        ("mean-curvature", {"span": 0.01}, ["--span", 0.01]),
    ],
)
def test_flow(name, options, words, tmp_path):
    ball = shape("sphere", "--faces", 500)
    moved = tm.flow(tm.parse(ball), name, **options)
    words += ["--report", tmp_path / "report"]
    assert same(moved, "tm-flow", name, *words, stdin=ball)
    assert moved.report == json.loads((tmp_path / "report").read_text())["result"]
    with pytest.raises(tm.UsageError, match="no parameter 'column'"):
        tm.flow(moved, name, column="vx")


def test_flow_of_a_grid(tmp_path):
    nodes = np.random.default_rng(1).normal(size=(2, 3, 4, 3)).astype("<f8")  # z, y, x, component
    header = "NRRD0004\ntype: double\ndimension: 4\nsizes: 3 4 3 2\nencoding: raw\nendian: little\n\n"
    path = tmp_path / "wind.nrrd"
    path.write_bytes(header.encode() + nodes.tobytes())
    corners = tm.Mesh([[0, 0, 0], [3, 2, 1], [1, 2, 0.5]], [[0, 1, 2]])
    blown = tm.flow(corners, "grid", grid=str(path))
    found = np.stack([blown.vertex_columns[axis] for axis in ("vx", "vy", "vz")], axis=1)
    middle = (nodes[0, 2, 1] + nodes[1, 2, 1]) / 2
    assert np.allclose(found, [nodes[0, 0, 0], nodes[1, 2, 3], middle])
    far = tm.Mesh([[0, 0, -9], [3, 2, 1], [1, 2, 0.5]], [[0, 1, 2]])
    with pytest.warns(UserWarning, match="1 vertex outside of the grid"):
        tm.flow(far, "grid", grid=str(path))


@pytest.mark.parametrize("options, words", [({}, []), ({"max_length": 3.5}, ["--max-length", 3.5])])
def test_handles(options, words, tmp_path):
    torus = shape("torus", "--faces", 2000)
    untied = tm.handles(tm.parse(torus), **options)
    words += ["--report", tmp_path / "report"]
    assert same(untied, "tm-handles", *words, stdin=torus)
    assert untied.report == json.loads((tmp_path / "report").read_text())["result"]
    assert untied.report["genus"] == (0 if options else 1)


@pytest.mark.parametrize(
    "options, words",
    [
        ({}, []),
        ({"translate": (1, 2, 3), "scale": 2}, ["--translate", "1,2,3", "--scale", 2]),
        ({"scale": 2, "translate": (1, 2, 3)}, ["--scale", 2, "--translate", "1,2,3"]),
        ({"rotate": (1, 2, 3, 40), "center": True}, ["--rotate", "1,2,3,40", "--center"]),
        ({"center": False, "unit_box": True}, ["--unit-box"]),
        ({"mirror": "y", "scale_axes": [1, 2, 3]}, ["--mirror", "y", "--scale-axes", "1,2,3"]),
        ({"mirror": (1, 1, 0, 2)}, ["--mirror", "1,1,0,2"]),
    ],
)
def test_transform(options, words, tmp_path):
    # Normals, velocities and a reference edge must follow the transformation.
    mesh = tm.remesh(tm.parse(shape("genus", 2, "--faces", 500)), min_edge="0.5x")
    for i, name in enumerate(["nx", "ny", "nz", "vx", "vy", "vz"]):
        mesh.vertex_columns[name] = np.sin(i + np.arange(len(mesh.positions)))
    words += ["--report", tmp_path / "report"]
    moved = tm.transform(mesh, **options)
    assert same(moved, "tm-transform", *words, stdin=mesh.to_bytes())
    report = json.loads((tmp_path / "report").read_text())["result"]
    assert np.array_equal(moved.report["matrix"].ravel(), report["matrix"])
    assert moved.report["mirrored"] == report["mirrored"]
    again = tm.transform(mesh, matrix=moved.report["matrix"])
    assert np.array_equal(again.positions, moved.positions)
    homogeneous = np.c_[mesh.positions, np.ones(len(mesh.positions))] @ moved.report["matrix"].T
    assert np.allclose(homogeneous[:, :3], moved.positions, atol=1e-12)


@pytest.fixture(scope="module")
def bodies():
    """A ball within a ball, a box, and a number for each face."""
    mesh = tm.cat(
        tm.shape("sphere", radius=3, faces=600),
        tm.shape("sphere", radius=1, faces=300),
        tm.transform(tm.shape("box", 4, 4, 4, faces=200), translate=(9, 0, 0)),
    )
    mesh.face_columns["label"] = np.arange(len(mesh.faces), dtype=np.int32) % 7
    return mesh.to_bytes()


@pytest.mark.parametrize(
    "options, words",
    [
        ({}, []),
        ({"largest": 2}, ["--largest", 2]),
        ({"largest": 1, "by": "volume"}, ["--largest", 1, "--by", "volume"]),
        ({"at_least": 90, "by": "area"}, ["--at-least", 90, "--by", "area"]),
        ({"where": "label >= 3", "invert": True}, ["--where", "label >= 3", "--invert"]),
        ({"box": [[-2, -2, -2], [2, 2, 2]]}, ["--box", "-2,-2,-2,2,2,2"]),
        ({"around": (0, 0, 2)}, ["--around", "0,0,2"]),
        ({"around": (0, 0, 20), "largest": 2}, ["--around", "0,0,20", "--largest", 2]),
    ],
)
def test_select(bodies, options, words, tmp_path):
    selected = tm.select(tm.parse(bodies), **options)
    words += ["--report", tmp_path / "report"]
    assert same(selected, "tm-select", *words, stdin=bodies)
    assert selected.report == json.loads((tmp_path / "report").read_text())["result"]


def test_select_where_an_array_is_true(bodies):
    mesh = tm.parse(bodies)
    by_array = tm.select(mesh, where=mesh.face_columns["label"] < 2)
    assert by_array.to_bytes() == tm.select(mesh, where="label<2").to_bytes()
    for mask in [[], [True]]:
        with pytest.raises(tm.InputError, match="the mask has"):
            tm.select(mesh, where=np.array(mask, dtype=bool))


def test_split(bodies, tmp_path):
    for by in ["faces", "volume"]:
        run("tm-select", "--no-provenance", "--by", by, "--split", tmp_path / by, stdin=bodies)
        parts = tm.split(tm.parse(bodies), by=by)
        files = sorted(tmp_path.glob(by + "-*.ply"))
        assert [part.to_bytes() for part in parts] == [file.read_bytes() for file in files]
        assert len(parts) == 3


@pytest.mark.parametrize(
    "options, words",
    [
        ({"count": 500}, ["--count", 500]),
        ({"distance": "5%", "seed": 3}, ["--distance", "5%", "--seed", 3]),
        ({"distance": 0.4}, ["--distance", 0.4]),
    ],
)
def test_sample(bodies, options, words):
    points = tm.sample(tm.parse(bodies), **options)
    assert same(points, "tm-sample", *words, stdin=bodies)
    assert points.report["points"] == len(points.positions) > 100
    assert len(points.faces) == 0 and "nx" in points.vertex_columns


def test_tiles_of_larger_meshes_are_refused():
    header = b"ply\nformat ascii 1.0\ncomment tm:tile 0 4\nelement vertex 3\nproperty double x\n"
    rest = (b"property double y\nproperty double z\nelement face 1\n"
            b"property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
    with pytest.raises(tm.InputError, match="is a tile of a larger mesh.*tm-tile join"):
        tm.parse(header + rest)
    mesh = tm.parse(header.replace(b"tm:tile", b"tile") + rest)
    assert len(mesh.faces) == 1


def test_refusals_are_exceptions_with_the_sentence_of_the_program(bodies):
    mesh = tm.parse(bodies)
    refused = [
        (tm.GoalError, "none of .* faces is selected", lambda: tm.select(mesh, box=[7] * 6)),
        (tm.InputError, "has no property 'size'", lambda: tm.select(mesh, where="size>1")),
        (tm.UsageError, "is no condition", lambda: tm.select(mesh, where="size")),
        (tm.UsageError, "faces, area or volume", lambda: tm.split(mesh, by="weight")),
        (tm.UsageError, "3 numbers are needed, not 2", lambda: tm.select(mesh, around=(1, 2))),
        (tm.UsageError, "the matrix is singular", lambda: tm.transform(mesh, scale=0)),
        (tm.UsageError, "translate: numbers", lambda: tm.transform(mesh, translate="far")),
        (tm.UsageError, "'w' is neither", lambda: tm.transform(mesh, mirror="w")),
        (tm.UsageError, "there is no 'turn'", lambda: tm.transform(mesh, turn=3)),
        (tm.GoalError, "", lambda: tm.transform(mesh, scale=1e308)),
        (tm.UsageError, "give either count", lambda: tm.sample(mesh)),
        (tm.UsageError, "give either count", lambda: tm.sample(mesh, 3, distance=1)),
        (tm.UsageError, "at least 3", lambda: tm.fill(mesh, max_edges=2)),
        (tm.UsageError, "no box is given", lambda: tm.clean(mesh, only=True)),
        (tm.UsageError, "outermost needs the whole mesh", lambda: tm.clean(mesh, box=range(6), outermost=True)),
        (tm.UsageError, "give both keep_out", lambda: tm.remesh(mesh, gap=1)),
        (tm.UsageError, "gap must be above 0", lambda: tm.decimate(mesh, 9, keep_out=mesh, gap=0)),
        (tm.UsageError, "give faces, error or both", lambda: tm.decimate(mesh)),
        (tm.UsageError, "0 are too few", lambda: tm.decimate(mesh, 0, error=0.1)),
        (tm.InputError, "nothing to keep", lambda: tm.displace(mesh, normal_speed=1, gap=1,
                                                              keep_out=tm.Mesh(np.zeros((3, 3))))),
        (tm.UsageError, "9999 velocities for 512 vertices",
         lambda: tm.displace(mesh, np.zeros((9999, 3)), normal_speed=1)),
        (tm.UsageError, "the first mesh", lambda: tm.carry(mesh)),
        (tm.UsageError, "'soft' is none of auto, on, off", lambda: tm.morph(mesh, mesh, features="soft")),
        (tm.InputError, "", lambda: tm.fill(tm.Mesh(np.zeros((3, 3)), [[0, 1, 2], [0, 1, 2]]))),
        (tm.InputError, "", lambda: tm.select(tm.Mesh(np.zeros((3, 3))), around=(0, 0, 0))),
    ]
    for error, sentence, call in refused:
        with pytest.raises(error, match=sentence):
            call()


def test_morph(tmp_path):
    target, source = shape("genus", 1, "--faces", 1500), None
    (tmp_path / "target.ply").write_bytes(target)
    source = shape("sphere", "--around", tmp_path / "target.ply", "--faces", 1500)
    words = ["--target", tmp_path / "target.ply", "--iterations", 12, "--no-provenance"]
    result = tm.morph(tm.parse(source), tm.parse(target), iterations=12)
    assert result.to_bytes() == run("tm-morph", *words, stdin=source)
    assert result.report["stop"] == "iteration_limit"


@pytest.mark.parametrize("features", ["auto", "on", "off"])
def test_morph_to_sharp_edges(features, tmp_path):
    target = shape("box", "--faces", 800)
    (tmp_path / "target.ply").write_bytes(target)
    source = shape("sphere", "--around", tmp_path / "target.ply", "--faces", 800)
    words = ["--target", tmp_path / "target.ply", "--features", features, "--no-provenance"]
    result = tm.morph(tm.parse(source), tm.parse(target), features=features)
    assert result.to_bytes() == run("tm-morph", *words, stdin=source)
    assert result.report["converged"]
    assert (result.report["aligned"] > 0) == (features != "off")


def test_morph_warns_of_what_makes_a_result_doubtful():
    ball = tm.shape("sphere", faces=300)
    far = tm.transform(ball, translate=(9, 0, 0))
    with pytest.warns(UserWarning, match="source"):
        tm.morph(ball, far, iterations=1)
    with pytest.raises(tm.InputError, match="inside out"):
        tm.morph(ball, tm.stitch(ball, flip=True))


def test_clamped_velocities():
    ball = tm.shape("sphere", faces=1000)

    def squeeze(mesh):  # without divergence: the volume stays
        return mesh.positions * (1, 1, -2)

    with pytest.warns(UserWarning, match="in 3 of 3 iterations.*smaller time_step and more iter.*larger alpha"):
        clamped = tm.evolve(ball, squeeze, iterations=3, time_step=0.03)
    assert clamped.report["clamped_iterations"] == 3
    assert 0 < clamped.report["clamped_share"] <= 1
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        free = tm.evolve(ball, squeeze, iterations=3, time_step=0.03, alpha=3, smooth="none")
    assert free.report["clamped_iterations"] == 0
    assert abs(tm.info(free)["volume"] / tm.info(ball)["volume"] - 1) < 0.02
    with pytest.warns(UserWarning, match="clamped to 0.2 of the mean edge"):
        tm.displace(ball, normal_speed=1)


def test_evolve(tmp_path):
    ball = shape("dumbbell", "--faces", 1500)

    def inwards(mesh):
        return tm.displace(mesh, normal_speed=-0.02, alpha=1e9).positions - mesh.positions

    # The displacement that a filter returns is that between its meshes.
    result = tm.evolve(tm.parse(ball), inwards, iterations=5)
    words = ["--iterations", 5, "--no-provenance"]
    step = os.path.join(BUILD, "bin", "tm-displace") + " --no-provenance --normal-speed -0.02"
    program = tm.parse(run("tm-evolve", *words, "--step", step, stdin=ball))
    assert len(result.faces) == len(program.faces)
    assert np.allclose(result.positions, program.positions, atol=1e-9)


@pytest.mark.parametrize(
    "options, words",
    [
        ({}, []),
        ({"integrator": "rk4", "max_move": 1.5}, ["--integrator", "rk4", "--max-move", 1.5]),
        ({"time_step": 0.07, "integrator": "euler"}, ["--time-step", 0.07, "--integrator", "euler"]),
        ({"tolerance": 1e-4, "keep_volume": True}, ["--tolerance", 1e-4, "--keep-volume"]),
    ],
)
def test_evolve_in_time(options, words, tmp_path):
    ball = shape("sphere", "--faces", 500, "--center", "1,0,0", "--double")

    def turn(mesh, time):
        x, y, z = mesh.positions.T
        return (1 + time) * np.stack([-y, x, 0 * z], axis=1)

    answer = r"""
import sys, numpy as np
source, sink = sys.stdin.buffer, sys.stdout.buffer
sink.write(b"ready\n"); sink.flush()
while line := source.readline():
    _, size, time, span, stage = line.split()
    head, body = source.read(int(size)).split(b"end_header\n", 1)
    count = int(head.split(b"element vertex ")[1].split()[0])
    x, y, z = np.frombuffer(body, "<f8", 3 * count).reshape(-1, 3).T
    v = (1 + float(time)) * np.stack([-y, x, 0 * z], axis=1)
    sink.write(b"velocities %d\n" % count + v.tobytes()); sink.flush()
"""
    script = tmp_path / "answer.py"
    script.write_text(answer)
    result = tm.evolve_in_time(tm.parse(ball), turn, 0.3, **options)
    words = [*words, "--time", 0.3, "--persistent", "--velocity", f"{sys.executable} {script}"]
    assert same(result, "tm-evolve", *words, stdin=ball)
    assert result.report["time"] == 0.3


def test_events_of_evolve_in_time(tmp_path):
    right = tm.transform(tm.shape("sphere", faces=500, radius=0.4), translate=(1, 0, 0))
    left = tm.Mesh(right.positions * [-1, 1, 1], right.faces[:, ::-1])
    # Mirror images at unit speed meet when their nearest vertices reach the plane between them.
    meeting = right.positions[:, 0].min()
    both = tm.cat(left, right)

    def inwards(mesh, time):
        return -np.sign(mesh.positions) * [1, 0, 0]

    result = tm.evolve_in_time(both, inwards, 0.7, event_tolerance=1e-3, events=True)
    (event,) = result.report["events"]
    assert event["kind"] == "merge"
    assert meeting <= event["time"] <= meeting + 1e-3
    assert np.allclose(event["place"], 0, atol=0.05) and event["size"] < 0.1
    volume = tm.info(right)["volume"]
    assert event["before"] == pytest.approx({1: volume, 2: volume}, rel=1e-3)
    assert list(event["after"]) == [1]
    assert event["after"][1] == pytest.approx(2 * volume, rel=1e-3)
    assert set(result.face_columns["component_label"]) == {1}

    script = tmp_path / "inwards.py"
    script.write_text(
        "import sys, transformesh as tm\n"
        "mesh = tm.parse(sys.stdin.buffer.read())\n"
        "for axis, name in enumerate(['vx', 'vy', 'vz']):\n"
        "    column = mesh.positions[:, axis]\n"
        "    mesh.vertex_columns[name] = -((column > 0) * 1.0 - (column < 0)) * (axis == 0)\n"
        "sys.stdout.buffer.write(mesh.to_bytes())\n"
    )
    words = ["--velocity", f"{sys.executable} {script}", "--events", tmp_path / "events.csv"]
    words += ["--time", 0.7, "--event-tolerance", 1e-3]
    assert same(result, "tm-evolve", *words, stdin=both.to_bytes())
    (row,) = csv.DictReader((tmp_path / "events.csv").open())
    assert float(row["time"]) == pytest.approx(event["time"], rel=1e-9)
    assert [float(row[axis]) for axis in "xyz"] == pytest.approx(event["place"], rel=1e-8, abs=1e-9)
    assert row["labels_before"] == "1 2" and row["labels_after"] == "1"
    assert "events" not in tm.evolve_in_time(right, inwards, 0.1).report


def test_compare_info_and_certify(crossing, tmp_path):
    cleaned = tm.clean(tm.parse(crossing))
    tm.write(cleaned, tmp_path / "cleaned.ply")
    (tmp_path / "crossing.ply").write_bytes(crossing)
    words = ["--reference", tmp_path / "crossing.ply", tmp_path / "cleaned.ply", "--json"]
    expected = json.loads(run("tm-compare", *words))
    found = tm.compare(cleaned, tm.parse(crossing))
    assert found == pytest.approx(expected, rel=1e-12)
    expected = json.loads(run("tm-info", "--json", tmp_path / "cleaned.ply"))
    found = tm.info(cleaned)
    assert {key: found[key] for key in expected if "bbox" not in key} == {
        key: value for key, value in expected.items() if "bbox" not in key
    }
    certificate = tm.certify(cleaned, tm.parse(crossing))
    assert certificate["holds"] and certificate["wrong"] == 0 and certificate["samples"] > 100
    assert not tm.certify(tm.shape("sphere", faces=500), tm.parse(crossing))["holds"]


def test_intersect(crossing, tmp_path):
    run("tm-intersect", "--pairs", tmp_path / "pairs", "-o", tmp_path / "out.ply", stdin=crossing)
    expected = np.loadtxt(tmp_path / "pairs", dtype=int)
    assert np.array_equal(tm.intersect(tm.parse(crossing)), expected)
    assert tm.intersect(tm.shape("sphere", faces=100)).shape == (0, 2)


def test_threads_make_no_difference(crossing):
    results = []
    for threads in [1, 2, 4]:
        tm.set_threads(threads)
        results.append(tm.clean(tm.parse(crossing)).to_bytes())
    tm.set_threads(0)
    assert results[0] == results[1] == results[2]
    with pytest.raises(tm.UsageError):
        tm.set_threads(-1)


def test_progress_is_told_and_cancels(crossing):
    told = []
    tm.clean(tm.parse(crossing), progress=lambda phase, fraction: told.append((phase, fraction)))
    assert len({phase for phase, _ in told}) > 1
    with pytest.raises(tm.Cancelled):
        tm.clean(tm.parse(crossing), progress=lambda phase, fraction: False)


def test_an_exception_of_a_callback_comes_through(crossing):
    def fails(*_):
        raise ZeroDivisionError("mine")

    with pytest.raises(ZeroDivisionError, match="mine"):
        tm.clean(tm.parse(crossing), progress=fails)
    with pytest.raises(ZeroDivisionError, match="mine"):
        tm.evolve(tm.shape("sphere", faces=100), fails, iterations=2)
    with pytest.raises(tm.InputError, match="velocities"):
        tm.evolve(tm.shape("sphere", faces=100), lambda mesh: np.zeros((3, 2)), iterations=2)
    with pytest.raises(tm.UsageError):
        tm.evolve(tm.shape("sphere", faces=100), lambda mesh: np.zeros((3, 3)), iterations=2)


def test_ctrl_c_ends_a_call(tmp_path):
    script = tmp_path / "long.py"
    script.write_text(
        "import transformesh as tm\n"
        "mesh = tm.shape('sphere', faces=20000)\n"
        "print('ready', flush=True)\n"
        "try:\n"
        "    tm.evolve(mesh, lambda now: 0 * now.positions, iterations=100000)\n"
        "except KeyboardInterrupt:\n"
        "    print('interrupted')\n"
    )
    import signal
    import sys

    process = subprocess.Popen([sys.executable, script], stdout=subprocess.PIPE, text=True)
    assert process.stdout.readline() == "ready\n"
    time.sleep(0.5)
    process.send_signal(signal.SIGINT)
    assert process.communicate(timeout=20)[0] == "interrupted\n"
    assert process.returncode == 0


def test_the_interpreter_goes_on_while_a_mesh_is_cleaned():
    mesh = tm.shape("folded", faces=100000)
    done = threading.Event()
    worker = threading.Thread(target=lambda: (tm.clean(mesh), done.set()))
    worker.start()
    turns = 0
    while not done.is_set():
        turns += 1
        time.sleep(0.001)
    worker.join()
    assert turns > 5
