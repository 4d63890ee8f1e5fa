"""Photographs of a mesh, path-traced by Blender's Cycles: run by scripts/experiments/path-traced as

    blender --background --python path_traced.py -- MESH.off CAMERAS.txt FOLDER [gloss] [noise]

For every camera of Middlebury's text format, FOLDER/images gets a photograph, and FOLDER/masks what
Cycles says the surface covers. Light is soft, with one large lamp; the color is a noise that the
surface carries. With gloss, a fifth of the light is mirrored; with noise, sensors have noise, and
each photograph an exposure of its own, of up to 20 % more or less.
"""

import os
import sys

import bpy
import mathutils
import numpy

WIDTH, HEIGHT = map(int, os.environ.get("SIZE", "640x480").split("x"))
SAMPLES = int(os.environ.get("SAMPLES", "32"))


def read_mesh(path):
    """The vertices and faces of an OFF file of triangles."""
    with open(path, encoding="ascii") as file:
        lines = [line.split("#")[0].split() for line in file]
    lines = [line for line in lines if line and line[0] != "OFF"]
    count = int(lines[0][0])
    vertices = [tuple(map(float, line[:3])) for line in lines[1 : count + 1]]
    return vertices, [tuple(map(int, line[1:4])) for line in lines[count + 1 :]]


def read_cameras(path):
    """Name, K, and where the camera stands, of every line of NAME K11..K33 R11..R33 t1..t3."""
    with open(path, encoding="ascii") as file:
        rows = [line.split() for line in file][1:]
    cameras = []
    for name, *numbers in rows:
        values = numpy.array(numbers, dtype=float)
        pose = numpy.eye(4)
        pose[:3, :3], pose[:3, 3] = values[9:18].reshape(3, 3), values[18:21]
        # In Blender the viewing direction of a camera is -z, and y is up.
        pose = numpy.linalg.inv(pose) @ numpy.diag([1, -1, -1, 1])
        cameras.append((name, values[:9].reshape(3, 3), pose))
    return cameras


def make_material(size, is_glossy):
    """A color that varies over lengths from a hundredth to a fifth of the size."""
    material = bpy.data.materials.new("surface")
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    place = nodes.new("ShaderNodeTexCoord")
    noise = nodes.new("ShaderNodeTexNoise")
    noise.inputs["Scale"].default_value = 8 / size
    noise.inputs["Detail"].default_value = 5
    noise.inputs["Roughness"].default_value = 0.7
    ramp = nodes.new("ShaderNodeValToRGB")
    for element, position, color in zip(
        ramp.color_ramp.elements, (0.3, 0.7), ((0.10, 0.06, 0.03, 1), (0.85, 0.75, 0.55, 1))
    ):
        element.position, element.color = position, color
    diffuse = nodes.new("ShaderNodeBsdfDiffuse")
    output = nodes.new("ShaderNodeOutputMaterial")
    links.new(place.outputs["Object"], noise.inputs["Vector"])
    links.new(noise.outputs["Fac"], ramp.inputs["Fac"])
    links.new(ramp.outputs["Color"], diffuse.inputs["Color"])
    surface = diffuse
    if is_glossy:
        gloss = nodes.new("ShaderNodeBsdfGlossy")
        gloss.inputs["Roughness"].default_value = 0.25
        surface = nodes.new("ShaderNodeMixShader")
        surface.inputs["Fac"].default_value = 0.2
        links.new(diffuse.outputs[0], surface.inputs[1])
        links.new(gloss.outputs[0], surface.inputs[2])
    links.new(surface.outputs[0], output.inputs["Surface"])
    return material


