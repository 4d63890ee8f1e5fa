"""Camera files of other programs, written and read by their descriptions, apart from the code tested.

camera_files.py write FORMAT FOLDER   writes the files of three cameras
camera_files.py check FORMAT FOLDER   compares the files with the cameras: the pixels of 20 points
"""
import json
import math
import os
import random
import re
import struct
import sys
import zipfile

WIDTH, HEIGHT = 640, 480
PINHOLES = {"mvsnet", "llff", "neus", "mve", "openmvs"}  # formats without distortion
ONE_FOCAL = {"openmvg", "llff", "nvm", "mve"}
CENTERED = {"llff", "nvm", "mve"}


def product(a, b):
    return [[sum(x * y for x, y in zip(row, column)) for column in zip(*b)] for row in a]


def times(a, v):
    return [sum(x * y for x, y in zip(row, v)) for row in a]


def transposed(a):
    return [list(row) for row in zip(*a)]


def rotation(w, x, y, z):
    n = math.sqrt(w * w + x * x + y * y + z * z)
    w, x, y, z = w / n, x / n, y / n, z / n
    return [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]


def cameras(form):
    source = random.Random(3)
    result = []
    for i in range(3):
        q = [source.uniform(-1, 1) for _ in range(4)]
        n = math.sqrt(sum(x * x for x in q))
        fx = source.uniform(400, 700)
        result.append({
            "name": "view%d" % (i + 1), "q": [x / n for x in q], "R": rotation(*q),
            "C": [source.uniform(-3, 3) for _ in range(3)], "fx": fx,
            "fy": fx if form in ONE_FOCAL else fx * 1.1,
            "cx": (WIDTH - 1) / 2 if form in CENTERED else source.uniform(300, 340),
            "cy": (HEIGHT - 1) / 2 if form in CENTERED else source.uniform(220, 260),
            "k": [0] * 5 if form in PINHOLES | {"nvm"} else [0.1, -0.05, 0.02, 0.01, -0.02]})
    return result


def translation(c):
    return [-x for x in times(c["R"], c["C"])]


def pixels(c):
    source = random.Random(5)
    result = []
    for _ in range(20):
        local = [source.uniform(-1, 1), source.uniform(-1, 1), source.uniform(3, 9)]
        point = [a + b for a, b in zip(times(transposed(c["true_R"]), local), c["true_C"])]
        x, y, z = times(c["R"], [a - b for a, b in zip(point, c["C"])])
        x, y = x / z, y / z
        k1, k2, k3, p1, p2 = c["k"]
        r2 = x * x + y * y
        radial = 1 + k1 * r2 + k2 * r2 ** 2 + k3 * r2 ** 3
        u = x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x)
        v = y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y
        result.append((c["fx"] * u + c["cx"], c["fy"] * v + c["cy"]))
    return result


def put(folder, name, data):
    path = os.path.join(folder, name)
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "wb") as file:
        file.write(data if isinstance(data, bytes) else data.encode())


def text(values):
    return " ".join(repr(float(x)) for x in values)


def npy(values, shape):
    header = "{'descr': '<f8', 'fortran_order': False, 'shape': %r, }" % (shape,)
    header = header.ljust(117) + "\n"
    data = struct.pack("<%dd" % len(values), *values)
    return b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header.encode() + data


def write_transforms(folder, cams):
    frames = []
    for c in cams:
        axes = transposed([c["R"][0], [-x for x in c["R"][1]], [-x for x in c["R"][2]]])
        matrix = [row + [center] for row, center in zip(axes, c["C"])] + [[0, 0, 0, 1]]
        k1, k2, k3, p1, p2 = c["k"]
        frames.append({"file_path": "images/" + c["name"] + ".pgm", "transform_matrix": matrix,
                       "fl_x": c["fx"], "fl_y": c["fy"], "cx": c["cx"] + 0.5, "cy": c["cy"] + 0.5,
                       "k1": k1, "k2": k2, "k3": k3, "p1": p1, "p2": p2})
    put(folder, "transforms.json",
        json.dumps({"camera_model": "OPENCV", "w": WIDTH, "h": HEIGHT, "frames": frames}))


def write_meshroom(folder, cams):
    views, lenses, poses = [], [], []
    for i, c in enumerate(cams):
        views.append({"viewId": str(i), "poseId": str(i), "intrinsicId": str(i),
                      "path": "/somewhere/" + c["name"] + ".pgm"})
        lenses.append({"intrinsicId": str(i), "width": str(WIDTH), "height": str(HEIGHT),
                       "sensorWidth": "36", "type": "brown",
                       "focalLength": repr(c["fx"] * 36 / WIDTH), "pixelRatio": repr(c["fy"] / c["fx"]),
                       "principalPoint": [repr(c["cx"] - WIDTH / 2), repr(c["cy"] - HEIGHT / 2)],
                       "distortionParams": [repr(x) for x in c["k"]]})
        columns = [x for column in transposed(c["R"]) for x in column]
        poses.append({"poseId": str(i), "pose": {"transform": {
            "rotation": [repr(x) for x in columns], "center": [repr(x) for x in c["C"]]}}})
    put(folder, "cameras.sfm", json.dumps({"version": ["1", "2", "6"], "views": views,
                                           "intrinsics": lenses, "poses": poses}, indent=4))


