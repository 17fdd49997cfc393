//! Work of some length, off the window's thread.

use std::any::Any;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::thread::JoinHandle;

use egui::Context;

/// Work under way on a thread of its own.
pub(crate) struct Job<T> {
    thread: Option<JoinHandle<T>>,
    pub(crate) progress: Arc<Progress>,
}

/// How far some work is, and whether it is still wanted.
pub(crate) struct Progress {
    done: AtomicU64,
    all: AtomicU64,
    cancelled: AtomicBool,
    context: Context,
}

impl<T: Send + 'static> Job<T> {
    /// Begins. The window wakes when it is done.
    pub(crate) fn start(
        context: &Context,
        work: impl FnOnce(&Progress) -> T + Send + 'static,
    ) -> std::io::Result<Self> {
        let progress = Arc::new(Progress {
            done: AtomicU64::new(0),
            all: AtomicU64::new(0),
            cancelled: AtomicBool::new(false),
            context: context.clone(),
        });
        let shared = progress.clone();
        let thread = std::thread::Builder::new().name("worker".to_owned()).spawn(move || {
            // (The window is woken even if the work panics.)
            let _wake = Wake(shared.context.clone());
            work(&shared)
        })?;
        Ok(Self { thread: Some(thread), progress })
    }

    /// What it came to, once; a panic becomes its message.
    pub(crate) fn poll(&mut self) -> Option<Result<T, String>> {
        if self.thread.as_ref().is_some_and(|thread| !thread.is_finished()) {
            // It wakes the window just before it is finished.
            self.progress.context.request_repaint_after(std::time::Duration::from_millis(50));
            return None;
        }
        let result = self.thread.take()?.join();
        Some(result.map_err(|panic| mistake(&*panic)))
    }
}

/// What a panic has to say to the user.
pub(crate) fn mistake(panic: &(dyn Any + Send)) -> String {
    let message = panic.downcast_ref::<String>().map(String::as_str);
    let message = message.or_else(|| panic.downcast_ref::<&str>().copied()).unwrap_or("for an unknown reason");
    format!("this is a mistake in Chiaro, not in your scene: {message}")
}

impl Progress {
    /// Says how many steps there are.
    pub(crate) fn expect(&self, all: u64) {
        self.all.store(all, Ordering::Relaxed);
    }

    /// So many of so many steps are done.
    pub(crate) fn show(&self, done: usize, of: usize) {
        self.all.store(of as u64, Ordering::Relaxed);
        self.done.store(done as u64, Ordering::Relaxed);
        self.context.request_repaint();
    }

    /// A step is done.
    pub(crate) fn step(&self) {
        self.done.fetch_add(1, Ordering::Relaxed);
        self.context.request_repaint();
    }

    /// From 0 to 1.
    pub(crate) fn part(&self) -> f32 {
        self.done.load(Ordering::Relaxed) as f32 / self.all.load(Ordering::Relaxed).max(1) as f32
    }

    /// Nobody wants it any more.
    pub(crate) fn cancel(&self) {
        self.cancelled.store(true, Ordering::Relaxed);
    }

    pub(crate) fn is_cancelled(&self) -> bool {
        self.cancelled.load(Ordering::Relaxed)
    }
}

struct Wake(Context);

impl Drop for Wake {
    fn drop(&mut self) {
        self.0.request_repaint();
    }
}
