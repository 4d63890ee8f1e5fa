"""Measures whether a mesh has the angles of a target along its sharp edges.

    feature_angles.py TARGET MESH

Samples points on the target's sharp edges. On both sides of each, at a third of the mesh's mean
edge length, it takes the normals of mesh and target, and compares the angle between the normals of
the mesh with that of the target. The line `flat` counts only points beside which the target is flat
up to a mean edge length on both sides; the mesh cannot follow narrower faces. Prints the number of
points and the share of their length at which the angles agree within 5 degrees."""

import sys

import numpy as np
import transformesh as tm


def normals(mesh):
    a, b, c = (mesh.positions[mesh.faces[:, i]] for i in range(3))
    n = np.cross(b - a, c - a)
    return n / np.maximum(np.linalg.norm(n, axis=1, keepdims=True), 1e-300)


def closest(mesh, points):
    """Returns the nearest face to each point, and its distance."""
    places = tm.carry(mesh, tm.Mesh(points), closest=True).vertex_columns
    face, u, v = (places["source_" + name] for name in ("face", "u", "v"))
    a, b, c = (mesh.positions[mesh.faces[face][:, i]] for i in range(3))
    on = (1 - u - v)[:, None] * a + u[:, None] * b + v[:, None] * c
    return face, np.linalg.norm(points - on, axis=1)


def turn(one, other):
    return np.degrees(np.arccos(np.clip((one * other).sum(axis=1), -1, 1)))


def sharp_edges(mesh, least=40):
    """Returns the ends and the two faces of each edge with an angle above `least` degrees."""
    halfedges = np.concatenate([mesh.faces[:, [i, (i + 1) % 3]] for i in range(3)])
    face = np.tile(np.arange(len(mesh.faces)), 3)
    key = np.sort(halfedges, axis=1)
    order = np.lexsort((key[:, 1], key[:, 0]))
    first, second = order[:-1], order[1:]
    pairs = (key[first] == key[second]).all(axis=1)
    first, second = first[pairs], second[pairs]
    n = normals(mesh)
    sharp = turn(n[face[first]], n[face[second]]) > least
    return key[first][sharp], face[first][sharp], face[second][sharp]


def places_along(target, edge):
    """Returns points on sharp edges, the length that each represents, its two faces, and the
    directions into these faces."""
    ends, one, other = sharp_edges(target)
    start, vector = target.positions[ends[:, 0]], np.diff(target.positions[ends], axis=1)[:, 0]
    length = np.linalg.norm(vector, axis=1)
    count = np.maximum(1, (length / edge).astype(int))
    row = np.repeat(np.arange(len(ends)), count)
    step = np.arange(len(row)) - np.repeat(np.cumsum(count) - count, count)
    place = start[row] + ((step + 0.5) / count[row])[:, None] * vector[row]
    inwards = []
    for face in (one, other):
        into = target.positions[target.faces[face]].mean(axis=1)[row] - place
        along = vector[row] / length[row, None]
        into -= (into * along).sum(axis=1, keepdims=True) * along
        inwards.append(into / np.linalg.norm(into, axis=1, keepdims=True))
    return place, (length / count)[row], (one[row], other[row]), inwards


def main(target, mesh):
    edge = tm.info(mesh)["edge_mean"]
    place, weight, faces, inwards = places_along(target, edge)
    of_target, of_mesh = normals(target), normals(mesh)
    is_flat = np.ones(len(place), dtype=bool)
    found = []
    for face, into in zip(faces, inwards):
        for reach in (edge / 3, edge):
            there, far = closest(target, place + reach * into)
            is_flat &= (far < 1e-6 * edge) & (turn(of_target[there], of_target[face]) < 5)
        found.append(of_mesh[closest(mesh, place + edge / 3 * into)[0]])
    error = np.abs(turn(*found) - turn(of_target[faces[0]], of_target[faces[1]]))
    for name, which in (("flat", is_flat), ("all", np.ones_like(is_flat))):
        share = weight[which & (error < 5)].sum() / max(weight[which].sum(), 1e-300)
        print(name, which.sum(), round(share, 4), "median", round(float(np.median(error[which])), 3))


main(tm.stitch(tm.read(sys.argv[1])), tm.read(sys.argv[2]))
