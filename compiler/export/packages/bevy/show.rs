//! {{ title }} beside a cube on a floor, under a sun: `cargo run --example show`.
//! With `-- picture`, under its own lights.

use bevy::prelude::*;

use {{ name }}::*;

fn main() {
    let shows_picture = std::env::args().any(|argument| argument == "picture");
    app(shows_picture).run();
}

pub fn app(shows_picture: bool) -> App {
    let mut app = App::new();
    app.add_plugins((DefaultPlugins, {{ type_name }}Plugin));
    match shows_picture {
        true => app.add_systems(Startup, add_picture),
        false => app.add_systems(Startup, (add_solid, add_surroundings)),
    };
    app
}

fn add_picture(
    mut commands: Commands,
    mut meshes: ResMut<Assets<Mesh>>,
    mut pictures: ResMut<Assets<{{ type_name }}Picture>>,
) {
    let quad = Mesh3d(meshes.add(screen()));
    let picture = MeshMaterial3d(pictures.add({{ type_name }}Picture::default()));
    commands.spawn((quad, picture, always_in_view()));
    commands.spawn((Camera3d::default(), Msaa::Off, view()));
}

/// Bevy's shadows are made for metres: so the scene is shown about two metres large.
fn add_solid(
    mut commands: Commands,
    mut meshes: ResMut<Assets<Mesh>>,
    mut solids: ResMut<Assets<{{ type_name }}Material>>,
) {
    let scale = 2.0 / (GREATEST - LEAST).max_element();
    let centre = 0.5 * (LEAST + GREATEST);
    let on_the_floor = -scale * vec3(centre.x, LEAST.y, centre.z);
    let mesh = Mesh3d(meshes.add(proxy()));
    let solid = MeshMaterial3d(solids.add({{ type_name }}Material::default()));
    let place = Transform::from_translation(on_the_floor).with_scale(Vec3::splat(scale));
    commands.spawn((mesh, solid, place));
}

fn add_surroundings(
    mut commands: Commands,
    mut meshes: ResMut<Assets<Mesh>>,
    mut materials: ResMut<Assets<StandardMaterial>>,
) {
    let grey = MeshMaterial3d(materials.add(Color::srgb(0.7, 0.7, 0.7)));
    let floor = meshes.add(Plane3d::default().mesh().size(20.0, 20.0));
    commands.spawn((Mesh3d(floor), grey.clone()));
    let cube = meshes.add(Cuboid::from_length(0.8));
    commands.spawn((Mesh3d(cube), grey, Transform::from_xyz(1.8, 0.4, 0.6)));

    let sun = DirectionalLight {
        shadow_maps_enabled: true,
        ..default()
    };
    let above = Transform::from_xyz(3.0, 5.0, 2.0);
    commands.spawn((sun, above.looking_at(Vec3::ZERO, Vec3::Y)));
    let aside = Transform::from_xyz(2.5, 2.5, 5.0);
    let target = vec3(0.3, 0.7, 0.0);
    commands.spawn((Camera3d::default(), aside.looking_at(target, Vec3::Y)));
}
