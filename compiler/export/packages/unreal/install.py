"""Adds {{ title }} to the level that is open in Unreal's editor: Tools > Execute Python Script. Written by Chiaro {{ version }}; CC0 1.0."""

import os

import unreal

NAME = "{{ type_name }}"
FOLDER = "/Game/Chiaro"
# The box that the scene is in, in millimetres with z up.
LEAST = {{ box_min | tojson }}
GREATEST = {{ box_max | tojson }}
# Live numbers: name, what it is, default, least and greatest.
PARAMETERS = [
{% for parameter in parameters if not parameter.is_time %}
    ({{ parameter.name | tojson }}, {{ parameter.text | tojson }}, {{ parameter.default }}, {{ parameter.min }}, {{ parameter.max }}),
{% endfor %}
]
# Those that follow the clock, from 0 to 1 in eight seconds.
CLOCKS = [{% for parameter in parameters if parameter.is_time %}{{ parameter.name | tojson }}{{ ", " if not loop.last }}{% endfor %}]

editing = unreal.MaterialEditingLibrary


def custom_input(name):
    made = unreal.CustomInput()
    made.set_editor_property("input_name", name)
    return made


def custom_output(name, kind):
    made = unreal.CustomOutput()
    made.set_editor_property("output_name", name)
    made.set_editor_property("output_type", kind)
    return made