def make_scene(mesh_path, is_glossy):
    """The mesh, its light, and a camera. Returns the camera."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    vertices, faces = read_mesh(mesh_path)
    mesh = bpy.data.meshes.new("mesh")
    mesh.from_pydata(vertices, [], faces)
    corners = numpy.array(vertices)
    size = float(numpy.linalg.norm(corners.max(axis=0) - corners.min(axis=0)))
    middle = (corners.max(axis=0) + corners.min(axis=0)) / 2
    mesh.materials.append(make_material(size, is_glossy))
    scene.collection.objects.link(bpy.data.objects.new("mesh", mesh))

    scene.world = bpy.data.worlds.new("world")
    scene.world.use_nodes = True
    scene.world.node_tree.nodes["Background"].inputs["Strength"].default_value = 8
    lamp = bpy.data.lights.new("lamp", "AREA")
    lamp.size = size
    lamp.energy = 25 * size * size
    stand = bpy.data.objects.new("lamp", lamp)
    direction = mathutils.Vector((0.5, -0.6, 0.8))
    stand.location = mathutils.Vector(middle) + 1.5 * size * direction
    stand.rotation_euler = direction.to_track_quat("Z", "Y").to_euler()
    scene.collection.objects.link(stand)

    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    scene.collection.objects.link(camera)
    scene.camera = camera
    return camera


def set_up_render():
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.device = "CPU"
    scene.cycles.samples = SAMPLES
    scene.cycles.use_denoising = False
    scene.cycles.pixel_filter_type = "GAUSSIAN"
    scene.render.film_transparent = True
    scene.render.resolution_x, scene.render.resolution_y = WIDTH, HEIGHT
    scene.render.resolution_percentage = 100
    scene.render.image_settings.file_format = "PNG"
    scene.render.image_settings.color_mode = "RGBA"
    scene.view_settings.view_transform = "Standard"


def place_camera(camera, intrinsics, pose):
    """Whole numbers are centers of pixels; Blender measures from the edge, in widths."""
    lens = camera.data
    lens.sensor_fit = "HORIZONTAL"
    lens.sensor_width = 36
    lens.lens = intrinsics[0, 0] * lens.sensor_width / WIDTH
    lens.shift_x = 0.5 - (intrinsics[0, 2] + 0.5) / WIDTH
    lens.shift_y = (intrinsics[1, 2] + 0.5 - HEIGHT / 2) / WIDTH
    lens.clip_start, lens.clip_end = 1e-3, 1e6
    camera.matrix_world = mathutils.Matrix(pose.tolist())


def save(pixels, path):
    """Levels from 0 to 1, rows from below, as a PNG."""
    image = bpy.data.images.new("image", WIDTH, HEIGHT, alpha=False)
    image.colorspace_settings.name = "Non-Color"
    image.pixels.foreach_set(pixels.astype(numpy.float32).ravel())
    image.filepath_raw, image.file_format = path, "PNG"
    image.save()
    bpy.data.images.remove(image)


def photograph(path, random):
    """Renders, and returns the levels and what is covered; random where sensors have noise."""
    scene = bpy.context.scene
    scene.view_settings.exposure = numpy.log2(random.uniform(0.8, 1.2)) if random else 0
    scene.render.filepath = path
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(path)
    image.colorspace_settings.name = "Non-Color"
    pixels = numpy.empty(WIDTH * HEIGHT * 4, dtype=numpy.float32)
    image.pixels.foreach_get(pixels)
    bpy.data.images.remove(image)
    pixels = pixels.reshape(HEIGHT, WIDTH, 4)
    covered = pixels[:, :, 3].copy()
    if random:
        pixels[:, :, :3] += random.normal(0, 0.02, (HEIGHT, WIDTH, 3))
    pixels[:, :, :3] *= covered[:, :, None]
    pixels[:, :, 3] = 1
    return numpy.clip(pixels, 0, 1), covered


def main(mesh_path, cameras_path, folder, *looks):
    camera = make_scene(mesh_path, "gloss" in looks)
    set_up_render()
    random = numpy.random.default_rng(1) if "noise" in looks else None
    for name, intrinsics, pose in read_cameras(cameras_path):
        place_camera(camera, intrinsics, pose)
        path = os.path.join(folder, "images", name)
        pixels, covered = photograph(path, random)
        save(pixels, path)
        mask = numpy.ones((HEIGHT, WIDTH, 4))
        mask[:, :, :3] = (covered > 0.5)[:, :, None]
        save(mask, os.path.join(folder, "masks", name))


main(*sys.argv[sys.argv.index("--") + 1 :])
