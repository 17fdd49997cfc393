//! The frame of dialogs that write files: a form, then how far the work is and a way to end it, then what came of it.

use std::path::PathBuf;

use egui::{Align2, Context, Id, ProgressBar, Ui, Window};

use super::overwrite::Overwrite;
use crate::app::Editor;
use crate::worker::{Job, Progress};

/// The width of the dialogs, in points.
const WIDTH: f32 = 440.0;
/// The width of the bar that shows how far the work is, in points.
const BAR: f32 = 280.0;

/// What the user fills in, and what is made of it.
pub(crate) trait Form {
    /// The window's title, which is what its button does.
    fn title(&self) -> &'static str;

    /// Keeps up with which scene is drawn. True if it is another one.
    fn follow(&mut self, editor: &Editor) -> bool;

    /// Shows the controls. True if what came of the work before says nothing about what is chosen now.
    fn controls(&mut self, ui: &mut Ui) -> bool;

    /// What would be written over.
    fn occupied(&self) -> Option<PathBuf>;

    /// The work as the form is filled in; none, if there is no scene. What stands beside its file is written over only if it
    /// `replaces`.
    fn work(&self, editor: &Editor, replaces: bool) -> Option<Work>;

    /// What to say when it is done.
    fn done(&self) -> String;
}

/// Work that writes files: an error says what went wrong; there is none if it was cancelled.
pub(crate) type Work = Box<dyn FnOnce(&Progress) -> Result<(), String> + Send>;

/// A dialog.
pub(crate) struct Writing {
    form: Box<dyn Form>,
    job: Option<Job<Result<(), String>>>,
    /// What is to be written over, if the user says so.
    overwrite: Option<Overwrite>,
    /// What came of the last job.
    outcome: Option<Result<String, String>>,
}

impl Writing {
    pub(crate) fn new(form: impl Form + 'static) -> Self {
        Self { form: Box::new(form), job: None, overwrite: None, outcome: None }
    }

    /// Whether something is being written.
    pub(super) fn is_busy(&self) -> bool {
        self.job.is_some()
    }

    /// Whether an answer is needed before anything else.
    pub(super) fn is_asking(&self) -> bool {
        self.overwrite.is_some()
    }

    /// Begins, after asking if something would be written over.
    fn ask_to_start(&mut self, editor: &Editor, context: &Context) {
        self.outcome = None;
        self.overwrite = self.form.occupied().map(Overwrite::new);
        if self.overwrite.is_none() {
            self.start(editor, context, false);
        }
    }

    fn answer(&mut self, editor: &Editor, context: &Context) {
        let Some(answer) = self.overwrite.as_ref().and_then(|overwrite| overwrite.ask(context)) else { return };
        self.overwrite = None;
        if answer {
            self.start(editor, context, true);
        }
    }

    fn start(&mut self, editor: &Editor, context: &Context, replaces: bool) {
        match self.form.work(editor, replaces).map(|work| Job::start(context, work)) {
            Some(Ok(job)) => self.job = Some(job),
            Some(Err(error)) => self.outcome = Some(Err(error.to_string())),
            None => self.outcome = Some(Err("there is no scene without errors yet".to_owned())),
        }
    }

    fn poll(&mut self) {
        let Some(result) = self.job.as_mut().and_then(Job::poll) else { return };
        let is_cancelled = self.job.take().is_some_and(|job| job.progress.is_cancelled());
        self.outcome = Some(match result.and_then(|result| result) {
            Ok(()) if is_cancelled => Err("cancelled: nothing is written".to_owned()),
            Ok(()) => Ok(self.form.done()),
            Err(reason) => Err(reason),
        });
    }

    /// Closes it. What is at work is cancelled.
    pub(super) fn close(self) {
        if let Some(job) = &self.job {
            job.progress.cancel();
        }
    }

    /// Keeps up with which scene is drawn, but for the work that began with another one.
    fn follow(&mut self, editor: &Editor) {
        // What was written is there all the same.
        if self.job.is_none() && self.overwrite.is_none() && self.form.follow(editor) {
            self.outcome.take_if(|outcome| outcome.is_err());
        }
    }

    fn contents(&mut self, editor: &Editor, ui: &mut Ui) {
        let is_another = ui.add_enabled_ui(self.job.is_none(), |ui| self.form.controls(ui)).inner;
        if is_another {
            self.outcome = None;
        }
        ui.add_space(8.0);
        ui.horizontal(|ui| match &self.job {
            Some(job) => under_way(ui, &job.progress),
            None => {
                if ui.button(self.form.title()).clicked() {
                    self.ask_to_start(editor, ui.ctx());
                }
            }
        });
        self.tell(ui);
    }

    /// What came of the last job.
    fn tell(&self, ui: &mut Ui) {
        match &self.outcome {
            Some(Ok(message)) => ui.label(message),
            Some(Err(message)) => ui.colored_label(ui.visuals().error_fg_color, message),
            None => return,
        };
    }
}

/// Shows the dialog that is open, if one is.
pub(super) fn show(editor: &mut Editor, context: &Context) {
    let Some(mut writing) = editor.dialogs.writing.take() else { return };
    writing.poll();
    writing.follow(editor);
    writing.answer(editor, context);
    let mut is_open = true;
    let window = Window::new(writing.form.title()).id(id()).open(&mut is_open).collapsible(false).resizable(false);
    let middle = context.content_rect().center();
    window.pivot(Align2::CENTER_CENTER).default_pos(middle).show(context, |ui| {
        ui.set_width(WIDTH);
        writing.contents(editor, ui);
    });
    if is_open {
        editor.dialogs.writing = Some(writing);
    } else {
        writing.close();
    }
}

/// The window's id.
pub(super) fn id() -> Id {
    Id::unique("writing")
}

/// How far the work is, and a way to end it.
fn under_way(ui: &mut Ui, progress: &Progress) {
    ui.add(ProgressBar::new(progress.part()).desired_width(BAR).show_percentage());
    if ui.button("Cancel").clicked() {
        progress.cancel();
    }
}
