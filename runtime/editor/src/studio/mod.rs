//! What compiles and draws, off the window's thread.
//!
//! The window says what it wants, and reads [`Event`]s. A request that is not begun yet when a newer one comes is
//! forgotten; a compilation under way is stopped.

mod compiler;
mod drawer;
#[cfg(test)]
pub(crate) mod sabotage;
mod slot;
mod timings;
mod wanted;
mod world;

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::JoinHandle;

use chiaro_compiler::syntax::{Diagnostic, Sources};
use chiaro_compiler::{Provenance, Scene};
use chiaro_render::{Gpu, Legend, Mask, Model, Preference, View};

use crate::worker;
use slot::Slot;
pub(crate) use timings::Timings;
pub(crate) use wanted::{Eye, LiveValue, Look, Outlined, Wanted};
pub(crate) use world::{BufferWorld, Buffers};

/// A program to compile.
#[derive(Clone, Debug)]
pub(crate) struct Program {
    /// Which state of the texts this is; it only grows.
    pub(crate) revision: u64,
    /// The scene's file.
    pub(crate) main: String,
    /// The texts that are open, which count instead of the files of their names.
    pub(crate) buffers: Buffers,
    pub(crate) options: chiaro_compiler::Options,
}

/// What compiling came to.
#[derive(Debug)]
pub(crate) struct Compiled {
    pub(crate) revision: u64,
    pub(crate) sources: Arc<Sources>,
    pub(crate) diagnostics: Vec<Diagnostic>,
    /// The scene, if there is no error.
    pub(crate) scene: Option<Arc<Scene>>,
}

/// A scene that can be drawn.
#[derive(Clone, Debug)]
pub(crate) struct Subject {
    pub(crate) revision: u64,
    pub(crate) scene: Arc<Scene>,
    pub(crate) gpu: Gpu,
    pub(crate) model: Model,
    pub(crate) timings: Timings,
}

impl Subject {
    /// Whether a picture of the other one can become one of this: their pipelines are the same, and both have lights of their
    /// own or neither has.
    fn is_drawn_like(&self, other: &Subject) -> bool {
        self.model.is_clone_of(&other.model) && self.scene.lights.is_empty() == other.scene.lights.is_empty()
    }
}

/// What the drawing thread is asked for; what stays as it is, is left out.
#[derive(Debug, Default)]
pub(crate) struct Order {
    pub(crate) subject: Option<Subject>,
    pub(crate) wanted: Option<Wanted>,
}

/// A picture.
#[derive(Debug)]
pub(crate) struct Frame {
    pub(crate) revision: u64,
    /// What is seen.
    pub(crate) scene: Arc<Scene>,
    /// Width and height in pixels: less than wanted while something moves.
    pub(crate) size: [u32; 2],
    /// Eight bits of sRGB and alpha each, rows from the top.
    pub(crate) rgba: Vec<u8>,
    /// The same with the other light algorithm, if two are compared.
    pub(crate) other: Option<Vec<u8>>,
    /// What the colours mean, if the scene is not lit.
    pub(crate) legend: Option<Legend>,
    /// Which pixels show what is outlined.
    pub(crate) mask: Option<(Outlined, Mask)>,
    /// What `#` highlights: bytes as those of the picture.
    pub(crate) highlight: Option<Vec<u8>>,
    /// What was wanted, and what that came to of the view.
    pub(crate) wanted: Wanted,
    pub(crate) view: View,
    pub(crate) samples: u32,
    pub(crate) timings: Timings,
}

/// What the threads have to say.
#[derive(Debug)]
pub(crate) enum Event {
    /// A program was compiled, with or without success.
    Compiled(Box<Compiled>),
    /// What links the scene of a revision to its text.
    Linked {
        /// The scene's.
        revision: u64,
        /// The link.
        provenance: Arc<Provenance>,
    },
    /// What there is to say of how a scene is drawn.
    Noted {
        /// The scene's.
        revision: u64,
        notes: Vec<Diagnostic>,
    },
    /// A picture got newer or better.
    Frame(Box<Frame>),
    /// Something went wrong that is not the text's fault; the picture before stays.
    Trouble(String),
    /// What draws, once it is known, or was opened anew.
    Device(String),
}