def write_openmvg(folder, cams):
    def wrapped(i, data):
        return {"key": i, "value": {"polymorphic_id": 1, "ptr_wrapper": {"id": 9 + i, "data": data}}}
    views, lenses, poses = [], [], []
    for i, c in enumerate(cams):
        views.append(wrapped(i, {"local_path": "", "filename": c["name"] + ".pgm", "width": WIDTH,
                                 "height": HEIGHT, "id_view": i, "id_intrinsic": i, "id_pose": i}))
        lenses.append(wrapped(i, {"value0": {"width": WIDTH, "height": HEIGHT, "focal_length": c["fx"],
                                             "principal_point": [c["cx"], c["cy"]]},
                                  "disto_t2": c["k"]}))
        poses.append({"key": i, "value": {"rotation": c["R"], "center": c["C"]}})
    put(folder, "sfm_data.json", json.dumps({
        "sfm_data_version": "0.3", "root_path": "/somewhere", "views": views, "intrinsics": lenses,
        "extrinsics": poses, "structure": [], "control_points": []}))


def intrinsics(c, shift=0):
    return [[c["fx"], 0, c["cx"] + shift], [0, c["fy"], c["cy"] + shift], [0, 0, 1]]


def write_mvsnet(folder, cams):
    for i, c in enumerate(cams):
        rows = [row + [t] for row, t in zip(c["R"], translation(c))] + [[0, 0, 0, 1]]
        put(folder, "cams/%08d_cam.txt" % i, "extrinsic\n" + "".join(text(r) + "\n" for r in rows) +
            "\nintrinsic\n" + "".join(text(r) + "\n" for r in intrinsics(c, 0.5)) + "\n2 0.1\n")


def write_llff(folder, cams):
    values = []
    for c in cams:
        down, right, back = c["R"][1], c["R"][0], [-x for x in c["R"][2]]
        for row in zip(down, right, back, c["C"], [HEIGHT, WIDTH, c["fx"]]):
            values.extend(row)
        values.extend([1, 20])
    put(folder, "poses_bounds.npy", npy(values, (len(cams), 17)))


def write_neus(folder, cams):
    os.makedirs(folder, exist_ok=True)
    with zipfile.ZipFile(os.path.join(folder, "cameras_sphere.npz"), "w") as archive:
        for i, c in enumerate(cams):
            rows = product(intrinsics(c), [r + [t] for r, t in zip(c["R"], translation(c))])
            values = [3 * x for row in rows for x in row] + [0, 0, 0, 1]
            archive.writestr("world_mat_%d.npy" % i, npy(values, (4, 4)))
            archive.writestr("scale_mat_%d.npy" % i, npy([2, 0, 0, 1, 0, 2, 0, 1, 0, 0, 2, 1, 0, 0, 0, 1], (4, 4)))


def write_nvm(folder, cams):
    lines = ["NVM_V3 ", "", str(len(cams))]
    for c in cams:
        lines.append("%s.pgm\t%r %s %s 0 0" % (c["name"], c["fx"], text(c["q"]), text(c["C"])))
    put(folder, "model.nvm", "\n".join(lines + ["", "0", ""]))


def write_mve(folder, cams):
    for i, c in enumerate(cams):
        put(folder, "views/view_%04d.mve/meta.ini" % i,
            "# MVE view meta data is stored in INI-file syntax.\n\n[camera]\nfocal_length = %r\n"
            "pixel_aspect = 1\nprincipal_point = 0.5 0.5\nrotation = %s\ntranslation = %s\n"
            "\n[view]\nid = %d\nname = %s\n" % (c["fx"] / WIDTH, text([x for r in c["R"] for x in r]),
                                                text(translation(c)), i, c["name"]))
        put(folder, "views/view_%04d.mve/undistorted.png" % i, image())


def write_openmvs(folder, cams):
    def word(x):
        return struct.pack("<Q", len(x)) + x.encode()
    data = b"MVSI" + struct.pack("<IIQ", 5, 0, len(cams))
    for c in cams:
        data += word("") + struct.pack("<Q", 1) + word("") + word("RGB") + struct.pack("<II", WIDTH, HEIGHT)
        data += struct.pack("<9d", *[x for row in intrinsics(c) for x in row])
        data += struct.pack("<9d3d", 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0) + struct.pack("<Q", 1)
        data += struct.pack("<9d3d", *[x for row in c["R"] for x in row], *c["C"])
    data += struct.pack("<Q", len(cams))
    for i, c in enumerate(cams):
        data += word("/somewhere/" + c["name"] + ".pgm") + word("") + struct.pack("<IIII", i, 0, 0, i)
    put(folder, "scene.mvs", data + struct.pack("<Q", 0) * 6)


