"""Blender add-on: cleans, combines, remeshes and offsets meshes by the programs of TransforMesh.

Install this file by Edit > Preferences > Add-ons > Install. The programs are those of the folder in the
add-on's preferences, or those in PATH. The commands are in Object > TransforMesh and in the search.

The result replaces the mesh of the active object. Coordinates are floats, as Blender stores them, and the
result of Clean and Boolean has no self-intersection in these. Faces keep their materials. UV maps, colors
and shape keys are lost, and modifiers are not applied.
"""

import os
import shutil
import subprocess
import tempfile

import bpy
import numpy as np

bl_info = {
    "name": "TransforMesh",
    "description": "Exact cleaning, Booleans, remeshing and offsets",
    "author": "The TransforMesh authors",
    "version": (1, 0, 0),
    "blender": (3, 4, 0),
    "location": "Object > TransforMesh",
    "category": "Mesh",
}

HEADER = """ply
format binary_little_endian 1.0
element vertex %d
property float x
property float y
property float z
element face %d
property list uchar int vertex_indices
property int material_index
end_header
"""
FACE = [("count", "u1"), ("corners", "<i4", 3), ("material_index", "<i4")]
TYPES = {"char": "i1", "uchar": "u1", "short": "<i2", "ushort": "<u2", "int": "<i4", "uint": "<u4",
         "float": "<f4", "double": "<f8"}


class ProgramError(Exception):
    """A program is missing or refuses its input."""


def write_ply(path, source, to_local):
    """Writes the triangles of an object, with positions transformed by a matrix."""
    mesh = source.data
    mesh.calc_loop_triangles()
    positions = np.empty(3 * len(mesh.vertices), "f4")
    mesh.vertices.foreach_get("co", positions)
    matrix = np.array(to_local)
    positions = positions.reshape(-1, 3) @ matrix[:3, :3].T + matrix[:3, 3]
    corners = np.empty(3 * len(mesh.loop_triangles), "i4")
    mesh.loop_triangles.foreach_get("vertices", corners)
    faces = np.zeros(len(mesh.loop_triangles), FACE)
    faces["count"] = 3
    # A matrix that mirrors turns faces inside out.
    faces["corners"] = corners.reshape(-1, 3)[:, :: 1 if np.linalg.det(matrix[:3, :3]) > 0 else -1]
    mesh.loop_triangles.foreach_get("material_index", materials := np.empty(len(faces), "i4"))
    faces["material_index"] = materials
    with open(path, "wb") as file:
        file.write((HEADER % (len(positions), len(faces))).encode())
        file.write(positions.astype("<f4").tobytes() + faces.tobytes())


def read_ply(path):
    """The vertices and faces of a binary file of triangles, each with its properties."""
    elements = []
    with open(path, "rb") as file:
        while (words := file.readline().decode().split()) != ["end_header"]:
            if words[0] == "element":
                elements.append((int(words[2]), []))
            elif words[:2] == ["property", "list"]:
                elements[-1][1].extend([("count", TYPES[words[2]]), ("corners", TYPES[words[3]], 3)])
            elif words[0] == "property":
                elements[-1][1].append((words[2], TYPES[words[1]]))
        return [np.frombuffer(file.read(count * np.dtype(fields).itemsize), fields)
                for count, fields in elements[:2]]


def replace_mesh(mesh, vertices, faces):
    mesh.clear_geometry()
    positions = np.stack([vertices[axis] for axis in "xyz"], axis=1)
    mesh.from_pydata(positions.tolist(), [], faces["corners"].tolist())
    if "material_index" in faces.dtype.names:
        mesh.polygons.foreach_set("material_index", np.ascontiguousarray(faces["material_index"]))
    mesh.update()


def program_path(name):
    """Where a program is: in the folder of the preferences, or else in PATH."""
    addon = bpy.context.preferences.addons.get(__name__)
    folder = bpy.path.abspath(addon.preferences.folder) if addon else ""
    path = shutil.which(name, path=folder or None)
    if not path:
        raise ProgramError("%s is not in %s" % (name, folder or "PATH, and the preferences name no folder"))
    return path


