"""Puts {{ title }} into Blender: `blender --python {{ name }}.py`, or run it in the Text editor. Written by Chiaro {{ version }}; CC0 1.0.

The mesh is {{ name }}.obj beside this file, with its materials in {{ name }}.mtl. Lights have the radiance that they have in the scene, so that with Cycles a picture is as bright as Chiaro's.
Lengths of the scene are millimetres, z up; in Blender a millimetre is 0.001 metres.
"""

import json
import math
import os

import bpy
from mathutils import Matrix, Vector

MILLIMETRE = 0.001
EYE, TARGET, UP = {{ eye | tojson }}, {{ target | tojson }}, {{ up | tojson }}
FIELD_OF_VIEW = {{ field_of_view }}  # vertical, in degrees
# The sky's radiance overhead, at the horizon and from below; the height of the floor, if there is one; the lights.
SCENE = json.loads(r"""{{ lamps | tojson }}""")

NUMBERS = {"d": "Alpha", "Pr": "Roughness", "Pm": "Metallic"}


def linear(srgb):
    return srgb / 12.92 if srgb <= 0.04045 else ((srgb + 0.055) / 1.055) ** 2.4


def linked(name, data):
    made = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(made)
    return made


def frame(origin, z, x=None):
    """The place of an object whose axes z and x are these."""
    z = Vector(z).normalized()
    x = Vector(x) if x else z.orthogonal()
    x = (x - x.dot(z) * z).normalized()
    turned = Matrix((x, z.cross(x), z)).transposed().to_4x4()
    return Matrix.Translation(MILLIMETRE * Vector(origin)) @ turned


def lamp(kind, name, radiance, power):
    """A lamp of a colour; `power` is what Blender calls energy if the radiance is 1."""
    data = bpy.data.lights.new(name, kind)
    strongest = max(radiance)
    data.color = [component / strongest for component in radiance]
    data.energy = strongest * power
    return linked(name, data), data


def glowing(name, vertices, faces, radiance, is_two_sided):
    """A mesh that shines on the side from which its corners are anticlockwise."""
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata([MILLIMETRE * Vector(vertex) for vertex in vertices], [], faces)
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    emission, output = nodes.new("ShaderNodeEmission"), nodes.new("ShaderNodeOutputMaterial")
    emission.inputs["Color"].default_value = (*radiance, 1)
    links.new(emission.outputs[0], output.inputs["Surface"])
    if not is_two_sided:
        geometry, front = nodes.new("ShaderNodeNewGeometry"), nodes.new("ShaderNodeMath")
        front.operation = "SUBTRACT"
        front.inputs[0].default_value = 1
        links.new(geometry.outputs["Backfacing"], front.inputs[1])
        links.new(front.outputs[0], emission.inputs["Strength"])
    mesh.materials.append(material)
    return linked(name, mesh)


def add_mesh(path):
    bpy.ops.wm.obj_import(filepath=path + ".obj", global_scale=MILLIMETRE, forward_axis="Y", up_axis="Z")
    # Blender's versions read physically based materials differently.
    surface = None
    with open(path + ".mtl", encoding="utf-8") as file:
        for line in file:
            key, *values = line.split() or [""]
            if key == "newmtl":
                surface = bpy.data.materials[values[0]].node_tree.nodes["Principled BSDF"].inputs
            elif key == "Kd":
                surface["Base Color"].default_value = (*(linear(float(value)) for value in values), 1)
            elif key == "Ke" and any(float(value) > 0 for value in values):
                glow = "Emission Color" if "Emission Color" in surface else "Emission"
                surface[glow].default_value = (*(linear(float(value)) for value in values), 1)
                surface["Emission Strength"].default_value = 1
            elif key in NUMBERS:
                surface[NUMBERS[key]].default_value = float(values[0])


def add_light(number, light):
    name, radiance = f"{{ name }} light {number + 1}", light["radiance"]
    kind, metres = light["kind"], MILLIMETRE
    made = []
    if kind == "sphere":
        radius = metres * light["radius"]
        lit, data = lamp("POINT", name, radiance, 4 * math.pi**2 * radius**2)
        data.shadow_soft_size = radius
        lit.location = metres * Vector(light["centre"])
        made.append(lit)
    elif kind == "sun":
        lit, data = lamp("SUN", name, radiance, math.pi * light["sine"] ** 2)
        data.angle = 2 * math.asin(min(light["sine"], 1))
        lit.matrix_world = frame((0, 0, 0), light["direction"])
        made.append(lit)
    elif kind == "disk" or kind == "rectangle":
        for side in (1, -1) if light["two_sided"] else (1,):
            # Blender's area lights shine along −z.
            z = [-side * component for component in light["normal"]]
            if kind == "disk":
                radius = metres * light["radius"]
                lit, data = lamp("AREA", name, radiance, math.pi * math.pi * radius**2)
                data.shape, data.size = "DISK", 2 * radius
                lit.matrix_world = frame(light["centre"], z)
            else:
                width, height = (metres * length for length in light["size"])
                lit, data = lamp("AREA", name, radiance, math.pi * width * height)
                data.shape, data.size, data.size_y = "RECTANGLE", width, height
                lit.matrix_world = frame(light["centre"], z, light["along"])
            made.append(lit)
    elif kind == "polygon":
        corners = light["corners"]
        made.append(glowing(name, corners, [list(range(len(corners)))], radiance, light["two_sided"]))
    elif kind == "tube":
        axis, centre = Vector(light["axis"]), Vector(light["centre"])
        u = axis.orthogonal().normalized()
        v = axis.normalized().cross(u)
        sides = 64
        ring = [light["radius"] * (math.cos(2 * math.pi * i / sides) * u + math.sin(2 * math.pi * i / sides) * v) for i in range(sides)]
        vertices = [centre - axis + r for r in ring] + [centre + axis + r for r in ring]
        faces = [[i, (i + 1) % sides, sides + (i + 1) % sides, sides + i] for i in range(sides)]
        made.append(glowing(name, vertices, faces, radiance, False))
    for lit in made:
        lit.visible_camera = light["visible"]


