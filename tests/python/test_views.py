"""Hulls and reconstructions are those of the programs, and views are checked as they check them."""

import json
import shutil

import pytest
import transformesh as tm
from programs import run


@pytest.fixture(scope="module")
def scene(tmp_path_factory):
    folder = tmp_path_factory.mktemp("scene")
    run("tm-shape", "dented", "--faces", 1500, "-o", folder / "truth.ply")
    run("tm-photograph", "--size", "100x80", "--ring", 9, "--write-images", folder / "photos",
        "--write-silhouettes", folder / "masks", "-o", folder / "par.txt", folder / "truth.ply")
    return folder


def test_hull(scene):
    words = ["--cameras", scene / "par.txt", "--silhouettes", scene / "masks", "--resolution", 30]
    hull = tm.hull(str(scene / "par.txt"), str(scene / "masks"), resolution=30)
    assert hull.to_bytes() == run("tm-hull", "--no-provenance", *words)
    assert hull.report["dropped_views"] == 0 and hull.report["least_agreement"] > 0.9
    upper = tm.hull(scene / "par.txt", scene / "masks", box=[(-2, -2, 0), (2, 2, 2)], keep="all")
    words = words[:4] + ["--box", "-2,-2,0,2,2,2", "--keep", "all"]
    assert upper.to_bytes() == run("tm-hull", "--no-provenance", *words)


def test_reconstruct(scene):
    places = [str(scene / name) for name in ["par.txt", "photos", "masks"]]
    result = tm.reconstruct(*places, passes=1, edge=5, coarsest=1)
    words = sum(([o, p] for o, p in zip(["--cameras", "--images", "--silhouettes"], places)), [])
    words += ["--passes", 1, "--edge", 5, "--coarsest", 1, "--no-provenance"]
    assert result.to_bytes() == run("tm-reconstruct", *words)
    assert result.report["passes"] >= 1


def test_preview(scene):
    places = [str(scene / name) for name in ["par.txt", "photos", "masks"]]
    result = tm.reconstruct(*places, passes=1, coarsest=1, preview=True)
    words = sum(([o, p] for o, p in zip(["--cameras", "--images", "--silhouettes"], places)), [])
    words += ["--passes", 1, "--coarsest", 1, "--preview", "--no-provenance"]
    assert result.to_bytes() == run("tm-reconstruct", *words)


def test_how_photographs_are_compared(scene):
    places = [str(scene / name) for name in ["par.txt", "photos", "masks"]]
    box = [(-9, -9, -9), (9, 9, 9)]
    options = {"hollows": "closed", "window": (2, 1), "max_angle": 90, "box": box}
    result = tm.reconstruct(*places, passes=1, edge=5, coarsest=1, **options)
    words = sum(([o, p] for o, p in zip(["--cameras", "--images", "--silhouettes"], places)), [])
    words += ["--passes", 1, "--edge", 5, "--coarsest", 1, "--no-provenance"]
    plain = run("tm-reconstruct", *words)
    words += ["--hollows", "closed", "--window", "2,1", "--max-angle", 90]
    words += ["--box", "-9,-9,-9,9,9,9"]
    assert result.to_bytes() == run("tm-reconstruct", *words) != plain
    for window in [6, (3, 0)]:
        with pytest.raises(ValueError, match="window"):
            tm.reconstruct(*places, window=window)
    with pytest.raises(TypeError):
        tm.reconstruct(*places, window="wide")
    with pytest.raises(ValueError, match="hollows"):
        tm.reconstruct(*places, hollows="open")
    with pytest.raises(ValueError, match="the box is empty"):
        tm.reconstruct(*places, box=[(0, 0, 0), (0, 1, 1)])


def test_the_report_of_a_reconstruction(scene, tmp_path):
    places = [str(scene / name) for name in ["par.txt", "photos", "masks"]]
    report = tmp_path / "report.json"
    result = tm.reconstruct(*places, passes=1, edge=5, coarsest=1, crumbs=0.5)
    words = sum(([o, p] for o, p in zip(["--cameras", "--images", "--silhouettes"], places)), [])
    words += ["--passes", 1, "--edge", 5, "--coarsest", 1, "--crumbs", 0.5, "--report", report]
    run("tm-reconstruct", *words)
    told = json.loads(report.read_text())["result"]
    told["doubtful_places"] = [text for text in told["doubtful_places"].split("; ") if text]
    assert {key: result.report[key] for key in told} == told


