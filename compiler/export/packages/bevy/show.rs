//! {{ title }} beside a cube on a floor, under a sun: `cargo run --example show`; with `-- picture`, under its own lights.

use bevy::prelude::*;
use {{ name }}::*;

fn main() {
    let shows_picture = std::env::args().any(|argument| argument == "picture");
    let mut app = App::new();
    app.add_plugins((DefaultPlugins, {{ type_name }}Plugin));
    match shows_picture {
        true => app.add_systems(Startup, add_picture),
        false => app.add_systems(Startup, add_solid),
    };
    app.run();
}

fn add_picture(mut commands: Commands, mut meshes: ResMut<Assets<Mesh>>, mut pictures: ResMut<Assets<{{ type_name }}Picture>>) {
    let (quad, always) = screen();
    commands.spawn((Mesh3d(meshes.add(quad)), MeshMaterial3d(pictures.add({{ type_name }}Picture::default())), always));
    commands.spawn((Camera3d::default(), Msaa::Off, view()));
}

fn add_solid(
    mut commands: Commands,
    mut meshes: ResMut<Assets<Mesh>>,
    mut solids: ResMut<Assets<{{ type_name }}Material>>,
    mut materials: ResMut<Assets<StandardMaterial>>,
) {
    let size = (GREATEST - LEAST).max_element();
    let centre = 0.5 * (LEAST + GREATEST);
    // Bevy's shadows are made for metres: so the scene is shown about two metres large.
    let scale = 2.0 / size;
    let placed = Transform::from_scale(Vec3::splat(scale)).with_translation(-scale * vec3(centre.x, LEAST.y, centre.z));
    commands.spawn((Mesh3d(meshes.add(proxy())), MeshMaterial3d(solids.add({{ type_name }}Material::default())), placed));

    let grey = materials.add(Color::srgb(0.7, 0.7, 0.7));
    commands.spawn((Mesh3d(meshes.add(Plane3d::default().mesh().size(20.0, 20.0))), MeshMaterial3d(grey.clone())));
    let beside = Transform::from_xyz(1.8, 0.4, 0.6);
    commands.spawn((Mesh3d(meshes.add(Cuboid::from_length(0.8))), MeshMaterial3d(grey), beside));
    let sun = DirectionalLight { shadow_maps_enabled: true, ..default() };
    commands.spawn((sun, Transform::from_xyz(3.0, 5.0, 2.0).looking_at(Vec3::ZERO, Vec3::Y)));
    commands.spawn((Camera3d::default(), Transform::from_xyz(2.5, 2.5, 5.0).looking_at(vec3(0.3, 0.7, 0.0), Vec3::Y)));
}