def image():
    return b"P5 %d %d 255\n" % (WIDTH, HEIGHT) + bytes(WIDTH * HEIGHT)


def numbers(yaml, key):
    return [float(x) for x in re.search(key + r": !!opencv-matrix.*?\[(.*?)\]", yaml, re.S)[1].split(",")]


def read_opencv(folder, form):
    result = []
    for name in sorted(os.listdir(folder)):
        with open(os.path.join(folder, name)) as file:
            yaml = file.read()
        k, r, t = numbers(yaml, "camera_matrix"), numbers(yaml, "\nR"), numbers(yaml, "\nT")
        d = numbers(yaml, "distortion_coefficients")
        rows = [r[0:3], r[3:6], r[6:9]]
        result.append({"R": rows, "C": [-x for x in times(transposed(rows), t)], "fx": k[0], "fy": k[4],
                       "cx": k[2], "cy": k[5], "k": [d[0], d[1], d[4], d[2], d[3]]})
    return result


def read_transforms(folder, form):
    with open(os.path.join(folder, "transforms.json")) as file:
        data = json.load(file)
    result = []
    for frame in data["frames"]:
        lens = dict(data, **frame)
        m = frame["transform_matrix"]
        rows = transposed([[row[0], -row[1], -row[2]] for row in m[:3]])
        result.append({"R": rows, "C": [row[3] for row in m[:3]], "fx": lens["fl_x"], "fy": lens["fl_y"],
                       "cx": lens["cx"] - 0.5, "cy": lens["cy"] - 0.5,
                       "k": [lens.get(key, 0) for key in ("k1", "k2", "k3", "p1", "p2")]})
    return result


def read_meshroom(folder, form):
    with open(os.path.join(folder, "cameras.sfm")) as file:
        data = json.load(file)
    assert data["version"] == ["1", "2", "0"]
    lenses = {lens["intrinsicId"]: lens for lens in data["intrinsics"]}
    poses = {pose["poseId"]: pose["pose"]["transform"] for pose in data["poses"]}
    result = []
    for view in data["views"]:
        lens, pose = lenses[view["intrinsicId"]], poses[view["poseId"]]
        r = [float(x) for x in pose["rotation"]]
        k = [float(x) for x in lens["distortionParams"]]
        result.append({"R": transposed([r[0:3], r[3:6], r[6:9]]), "C": [float(x) for x in pose["center"]],
                       "fx": float(lens["pxFocalLength"][0]), "fy": float(lens["pxFocalLength"][1]),
                       "cx": float(lens["principalPoint"][0]), "cy": float(lens["principalPoint"][1]),
                       "k": k + [0] * (5 - len(k))})
    return result


def read_openmvs(folder, form):
    with open(os.path.join(folder, "scene.mvs"), "rb") as file:
        data = file.read()
    place = 4

    def take(kind):
        nonlocal place
        values = struct.unpack_from("<" + kind, data, place)
        place += struct.calcsize("<" + kind)
        return values if len(values) > 1 else values[0]

    def take_text():
        nonlocal place
        size = take("Q")
        place += size
        return data[place - size:place].decode()

    assert data[:4] == b"MVSI" and take("II") == (2, 0)
    result = []
    for _ in range(take("Q")):
        take_text()
        assert take("Q") == 1
        take_text()
        assert take("II") == (WIDTH, HEIGHT)
        k = take("9d")
        assert take("12d") == (1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0) and take("Q") == 1
        r, c = take("9d"), take("3d")
        result.append({"R": [r[0:3], r[3:6], r[6:9]], "C": c, "fx": k[0], "fy": k[4], "cx": k[2], "cy": k[5],
                       "k": [0] * 5})
    assert take("Q") == len(result)
    for i in range(len(result)):
        take_text()
        assert take("III") == (i, 0, 0)
    assert [take("Q") for _ in range(6)] == [0] * 6 and len(data) - place == 16 * 8
    return result


def check(form, folder, truth_form):
    found = globals()["read_" + form](folder, form)
    truth = cameras(truth_form)
    assert len(found) == len(truth), (len(found), len(truth))
    worst = 0
    for a, b in zip(found, truth):
        for c in (a, b):
            c["true_R"], c["true_C"] = b["R"], b["C"]
        for p, q in zip(pixels(a), pixels(b)):
            worst = max(worst, math.dist(p, q))
    assert worst < 1e-6, worst
    print("%s %s: %.2e pixels" % (truth_form, form, worst))


if __name__ == "__main__":
    task, form, folder = sys.argv[1:4]
    if task == "write":
        cams = cameras(form)
        globals()["write_" + form](folder, cams)
        for cam in cams:
            put(folder + "-images", cam["name"] + ".pgm", image())
    else:
        check(form, folder, sys.argv[4])