def run_program(words, sources, active):
    """Runs a program on the meshes of objects, in the coordinates of the active one."""
    with tempfile.TemporaryDirectory() as folder:
        paths = [os.path.join(folder, "%d.ply" % number) for number in range(len(sources))]
        for path, source in zip(paths, sources):
            write_ply(path, source, active.matrix_world.inverted() @ source.matrix_world)
        result = os.path.join(folder, "result.ply")
        command = [program_path(words[0]), "--quiet", "-o", result, *words[1:], *paths]
        ended = subprocess.run(command, capture_output=True, text=True, check=False)
        if ended.returncode != 0:
            raise ProgramError(ended.stderr.strip() or "%s ended with code %d" % (words[0], ended.returncode))
        return read_ply(result)


class MeshCommand:
    """What all commands do around their program."""

    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        active = context.active_object
        return active is not None and active.type == "MESH" and active.mode == "OBJECT"

    def sources(self, context):
        return [context.active_object]

    def execute(self, context):
        active = context.active_object
        if active.data.shape_keys:
            self.report({"ERROR"}, "The mesh has shape keys: apply or remove them first")
            return {"CANCELLED"}
        try:
            vertices, faces = run_program(self.words(), self.sources(context), active)
        except ProgramError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        before = len(active.data.polygons)
        replace_mesh(active.data, vertices, faces)
        self.report({"INFO"}, "%d faces, before %d" % (len(faces), before))
        return {"FINISHED"}


class Clean(MeshCommand, bpy.types.Operator):
    """Replace the surface by the boundary of what it encloses, without self-intersections"""

    bl_idname = "transformesh.clean"
    bl_label = "Clean"

    def words(self):
        return ["tm-clean"]


class Boolean(MeshCommand, bpy.types.Operator):
    """Combine the active object with the other selected ones, which stay as they are"""

    bl_idname = "transformesh.boolean"
    bl_label = "Boolean"
    operation: bpy.props.EnumProperty(
        name="Operation",
        items=[(name, name.capitalize(), "") for name in ("union", "intersection", "difference", "xor")],
    )

    @classmethod
    def poll(cls, context):
        return super().poll(context) and any(cls.others(context))

    @staticmethod
    def others(context):
        return [one for one in context.selected_objects if one.type == "MESH" and one != context.active_object]

    def sources(self, context):
        return [context.active_object, *self.others(context)]

    def words(self):
        return ["tm-boolean", self.operation]


class Remesh(MeshCommand, bpy.types.Operator):
    """Keep edges near a length and triangles round, without new self-intersections"""

    bl_idname = "transformesh.remesh"
    bl_label = "Remesh"
    edge: bpy.props.FloatProperty(name="Edge length", min=1e-6, default=0.1, subtype="DISTANCE")
    iterations: bpy.props.IntProperty(name="Iterations", min=1, max=100, default=5)

    def words(self):
        return ["tm-remesh", "--edge", repr(self.edge), "--iterations", str(self.iterations)]


class Offset(MeshCommand, bpy.types.Operator):
    """Move the surface outwards, or inwards if the distance is negative"""

    bl_idname = "transformesh.offset"
    bl_label = "Offset"
    distance: bpy.props.FloatProperty(name="Distance", default=0.1, subtype="DISTANCE")
    keep_corners: bpy.props.BoolProperty(name="Sharp corners", default=False)

    def words(self):
        return ["tm-offset", "--distance=%r" % self.distance] + ["--miter"] * self.keep_corners


class Menu(bpy.types.Menu):
    bl_idname = "OBJECT_MT_transformesh"
    bl_label = "TransforMesh"

    def draw(self, _context):
        for command in (Clean, Boolean, Remesh, Offset):
            self.layout.operator(command.bl_idname)


class Preferences(bpy.types.AddonPreferences):
    bl_idname = __name__
    folder: bpy.props.StringProperty(name="Folder of the programs", subtype="DIR_PATH", default="")

    def draw(self, _context):
        self.layout.prop(self, "folder")


CLASSES = (Clean, Boolean, Remesh, Offset, Menu, Preferences)


def draw_entry(menu, _context):
    menu.layout.menu(Menu.bl_idname)


def register():
    for one in CLASSES:
        bpy.utils.register_class(one)
    bpy.types.VIEW3D_MT_object.append(draw_entry)


def unregister():
    bpy.types.VIEW3D_MT_object.remove(draw_entry)
    for one in reversed(CLASSES):
        bpy.utils.unregister_class(one)
