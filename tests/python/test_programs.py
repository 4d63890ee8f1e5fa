"""Functions make what the programs make, byte for byte, and take no longer."""

import json
import os
import subprocess
import threading
import time

import numpy as np
import pytest
import transformesh as tm

BUILD = os.environ.get("TM_BUILD", os.path.join(os.path.dirname(__file__), "../../build"))


def run(program, *words, stdin=b""):
    path = os.path.join(BUILD, "bin", program)
    return subprocess.run([path, *map(str, words)], input=stdin, check=True, capture_output=True).stdout


def shape(*words):
    return run("tm-shape", "--no-provenance", *words)


@pytest.fixture(scope="module")
def crossing():
    return shape("folded", "--faces", 3000, "--noise", "60%")


def same(mesh, program, *words, stdin):
    return mesh.to_bytes() == run(program, "--no-provenance", *words, stdin=stdin)


@pytest.mark.parametrize(
    "options, words",
    [
        ({}, []),
        ({"outermost": True}, ["--outermost"]),
        ({"level": 2}, ["--level", 2]),
        ({"method": "static"}, ["--method", "static"]),
        ({"separate": "0.01x"}, ["--separate", "0.01x"]),
    ],
)
def test_clean(crossing, options, words):
    assert same(tm.clean(tm.parse(crossing), **options), "tm-clean", *words, stdin=crossing)


@pytest.mark.parametrize(
    "options, words",
    [
        ({}, []),
        ({"smooth": 0.1, "iterations": 3}, ["--smooth", 0.1, "--iterations", 3]),
        ({"min_edge": "0.5x", "max_edge": 0.2}, ["--min-edge", "0.5x", "--max-edge", 0.2]),
        ({"adaptive": "0.1%"}, ["--adaptive", "0.1%"]),
        ({"flip": "angle", "smooth": "none"}, ["--flip", "angle", "--smooth", "none"]),
        ({"only": "smooth", "project": True}, ["--only", "smooth", "--project"]),
    ],
)
def test_remesh(options, words):
    ball = shape("dented", "--faces", 2000)
    assert same(tm.remesh(tm.parse(ball), **options), "tm-remesh", *words, stdin=ball)


def test_decimate():
    ball = shape("torus", "--faces", 3000)
    assert same(tm.decimate(tm.parse(ball), 500), "tm-remesh", "--faces", 500, stdin=ball)


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
    # With normals, velocities and a reference edge, which follow.
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
        with pytest.raises(tm.InputError, match="the mask is of"):
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


def test_refusals_are_exceptions_with_the_sentence_of_the_program(bodies):
    mesh = tm.parse(bodies)
    refused = [
        (tm.GoalError, "none of .* faces is selected", lambda: tm.select(mesh, box=[7] * 6)),
        (tm.InputError, "has no property 'size'", lambda: tm.select(mesh, where="size>1")),
        (tm.UsageError, "is no condition", lambda: tm.select(mesh, where="size")),
        (tm.UsageError, "none of faces, area, volume", lambda: tm.split(mesh, by="weight")),
        (tm.UsageError, "3 numbers are needed, not 2", lambda: tm.select(mesh, around=(1, 2))),
        (tm.UsageError, "the matrix is singular", lambda: tm.transform(mesh, scale=0)),
        (tm.UsageError, "translate: numbers", lambda: tm.transform(mesh, translate="far")),
        (tm.UsageError, "'w' is neither", lambda: tm.transform(mesh, mirror="w")),
        (tm.UsageError, "there is no 'turn'", lambda: tm.transform(mesh, turn=3)),
        (tm.GoalError, "", lambda: tm.transform(mesh, scale=1e308)),
        (tm.UsageError, "either count or distance", lambda: tm.sample(mesh)),
        (tm.UsageError, "either count or distance", lambda: tm.sample(mesh, 3, distance=1)),
        (tm.UsageError, "at least 3", lambda: tm.fill(mesh, max_edges=2)),
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


def test_render_is_the_picture_of_the_program(crossing, tmp_path):
    zlib = pytest.importorskip("zlib")
    picture = tm.render(tm.parse(crossing), size=(60, 40), orbit=(10, 5))
    png = run("tm-render", "--size", "60x40", "--orbit", "10,5", stdin=crossing)
    assert picture.shape == (40, 60, 4)
    assert decode(png, zlib) == picture[:, :, :3].tobytes() or decode(png, zlib) == picture.tobytes()


def decode(png, zlib):
    """The bytes of the pixels of a PNG of 8 bits, by the format's own description."""
    data, place, width, channels = b"", 8, 0, 0
    while place < len(png):
        size = int.from_bytes(png[place : place + 4], "big")
        kind, body = png[place + 4 : place + 8], png[place + 8 : place + 8 + size]
        if kind == b"IHDR":
            width = int.from_bytes(body[:4], "big")
            channels = {2: 3, 6: 4}[body[9]]
        if kind == b"IDAT":
            data += body
        place += size + 12
    rows, stride, pixels = zlib.decompress(data), width * channels, b""
    above = bytes(stride)
    for start in range(0, len(rows), stride + 1):
        row = bytearray(rows[start + 1 : start + 1 + stride])
        for i in range(stride):
            left = row[i - channels] if i >= channels else 0
            corner = above[i - channels] if i >= channels else 0
            guess = left + above[i] - corner
            nearest = min((left, above[i], corner), key=lambda value: abs(guess - value))
            add = [0, left, above[i], (left + above[i]) // 2, nearest][rows[start]]
            row[i] = (row[i] + add) & 255
        above = bytes(row)
        pixels += above
    return pixels


@pytest.fixture(scope="module")
def scene(tmp_path_factory):
    folder = tmp_path_factory.mktemp("scene")
    run("tm-shape", "dented", "--faces", 1500, "-o", folder / "truth.ply")
    run("tm-photograph", "--size", "100x80", "--write-images", folder / "photos",
        "--write-silhouettes", folder / "masks", "-o", folder / "par.txt", folder / "truth.ply")
    return folder


def test_hull(scene):
    words = ["--cameras", scene / "par.txt", "--silhouettes", scene / "masks", "--resolution", 30]
    hull = tm.hull(str(scene / "par.txt"), str(scene / "masks"), resolution=30)
    assert hull.to_bytes() == run("tm-hull", "--no-provenance", *words)


def test_reconstruct(scene):
    places = [str(scene / name) for name in ["par.txt", "photos", "masks"]]
    result = tm.reconstruct(*places, passes=1, edge=5, coarsest=1)
    words = sum(([o, p] for o, p in zip(["--cameras", "--images", "--silhouettes"], places)), [])
    words += ["--passes", 1, "--edge", 5, "--coarsest", 1, "--no-provenance"]
    assert result.to_bytes() == run("tm-reconstruct", *words)
    assert result.report["passes"] >= 1


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
