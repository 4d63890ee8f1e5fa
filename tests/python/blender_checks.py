"""Tests of the Blender add-on, run by tests/python/blender.bats in Blender's background mode."""

import os
import sys

import bpy
import numpy as np

sys.path.insert(0, sys.argv[-1])
import transformesh_tools


def cube(size, place, materials=()):
    bpy.ops.mesh.primitive_cube_add(size=size, location=place)
    made = bpy.context.active_object
    for name in materials:
        made.data.materials.append(bpy.data.materials.new(name))
    return made


def join(*objects):
    choose(*objects)
    bpy.ops.object.join()
    return bpy.context.active_object


def choose(*objects):
    bpy.ops.object.select_all(action="DESELECT")
    for one in objects:
        one.select_set(True)
    bpy.context.view_layer.objects.active = objects[0]


def triangles(made):
    mesh = made.data
    points = np.array([vertex.co for vertex in mesh.vertices])
    return points[np.array([face.vertices for face in mesh.polygons])]


def volume(made):
    a, b, c = triangles(made).transpose(1, 0, 2)
    return np.einsum("ij,ij->", a, np.cross(b, c)) / 6


def is_near(value, expected, error=1e-5):
    assert abs(value - expected) < error, (value, expected)


def message_of(command, **options):
    try:
        command(**options)
    except RuntimeError as error:
        return str(error)
    raise AssertionError("no error")


transformesh_tools.register()
tools = bpy.ops.transformesh
# The overlap of two cubes of edge 2 is a cube of edge 1.
for operation, expected in [("union", 15), ("intersection", 1), ("difference", 7), ("xor", 14)]:
    first, second = cube(2, (0, 0, 0)), cube(2, (1, 1, 1))
    choose(first, second)
    assert tools.boolean(operation=operation) == {"FINISHED"}
    is_near(volume(first), expected)
    assert len(second.data.polygons) == 6

# A mirrored, turned and moved operand is taken where the scene shows it. The result stays in the
# coordinates of the active object.
first, second = cube(2, (5, 0, 0)), cube(2, (6.5, 2, 2))
first.rotation_euler = second.rotation_euler = (0, 0, np.pi / 2)
first.scale, second.scale = (2, 2, 2), (-2, 1, 1)
bpy.context.view_layer.update()
choose(first, second)
tools.boolean(operation="difference")
is_near(volume(first) * 8, 64 - 1.5 * 2 * 1, 1e-4)

# One object of two cubes: faces keep the materials of their cubes.
both = join(cube(2, (0, 0, 0), ["red"]), cube(2, (1, 1, 1), ["blue"]))
tools.clean()
is_near(volume(both), 15)
corners, materials = triangles(both), [face.material_index for face in both.data.polygons]
assert set(materials) == {0, 1}
for triangle, material in zip(corners, materials):
    assert np.all(np.abs(triangle if material == 0 else triangle - 1) < 1 + 1e-5)

ball = cube(2, (0, 0, 0))
choose(ball)
tools.remesh(edge=0.2, iterations=3)
lengths = np.linalg.norm(np.diff(triangles(ball), axis=1), axis=2)
assert 0.1 < lengths.mean() < 0.3 and len(lengths) > 500
is_near(volume(ball), 8, 0.01)
box = cube(2, (0, 0, 0))
tools.offset(distance=0.5, keep_corners=True)
is_near(volume(box), 27)

# Refusals are errors with a message, and the mesh stays.
sheet = cube(2, (0, 0, 0))
first, second = cube(2, (0, 0, 0)), cube(2, (1, 1, 1))
first.data.flip_normals()
choose(first)
assert "tm-clean: " in message_of(tools.clean)
assert len(first.data.polygons) == 6
first.shape_key_add()
assert "shape keys" in message_of(tools.clean)
choose(second)
assert "poll" in message_of(tools.boolean)
os.environ["PATH"] = "/nowhere"
assert "tm-offset is not in PATH" in message_of(tools.offset)
transformesh_tools.unregister()
print("all Blender tests passed")
