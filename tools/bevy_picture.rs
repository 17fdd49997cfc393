//! Runs the example of a crate that `chiaro export --to bevy` wrote, beside which it lies, until its shaders are compiled and it is
//! drawn; saves what the window shows, and ends: `bevy_picture FILE [picture]`. `tools/check_bevy.sh` calls it.

use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};

use bevy::prelude::*;
use bevy::render::render_resource::PipelineCache;
use bevy::render::view::screenshot::{Screenshot, ScreenshotCaptured, save_to_disk};
use bevy::render::{Render, RenderApp};

#[allow(dead_code)]
#[path = "show.rs"]
mod show;

/// So many frames are drawn after the last shader was compiled.
const FRAMES: u32 = 3;

/// How many frames were drawn since a shader had to be waited for.
#[derive(Resource, Clone, Default)]
struct Drawn(Arc<AtomicU32>);

/// Where the picture goes.
#[derive(Resource)]
struct File(String);

fn main() {
    let mut arguments = std::env::args().skip(1);
    let file = File(arguments.next().expect("bevy_picture FILE [picture]"));
    let drawn = Drawn::default();
    let mut app = show::app(arguments.any(|argument| argument == "picture"));
    app.sub_app_mut(RenderApp).insert_resource(drawn.clone()).add_systems(Render, count);
    // Scenes are seen in the format of our own pictures.
    let mut windows = app.world_mut().query::<&mut Window>();
    windows.iter_mut(app.world_mut()).for_each(|mut window| window.resolution.set(1280.0, 960.0));
    app.insert_resource(drawn).insert_resource(file).add_systems(Startup, stop_the_clock).add_systems(Update, photograph);
    app.run();
}

/// Scenes that move are compared where they start.
fn stop_the_clock(mut time: ResMut<Time<Virtual>>) {
    time.pause();
}

fn count(drawn: Res<Drawn>, pipelines: Res<PipelineCache>) {
    let is_waiting = pipelines.waiting_pipelines().next().is_some();
    drawn.0.store(if is_waiting { 0 } else { drawn.0.load(Ordering::Relaxed) + 1 }, Ordering::Relaxed);
}

fn photograph(mut commands: Commands, drawn: Res<Drawn>, file: Res<File>, mut is_taken: Local<bool>) {
    if *is_taken || drawn.0.load(Ordering::Relaxed) < FRAMES {
        return;
    }
    *is_taken = true;
    let end = |_: On<ScreenshotCaptured>, mut exit: MessageWriter<AppExit>| {
        exit.write(AppExit::Success);
    };
    commands.spawn(Screenshot::primary_window()).observe(save_to_disk(file.0.clone())).observe(end);
}