def add_sky():
    """A sky that goes from the horizon to overhead with the direction's height; below it is even."""
    world = bpy.data.worlds.new("{{ name }} sky")
    world.use_nodes = True
    nodes, links = world.node_tree.nodes, world.node_tree.links
    coordinates, separate = nodes.new("ShaderNodeTexCoord"), nodes.new("ShaderNodeSeparateXYZ")
    ramp, background = nodes.new("ShaderNodeValToRGB"), nodes["Background"]
    height = nodes.new("ShaderNodeMapRange")
    height.inputs["From Min"].default_value = -1
    links.new(coordinates.outputs["Generated"], separate.inputs[0])
    links.new(separate.outputs["Z"], height.inputs["Value"])
    links.new(height.outputs[0], ramp.inputs[0])
    links.new(ramp.outputs[0], background.inputs["Color"])
    overhead, horizon, below = SCENE["sky"]
    stops = ramp.color_ramp.elements
    stops[0].position, stops[0].color = 0.49, (*below, 1)
    stops[1].position, stops[1].color = 1, (*overhead, 1)
    middle = stops.new(0.5)
    middle.color = (*horizon, 1)
    if SCENE["is_studio"]:
        # The camera sees a backdrop.
        path, seen = nodes.new("ShaderNodeLightPath"), nodes.new("ShaderNodeMixRGB")
        links.new(path.outputs["Is Camera Ray"], seen.inputs["Fac"])
        links.new(ramp.outputs[0], seen.inputs["Color1"])
        seen.inputs["Color2"].default_value = (0.80, 0.81, 0.82, 1)
        links.new(seen.outputs[0], background.inputs["Color"])
    bpy.context.scene.world = world


def add_floor():
    size = 1000 * max(Vector(EYE).length, 1) * MILLIMETRE
    bpy.ops.mesh.primitive_plane_add(size=size, location=(0, 0, SCENE["floor"] * MILLIMETRE))
    plane = bpy.context.object
    plane.name = "{{ name }} floor"
    # The studio's floor only catches shadows.
    plane.is_shadow_catcher = SCENE["is_studio"]
    material = bpy.data.materials.new(plane.name)
    material.use_nodes = True
    surface = material.node_tree.nodes["Principled BSDF"]
    surface.inputs["Base Color"].default_value = (0.62, 0.61, 0.60, 1)
    surface.inputs["Roughness"].default_value = 1
    plane.data.materials.append(material)


def add_camera():
    camera = bpy.data.cameras.new("{{ name }} camera")
    camera.sensor_fit = "VERTICAL"
    camera.angle = math.radians(FIELD_OF_VIEW)
    away = Vector(EYE) - Vector(TARGET)
    camera.clip_start, camera.clip_end = 0.01 * MILLIMETRE * away.length, 100 * MILLIMETRE * away.length
    seen = linked(camera.name, camera)
    seen.matrix_world = frame(EYE, away, Vector(UP).cross(away))
    bpy.context.scene.camera = seen


def main():
    scene = bpy.context.scene
    # What a new file starts with would be in the way.
    for name in ("Cube", "Light", "Camera"):
        if name in bpy.data.objects and len(bpy.data.objects) <= 3:
            bpy.data.objects.remove(bpy.data.objects[name])
    add_mesh(os.path.join(os.path.dirname(os.path.abspath(__file__)), "{{ name }}"))
    for number, light in enumerate(SCENE["lights"]):
        add_light(number, light)
    add_sky()
    if SCENE["floor"] is not None:
        add_floor()
    add_camera()
    scene.render.engine = "CYCLES"
    scene.render.resolution_x, scene.render.resolution_y = 960, round(960 / {{ aspect }})
    transforms = scene.view_settings.bl_rna.properties["view_transform"].enum_items.keys()
    neutral = "Khronos PBR Neutral"
    scene.view_settings.view_transform = neutral if neutral in transforms else "Standard"


main()