/// The two threads, and the way to them.
pub(crate) struct Studio {
    shared: Arc<Shared>,
    events: Receiver<Event>,
    threads: Vec<JoinHandle<()>>,
}

/// What the threads share with each other and with the window.
pub(crate) struct Shared {
    programs: Slot<Program>,
    orders: Slot<Order>,
    /// The program compiled last, to be compiled again after the device was lost.
    last_program: Mutex<Option<Program>>,
    /// Stops the compilation under way.
    cancelled: Mutex<Arc<AtomicBool>>,
    device_lost: AtomicBool,
    sender: Sender<Event>,
    /// Makes the window look at the events.
    wake: Box<dyn Fn() + Send + Sync>,
    #[cfg(test)]
    pub(crate) sabotage: sabotage::Sabotage,
}

impl Studio {
    /// Starts the threads; `wake` is called after every event.
    pub(crate) fn new(preference: Preference, wake: impl Fn() + Send + Sync + 'static) -> std::io::Result<Self> {
        let (sender, events) = channel();
        let shared = Arc::new(Shared {
            programs: Slot::new(),
            orders: Slot::new(),
            last_program: Mutex::default(),
            cancelled: Mutex::default(),
            device_lost: AtomicBool::new(false),
            sender,
            wake: Box::new(wake),
            #[cfg(test)]
            sabotage: sabotage::Sabotage::default(),
        });
        let (compiling, drawing) = (shared.clone(), shared.clone());
        let builder = |name: &str| std::thread::Builder::new().name(name.to_owned());
        let threads = vec![
            builder("compiling").spawn(move || compiler::work(&compiling, &preference))?,
            builder("drawing").spawn(move || {
                give_way();
                drawer::work(&drawing);
            })?,
        ];
        Ok(Self { shared, events, threads })
    }

    /// Compiles a program, instead of any asked for before.
    pub(crate) fn compile(&self, program: Program) {
        self.shared.compile(program);
    }

    /// Draws this from now on.
    pub(crate) fn show(&self, wanted: Wanted) {
        self.shared.orders.update(|order| order.get_or_insert_default().wanted = Some(wanted));
    }

    /// What goes wrong in tests.
    #[cfg(test)]
    pub(crate) fn sabotage(&self) -> &sabotage::Sabotage {
        &self.shared.sabotage
    }

    /// What happened since the last call.
    pub(crate) fn events(&self) -> Vec<Event> {
        self.events.try_iter().collect()
    }
}

impl Drop for Studio {
    fn drop(&mut self) {
        self.shared.stop_compiling();
        self.shared.programs.close();
        self.shared.orders.close();
        for thread in self.threads.drain(..) {
            // A thread that panicked has nothing more to say.
            let _ = thread.join();
        }
    }
}

impl Shared {
    fn compile(&self, program: Program) {
        *lock(&self.last_program) = Some(program.clone());
        self.stop_compiling();
        self.programs.put(program);
    }

    fn stop_compiling(&self) {
        lock(&self.cancelled).store(true, Ordering::Relaxed);
    }

    /// Opens the device anew for what comes, and for the last program if that may try again.
    fn reopen(&self, tries_again: bool) {
        if self.device_lost.swap(true, Ordering::SeqCst) || !tries_again {
            return;
        }
        let last = lock(&self.last_program).clone();
        if let Some(program) = last {
            self.compile(program);
        }
    }

    fn say(&self, event: Event) {
        // Nobody listens any more when the window is being closed.
        let _ = self.sender.send(event);
        (self.wake)();
    }
}

/// Runs work of a thread that must go on whatever a scene does to it. A panic becomes its message.
fn guarded<T>(work: impl FnOnce() -> T) -> Result<T, String> {
    std::panic::catch_unwind(std::panic::AssertUnwindSafe(work)).map_err(|panic| worker::mistake(&*panic))
}

fn lock<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Lets the window's thread go first, where threads have priorities of their own: typing must not wait for pictures.
fn give_way() {
    #[cfg(target_os = "linux")]
    if let Err(reason) = rustix::process::setpriority_process(None, 5) {
        log::debug!("drawing is as important as the window: {reason}");
    }
}
