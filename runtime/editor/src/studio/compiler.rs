//! The thread that compiles.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use chiaro_compiler::{Compilation, Scene, compile};
use chiaro_render::{Error, Gpu, Model, Preference};

use super::{BufferWorld, Compiled, Event, Program, Shared, Subject, Timings, guarded, lock};

/// Compiles programs until the window is closed.
pub(crate) fn work(shared: &Shared, preference: &Preference) {
    let mut workshop = Workshop::default();
    while let Some(program) = shared.programs.take() {
        if let Err(message) = guarded(|| compile_and_hand_over(shared, preference, &mut workshop, program)) {
            shared.say(Event::Trouble(message));
        }
    }
}

/// Text to field graph, which the window hears of; then to pipelines, which the drawing thread gets.
fn compile_and_hand_over(shared: &Shared, preference: &Preference, workshop: &mut Workshop, program: Program) {
    let asked = Instant::now();
    let cancelled = Arc::new(AtomicBool::new(false));
    *lock(&shared.cancelled) = cancelled.clone();
    let options = chiaro_compiler::Options { cancelled: Some(cancelled.clone()), ..program.options };
    let world = BufferWorld::new(program.buffers);
    let Compilation { sources, diagnostics, scene } = compile(&world, &program.main, &options);
    if cancelled.load(Ordering::Relaxed) {
        return;
    }
    let (revision, scene) = (program.revision, scene.map(Arc::new));
    let mut timings = Timings { asked: Some(asked), compile: asked.elapsed(), ..Timings::default() };
    let sources = Arc::new(sources);
    let compiled = Compiled { revision, sources: sources.clone(), diagnostics, scene: scene.clone() };
    shared.say(Event::Compiled(Box::new(compiled)));

    let Some(scene) = scene else { return };
    let begun = Instant::now();
    match workshop.model(shared, preference, &scene) {
        Ok((gpu, model)) => {
            timings.pipelines = begun.elapsed();
            let notes = model.notes(&scene.picture());
            if !notes.is_empty() {
                shared.say(Event::Noted { revision, notes });
            }
            let subject = Subject { revision, scene: scene.clone(), gpu, model, timings };
            shared.orders.update(|order| order.get_or_insert_default().subject = Some(subject));
        }
        Err(error) => {
            if matches!(error, Error::Lost(_) | Error::Stuck(_)) {
                *workshop = Workshop::default();
            }
            return shared.say(Event::Trouble(error.to_string()));
        }
    }
    // The picture doesn't wait for this.
    match scene.provenance(&sources) {
        Ok(provenance) => shared.say(Event::Linked { revision, provenance: Arc::new(provenance) }),
        Err(error) => shared.say(Event::Trouble(error.to_string())),
    }
}

/// The device, and what was made last on it.
#[derive(Default)]
struct Workshop {
    gpu: Option<Gpu>,
    model: Option<Model>,
}

impl Workshop {
    /// The model of a scene: the last one, if only places of the text changed, or the value of a live number.
    fn model(
        &mut self,
        shared: &Shared,
        preference: &Preference,
        scene: &Scene,
    ) -> chiaro_render::Result<(Gpu, Model)> {
        let gpu = self.opened(shared, preference)?;
        let graph = scene.picture();
        let model = match self.model.take().filter(|model| model.is_of(&graph)) {
            Some(model) => model,
            None => Model::new(&gpu, &graph, &scene.defaults())?,
        };
        self.model = Some(model.clone());
        Ok((gpu, model))
    }

    /// The device, opened when first asked for and after it was lost.
    fn opened(&mut self, shared: &Shared, preference: &Preference) -> chiaro_render::Result<Gpu> {
        if shared.device_lost.swap(false, Ordering::SeqCst) {
            *self = Self::default();
        }
        if let Some(gpu) = &self.gpu {
            return Ok(gpu.clone());
        }
        let opened = open(preference)?;
        shared.say(Event::Device(opened.description().name.clone()));
        self.gpu = Some(opened.clone());
        Ok(opened)
    }
}

/// Opens the device on a thread that gives way to the window's, since those that a software adapter draws with are as
/// polite as the one that opened it.
fn open(preference: &Preference) -> chiaro_render::Result<Gpu> {
    let polite = || {
        super::give_way();
        Gpu::new(preference)
    };
    std::thread::scope(|scope| scope.spawn(polite).join()).unwrap_or(Err(Error::NoDriver))
}
