"""Velocity of a surface that follows six balls, which drift on circles and pulsate, as a persistent
command of tm-evolve: see TIME in tm-evolve(1). Their motion repeats itself after 2 pi units of time.

A vertex follows the ball to whose surface it is nearest: by the motion of the ball's center, the change
of its radius, and back to its surface. So the surface merges where balls meet, and necks between
balls that part become thin and pinch off.

With the words `balls TIME`, prints the centers and radii at a time instead; with `volume TIME` the volume
of their union, by a grid of points.
"""

import sys

import numpy as np

# For each ball: the number of turns on its circle in a period, and the phase of turn and pulsation
# in radians.
TURNS = np.array([1, -1, 2, -2, 1, 3])
PHASES = np.arange(6) * 2.4
CIRCLES = np.array([[x, y, 0] for x in (-0.55, 0.55) for y in (-0.7, 0, 0.7)])
# Speed of the return to the exact surface, divided by the distance. At half the value, necks do not
# pinch off before balls meet again. At twice the value, a step of 0.02 corrects a tenth of the
# distance at once.
RETURN = 3


def balls(time):
    """Centers, radii, and their derivatives in time."""
    angle = TURNS * time + PHASES
    swing = 0.35 * np.stack([np.cos(angle), np.sin(angle), 0.4 * np.sin(2 * angle)], axis=1)
    drift = 0.35 * TURNS[:, None] * np.stack(
        [-np.sin(angle), np.cos(angle), 0.8 * np.cos(2 * angle)], axis=1)
    beat = 2 * time + PHASES
    return CIRCLES + swing, 0.27 + 0.07 * np.sin(beat), drift, 0.14 * np.cos(beat)


def velocities(points, time):
    centers, radii, drift, growth = balls(time)
    away = points[:, None, :] - centers
    lengths = np.maximum(np.linalg.norm(away, axis=2), 1e-12)
    nearest = np.argmin(lengths - radii, axis=1)
    rows = np.arange(len(points))
    outside = (lengths - radii)[rows, nearest]
    direction = away[rows, nearest] / lengths[rows, nearest][:, None]
    return drift[nearest] + (growth[nearest] - RETURN * outside)[:, None] * direction


def union_volume(time, spacing=0.01):
    centers, radii, _, _ = balls(time)
    axes = [np.arange(low, high, spacing) for low, high in zip(
        (centers - radii[:, None]).min(axis=0), (centers + radii[:, None]).max(axis=0) + spacing)]
    inside = np.zeros([len(axis) for axis in axes], dtype=bool)
    x, y, z = np.meshgrid(*axes, indexing="ij", sparse=True)
    for center, radius in zip(centers, radii):
        inside |= (x - center[0]) ** 2 + (y - center[1]) ** 2 + (z - center[2]) ** 2 < radius**2
    return inside.sum() * spacing**3


def answer_requests():
    source, sink = sys.stdin.buffer, sys.stdout.buffer
    sink.write(b"ready\n")
    sink.flush()
    while line := source.readline():
        _, size, time, _, _ = line.split()
        head, body = source.read(int(size)).split(b"end_header\n", 1)
        count = int(head.split(b"element vertex ")[1].split()[0])
        points = np.frombuffer(body, "<f8", 3 * count).reshape(-1, 3)
        sink.write(b"velocities %d\n" % count)
        sink.write(velocities(points, float(time)).astype("<f8").tobytes())
        sink.flush()


if sys.argv[1:2] == ["balls"]:
    for center, radius in zip(*balls(float(sys.argv[2]))[:2]):
        print(*center, radius)
elif sys.argv[1:2] == ["volume"]:
    print(union_volume(float(sys.argv[2])))
else:
    answer_requests()
