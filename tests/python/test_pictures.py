"""Pictures and pages are those of the programs."""

import os
import shutil

import numpy as np
import pytest
import transformesh as tm
from programs import BUILD, pixels_of, run, shape


@pytest.fixture(scope="module")
def dented():
    mesh = tm.parse(shape("dented", "--faces", 1500))
    mesh.vertex_columns["height"] = mesh.positions[:, 2].copy()
    return mesh


def is_picture(picture, png):
    return pixels_of(png) in (picture.tobytes(), picture[..., :3].tobytes())


@pytest.mark.parametrize(
    "options, words",
    [
        ({"orbit": (10, 5)}, ["--orbit", "10,5"]),
        ({"views": 3, "columns": 2}, ["--views", 3, "--columns", 2]),
        ({"ambient_occlusion": True, "up": "z"}, ["--ambient-occlusion", "--up", "z"]),
        ({"color_by": "height", "range": (0, 1)}, ["--color-by", "height", "--range", "0,1"]),
        ({"crease_angle": 0, "zoom": 2}, ["--crease-angle", 0, "--zoom", 2]),
        ({"edges": True, "color": "#aabbcc"}, ["--edges", "--color", "#aabbcc"]),
        ({"background": "transparent"}, ["--background", "transparent"]),
        ({"frame": "place"}, ["--frame", "place"]),
    ],
)
def test_render(dented, options, words):
    picture = tm.render(dented, size=(60, 40), **options)
    assert picture.shape == (40, 60, 4)
    assert is_picture(picture, run("tm-render", "--size", "60x40", *words, stdin=dented.to_bytes()))


def test_render_around_a_mesh_with_segments(dented, tmp_path):
    around = tm.shape("box", 5, 5, 5, faces=100)
    tm.write(around, tmp_path / "around.ply")
    ends = dented.positions[:8].reshape(4, 2, 3) * 1.2
    lines = ["ply", "format ascii 1.0", "element vertex 8", "property double x", "property double y"]
    lines += ["property double z", "element edge 4", "property int vertex1", "property int vertex2"]
    lines += ["end_header", *(" ".join(map(repr, map(float, p))) for p in ends.reshape(8, 3))]
    (tmp_path / "segments.ply").write_text("\n".join(lines + ["0 1", "2 3", "4 5", "6 7"]) + "\n")
    words = ["--around", tmp_path / "around.ply", "--segments", tmp_path / "segments.ply"]
    png = run("tm-render", "--size", "60x40", *words, stdin=dented.to_bytes())
    picture = tm.render(dented, size=(60, 40), around=around, segments=ends)
    assert is_picture(picture, png)
    assert not np.array_equal(picture, tm.render(dented, size=(60, 40), around=around))
    with pytest.raises(tm.UsageError, match="segments: an array of shape"):
        tm.render(dented, segments=ends[0])


def test_render_a_movie(dented, tmp_path):
    movie = tm.render(dented, size=(40, 30), frames=3)
    assert movie.shape == (3, 30, 40, 4)
    run("tm-render", "--size", "40x30", "--frames", 3, "-o", tmp_path / "movie.png", stdin=dented.to_bytes())
    files = sorted(tmp_path.glob("movie*.png"))
    assert len(files) == 3
    assert all(is_picture(movie[i], file.read_bytes()) for i, file in enumerate(files))
    assert not np.array_equal(movie[0], movie[1])


@pytest.fixture(scope="module")
def runs(tmp_path_factory):
    folder = tmp_path_factory.mktemp("runs")
    run("tm-shape", "torus", "--faces", 500, "-o", folder / "target.ply")
    run("tm-shape", "sphere", "--around", folder / "target.ply", "--faces", 500, "-o", folder / "source.ply")
    for name in ["one", "two"]:
        run("tm-morph", folder / "source.ply", "--target", folder / "target.ply", "--iterations", 4,
            "--every", 1, "--run", folder / name)
    return folder


def test_report(runs, tmp_path):
    # The program looks for the viewer beside its own folder.
    (tmp_path / "bin").mkdir()
    (tmp_path / "share" / "transformesh").mkdir(parents=True)
    viewer = tmp_path / "share" / "transformesh" / "viewer.html"
    viewer.write_text("<title><!--tm:title--></title><body><!--tm:data--></body>")
    shutil.copy(os.path.join(BUILD, "bin", "tm-report"), tmp_path / "bin")
    program = tmp_path / "bin" / "tm-report"
    for options, words in [
        ({}, []),
        ({"every": 2, "title": "Both", "up": "z"}, ["--every", 2, "--title", "Both", "--up", "z"]),
        ({"color_by": "distance"}, ["--color-by", "distance"]),
    ]:
        page = tm.report(runs / "one", str(runs / "two"), viewer=viewer, **options)
        assert page == run(program, *words, runs / "one", runs / "two")
    with pytest.raises(tm.UsageError, match="no mesh has a property 'heat'"):
        tm.report(runs / "one", viewer=viewer, color_by="heat")
    with pytest.raises(tm.InputError):
        tm.report(tmp_path, viewer=viewer)
    with pytest.raises(tm.UsageError, match="the folder of a run is needed"):
        tm.report(viewer=viewer)


def test_the_viewer_is_found_where_it_is_installed(runs):
    if os.path.exists(os.path.join(BUILD, "share", "transformesh", "viewer.html")):
        assert tm.report(runs / "one") == run("tm-report", runs / "one")
    else:
        with pytest.raises(tm.GoalError, match="scripts/setup --browser"):
            tm.report(runs / "one")