def test_reconstruct_from_a_start(scene, tmp_path):
    start = tm.hull(scene / "par.txt", scene / "masks", resolution=20)
    tm.write(start, tmp_path / "start.ply")
    places = [scene / "par.txt", scene / "photos", scene / "masks"]
    options = {"silhouettes_show": "least", "clip": "nothing", "iterations": 2, "robust": 1}
    result = tm.reconstruct(*places, start=start, passes=1, edge=5, coarsest=1, **options)
    words = sum(([o, p] for o, p in zip(["--cameras", "--images", "--silhouettes"], places)), [])
    words += ["--passes", 1, "--edge", 5, "--coarsest", 1, "--silhouettes-show", "least", "--clip", "nothing"]
    words += ["--iterations", 2, "--robust", 1, "--start", tmp_path / "start.ply", "--no-provenance"]
    assert result.to_bytes() == run("tm-reconstruct", *words)


@pytest.fixture(scope="module")
def bad_scene(scene, tmp_path_factory):
    """One silhouette is that of the object elsewhere."""
    folder = tmp_path_factory.mktemp("bad")
    shutil.copytree(scene, folder, dirs_exist_ok=True)
    mask = sorted((folder / "masks").iterdir())[3]
    elsewhere = run("tm-transform", "--translate", "0.9,0.5,0.4", folder / "truth.ply")
    run("tm-photograph", "--cameras", folder / "par.txt", "--size", "100x80", "--write-silhouettes",
        folder / "moved", "-o", folder / "none.txt", stdin=elsewhere)
    shutil.copy(folder / "moved" / mask.name, mask)
    return folder, mask.stem


def test_a_view_that_disagrees_is_refused_or_left_out(bad_scene):
    folder, name = bad_scene
    words = ["--cameras", folder / "par.txt", "--silhouettes", folder / "masks"]
    with pytest.raises(tm.InputError, match=f"'{name}'.*disagrees"):
        tm.hull(folder / "par.txt", folder / "masks")
    with pytest.warns(UserWarning, match=f"the view '{name}' is left out"):
        hull = tm.hull(folder / "par.txt", folder / "masks", drop_bad_views=True)
    assert hull.to_bytes() == run("tm-hull", "--no-provenance", "--drop-bad-views", *words)
    assert hull.report["dropped_views"] == 1
    believed = tm.hull(folder / "par.txt", folder / "masks", least_agreement=0)
    assert believed.to_bytes() == run("tm-hull", "--no-provenance", "--least-agreement", 0, *words)


def test_a_reconstruction_checks_its_views(bad_scene):
    folder, name = bad_scene
    places = [folder / "par.txt", folder / "photos", folder / "masks"]
    with pytest.raises(tm.InputError, match=f"'{name}'.*disagrees"):
        tm.reconstruct(*places)
    with pytest.warns(UserWarning, match=f"the view '{name}' is left out"):
        result = tm.reconstruct(*places, drop_bad_views=True, passes=1, edge=5, coarsest=1)
    words = sum(([o, p] for o, p in zip(["--cameras", "--images", "--silhouettes"], places)), [])
    words += ["--passes", 1, "--edge", 5, "--coarsest", 1, "--drop-bad-views", "--no-provenance"]
    assert result.to_bytes() == run("tm-reconstruct", *words)
    assert result.report["dropped_views"] == 1


def test_mirror(scene, tmp_path):
    matrices = run("tm-cameras", "--format", "matrices", "--images", scene / "masks", scene / "par.txt")
    left = []
    for line in matrices.decode().splitlines():
        words = line.split()
        if not line.startswith("#"):
            words[2] = str(-float(words[2]))
        left.append(" ".join(words))
    (tmp_path / "left.txt").write_text("\n".join(left) + "\n")
    with pytest.raises(tm.InputError, match="mirror"):
        tm.hull(tmp_path / "left.txt", scene / "masks")
    mirrored = tm.hull(tmp_path / "left.txt", scene / "masks", mirror=True, resolution=30)
    words = ["--cameras", tmp_path / "left.txt", "--silhouettes", scene / "masks", "--resolution", 30]
    assert mirrored.to_bytes() == run("tm-hull", "--no-provenance", "--mirror", *words)