def make_material():
    """The material whose pixels look for the scene within the cube."""
    tools = unreal.AssetToolsHelpers.get_asset_tools()
    path = f"{FOLDER}/M_{NAME}"
    if unreal.EditorAssetLibrary.does_asset_exist(path):
        unreal.EditorAssetLibrary.delete_asset(path)
    material = tools.create_asset(f"M_{NAME}", FOLDER, unreal.Material, unreal.MaterialFactoryNew())
    material.set_editor_property("blend_mode", unreal.BlendMode.BLEND_MASKED)
    material.set_editor_property("tangent_space_normal", False)

    def node(kind, y, **properties):
        made = editing.create_material_expression(material, kind, -900, y)
        for name, value in properties.items():
            made.set_editor_property(name, value)
        return made

    def transformed(kind, source, y, **properties):
        made = node(kind, y, **properties)
        editing.connect_material_expressions(source, "", made, "")
        return made

    # The functions stand between two functions that Unreal writes for this node.
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "{{ name }}.ush"), encoding="utf-8") as file:
        functions = file.read()
    code = "return 0.0;\n}\n\n" + functions + "\n\nfloat " + NAME + "FunctionsEnd() {\nreturn 0.0;"
    library = node(unreal.MaterialExpressionCustom, -400, code=code, description=f"{NAME} functions",
                   output_type=unreal.CustomMaterialOutputType.CMOT_FLOAT1, inputs=[])

    to_local = {"transform_source_type": unreal.MaterialPositionTransformSource.TRANSFORMPOSSOURCE_WORLD,
                "transform_type": unreal.MaterialPositionTransformSource.TRANSFORMPOSSOURCE_LOCAL}
    position = transformed(unreal.MaterialExpressionTransformPosition, node(unreal.MaterialExpressionWorldPosition, 0), 0, **to_local)
    towards_eye = node(unreal.MaterialExpressionCameraVectorWS, 200)
    back = transformed(unreal.MaterialExpressionTransform, towards_eye, 200,
                       transform_source_type=unreal.MaterialVectorCoordTransformSource.TRANSFORMSOURCE_WORLD,
                       transform_type=unreal.MaterialVectorCoordTransform.TRANSFORM_LOCAL)
    back_in_view = transformed(unreal.MaterialExpressionTransform, towards_eye, 400,
                               transform_source_type=unreal.MaterialVectorCoordTransformSource.TRANSFORMSOURCE_WORLD,
                               transform_type=unreal.MaterialVectorCoordTransform.TRANSFORM_VIEW)
    depth = node(unreal.MaterialExpressionPixelDepth, 600)
    inputs = [("Library", library), ("Position", position), ("Back", back), ("BackInView", back_in_view), ("Depth", depth)]

    for i, (name, text, default, least, greatest) in enumerate(PARAMETERS):
        slider = node(unreal.MaterialExpressionScalarParameter, 800 + 100 * i, parameter_name=name, default_value=default,
                      slider_min=least, slider_max=greatest, desc=text)
        inputs.append((f"In_{name}", slider))
    if CLOCKS:
        clock = node(unreal.MaterialExpressionTime, 700)
        inputs += [(f"In_{name}", clock) for name in CLOCKS]

    values = "".join(f"{name} = In_{name};\n" for name, *_ in PARAMETERS)
    values += "".join(f"{name} = frac(In_{name} / 8.0);\n" for name in CLOCKS)
    trace = node(
        unreal.MaterialExpressionCustom, 0, description=NAME, output_type=unreal.CustomMaterialOutputType.CMOT_FLOAT3,
        inputs=[custom_input(name) for name, _ in inputs],
        additional_outputs=[
            custom_output("Emissive", unreal.CustomMaterialOutputType.CMOT_FLOAT3),
            custom_output("Metallic", unreal.CustomMaterialOutputType.CMOT_FLOAT1),
            custom_output("Roughness", unreal.CustomMaterialOutputType.CMOT_FLOAT1),
            custom_output("Mask", unreal.CustomMaterialOutputType.CMOT_FLOAT1),
            custom_output("LocalNormal", unreal.CustomMaterialOutputType.CMOT_FLOAT3),
            custom_output("DepthOffset", unreal.CustomMaterialOutputType.CMOT_FLOAT1),
        ],
        code=values + "SceneHit hit = MeetScene(Position, -Back, -BackInView.z, Depth / View.ViewSizeAndInvSize.y);\n"
        "Emissive = hit.Emissive;\nMetallic = hit.Metallic;\nRoughness = hit.Roughness;\nMask = hit.Mask;\n"
        "LocalNormal = hit.Normal;\nDepthOffset = hit.DepthOffset;\nreturn hit.BaseColor;")
    trace.set_editor_property("material_expression_editor_x", -500)
    for name, source in inputs:
        editing.connect_material_expressions(source, "", trace, name)

    turned = editing.create_material_expression(material, unreal.MaterialExpressionTransform, -250, 500)
    turned.set_editor_property("transform_source_type", unreal.MaterialVectorCoordTransformSource.TRANSFORMSOURCE_LOCAL)
    turned.set_editor_property("transform_type", unreal.MaterialVectorCoordTransform.TRANSFORM_WORLD)
    editing.connect_material_expressions(trace, "LocalNormal", turned, "")
    normal = editing.create_material_expression(material, unreal.MaterialExpressionNormalize, -100, 500)
    editing.connect_material_expressions(turned, "", normal, "")

    editing.connect_material_property(trace, "return", unreal.MaterialProperty.MP_BASE_COLOR)
    editing.connect_material_property(trace, "Emissive", unreal.MaterialProperty.MP_EMISSIVE_COLOR)
    editing.connect_material_property(trace, "Metallic", unreal.MaterialProperty.MP_METALLIC)
    editing.connect_material_property(trace, "Roughness", unreal.MaterialProperty.MP_ROUGHNESS)
    editing.connect_material_property(trace, "Mask", unreal.MaterialProperty.MP_OPACITY_MASK)
    editing.connect_material_property(normal, "", unreal.MaterialProperty.MP_NORMAL)
    editing.connect_material_property(trace, "DepthOffset", unreal.MaterialProperty.MP_PIXEL_DEPTH_OFFSET)
    editing.recompile_material(material)
    unreal.EditorAssetLibrary.save_loaded_asset(material)
    return material


def add_actor(material):
    """The engine's cube, as large as the box in centimetres."""
    centre = [0.05 * (a + b) for a, b in zip(LEAST, GREATEST)]
    size = [0.1 * (b - a) for a, b in zip(LEAST, GREATEST)]
    actor = unreal.EditorLevelLibrary.spawn_actor_from_class(
        unreal.StaticMeshActor, unreal.Vector(centre[0], -centre[1], centre[2]))
    actor.set_actor_label(NAME)
    actor.set_actor_scale3d(unreal.Vector(*[0.01 * x for x in size]))
    actor.static_mesh_component.set_static_mesh(unreal.load_asset("/Engine/BasicShapes/Cube"))
    actor.static_mesh_component.set_material(0, material)


add_actor(make_material())
