//! {{ title }} for Bevy: a solid that Bevy lights, with depth and shadows, and the same under its own lights.
//!
//! Lengths are metres with y up: a scene's millimetre is 0.001. Written by Chiaro {{ version }}.

use bevy::asset::{embedded_asset, uuid_handle};
use bevy::camera::visibility::NoFrustumCulling;
use bevy::light::NotShadowCaster;
use bevy::mesh::MeshVertexBufferLayoutRef;
use bevy::pbr::{MaterialPipeline, MaterialPipelineKey};
use bevy::prelude::*;
{% if parameters %}
use bevy::render::render_resource::ShaderType;
{% endif %}
use bevy::render::render_resource::{AsBindGroup, Face};
use bevy::render::render_resource::{RenderPipelineDescriptor, SpecializedMeshPipelineError};
use bevy::shader::{Shader, ShaderRef, ValidateShader};

/// The least corner of the box that the scene is in, in metres.
pub const LEAST: Vec3 = vec3({{ (box_min[0] / 1000) | float }}, {{ (box_min[2] / 1000) | float }}, {{ (-box_max[1] / 1000) | float }});
/// Its greatest corner.
pub const GREATEST: Vec3 = vec3({{ (box_max[0] / 1000) | float }}, {{ (box_max[2] / 1000) | float }}, {{ (-box_min[1] / 1000) | float }});

/// The shader of the picture.
const PICTURE: Handle<Shader> = uuid_handle!("{{ name | uuid }}");

/// Adds the scene's materials.
pub struct {{ type_name }}Plugin;

impl Plugin for {{ type_name }}Plugin {
    fn build(&self, app: &mut App) {
        embedded_asset!(app, "{{ name }}.wgsl");
        embedded_asset!(app, "{{ name }}_depth.wgsl");
        let mut shaders = app.world_mut().resource_mut::<Assets<Shader>>();
        shaders.insert(&PICTURE, picture_shader()).unwrap();
        app.add_plugins(MaterialPlugin::<{{ type_name }}Material>::default());
        app.add_plugins(MaterialPlugin::<{{ type_name }}Picture>::default());
{% for parameter in parameters if parameter.is_time %}
        app.add_systems(Update, follow_the_clock);
{% endfor %}
    }
}

/// Its loops are bounded by naga, as unbounded Mesa's software driver (22.3) draws wrong pixels.
fn picture_shader() -> Shader {
    let path = "{{ name }}_picture.wgsl";
    let mut shader = Shader::from_wgsl(include_str!("{{ name }}_picture.wgsl"), path);
    shader.validate_shader = ValidateShader::Enabled;
    shader
}

{% if parameters %}
/// The scene's live numbers.
#[derive(ShaderType, Reflect, Clone, Copy, Debug, PartialEq)]
pub struct {{ type_name }}Numbers {
{% for parameter in parameters %}
    /// {{ parameter.text }}
    pub {{ parameter.name }}: f32,
{% endfor %}
}

impl Default for {{ type_name }}Numbers {
    fn default() -> Self {
{# As rustfmt has it: what is short stays in its line. #}
{% set line %}{% for parameter in parameters %}{{ ", " if not loop.first }}{{ parameter.name }}: {{ parameter.default | float }}{% endfor %}{% endset %}
{% if line | length <= 18 %}
        Self { {{ line }} }
{% else %}
        Self {
{% for parameter in parameters %}
            {{ parameter.name }}: {{ parameter.default | float }},
{% endfor %}
        }
{% endif %}
    }
}

{% endif %}
/// What makes a box of [`proxy`] look like the scene, lit by Bevy.
#[derive(Asset, TypePath, AsBindGroup, Clone, Debug, Default)]
{% if parameters %}
pub struct {{ type_name }}Material {
    /// The live numbers.
    #[uniform(0)]
    pub numbers: {{ type_name }}Numbers,
}
{% else %}
pub struct {{ type_name }}Material {}
{% endif %}

impl Material for {{ type_name }}Material {
    fn fragment_shader() -> ShaderRef {
        "embedded://{{ name }}/{{ name }}.wgsl".into()
    }

    fn prepass_fragment_shader() -> ShaderRef {
        "embedded://{{ name }}/{{ name }}_depth.wgsl".into()
    }

    /// Rays that miss the scene are discarded, in shadow maps too.
    fn alpha_mode(&self) -> AlphaMode {
        AlphaMode::Mask(0.5)
    }

    /// Back faces are drawn, so that the eye may be within the box.
    fn specialize(
        _: &MaterialPipeline,
        descriptor: &mut RenderPipelineDescriptor,
        _: &MeshVertexBufferLayoutRef,
        _: MaterialPipelineKey<Self>,
    ) -> Result<(), SpecializedMeshPipelineError> {
        descriptor.primitive.cull_mode = Some(Face::Front);
        Ok(())
    }
}

/// What fills the view with the scene under its own lights: on a [`screen`] that is [`always_in_view`].
/// It does not light what else is there, but is hidden by it and hides it.
#[derive(Asset, TypePath, AsBindGroup, Clone, Debug, Default)]
{% if parameters %}
pub struct {{ type_name }}Picture {
    /// The live numbers.
    #[uniform(0)]
    pub numbers: {{ type_name }}Numbers,
}
{% else %}
pub struct {{ type_name }}Picture {}
{% endif %}

impl Material for {{ type_name }}Picture {
    fn vertex_shader() -> ShaderRef {
        PICTURE.into()
    }

    fn fragment_shader() -> ShaderRef {
        PICTURE.into()
    }

    fn enable_prepass() -> bool {
        false
    }
}

/// The box that the material is for.
pub fn proxy() -> Mesh {
    Mesh::from(Cuboid::from_corners(LEAST, GREATEST)).translated_by(0.5 * (LEAST + GREATEST))
}

/// The quad that the picture is for: its corners are the view's.
pub fn screen() -> Mesh {
    Mesh::from(Rectangle::new(2.0, 2.0))
}

/// What a [`screen`] needs, as it is nowhere in the world.
pub fn always_in_view() -> impl Bundle {
    (NoFrustumCulling, NotShadowCaster)
}

/// The scene's own view: the camera's place and its projection.
pub fn view() -> (Transform, Projection) {
    let eye = vec3({{ (eye[0] / 1000) | float }}, {{ (eye[2] / 1000) | float }}, {{ (-eye[1] / 1000) | float }});
    let target = vec3({{ (target[0] / 1000) | float }}, {{ (target[2] / 1000) | float }}, {{ (-target[1] / 1000) | float }});
    let up = vec3({{ up[0] | float }}, {{ up[2] | float }}, {{ (-up[1]) | float }});
    let projection = PerspectiveProjection {
        fov: {{ field_of_view | float }}_f32.to_radians(),
        near: 0.02 * eye.distance(target),
        ..default()
    };
    let place = Transform::from_translation(eye).looking_at(target, up);
    (place, Projection::Perspective(projection))
}
{% for parameter in parameters if parameter.is_time %}

/// Time goes from 0 to 1 in eight seconds, again and again.
fn follow_the_clock(
    time: Res<Time>,
    mut materials: ResMut<Assets<{{ type_name }}Material>>,
    mut pictures: ResMut<Assets<{{ type_name }}Picture>>,
) {
    let now = (time.elapsed_secs() / 8.0).fract();
    for (_, material) in materials.iter_mut() {
        material.numbers.{{ parameter.name }} = now;
    }
    for (_, picture) in pictures.iter_mut() {
        picture.numbers.{{ parameter.name }} = now;
    }
}
{% endfor %}
