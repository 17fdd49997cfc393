//! What is open, what it compiled to, and what is being drawn: the editor without its window.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};

use chiaro_compiler::syntax::{Diagnostic, Severity, Sources};
use chiaro_compiler::{LiveLiteral, Provenance, Scene};
use chiaro_render::Preference;

use crate::disk::Watch;
use crate::document::{Document, DocumentId};
use crate::live_edit::number_edit;
use crate::studio::{Buffers, Event, Frame, LiveValue, Program, Studio, Wanted};

/// So long after the last edit of a number, the text is compiled as it stands: for its messages, and for its places.
const SETTLED: Duration = Duration::from_millis(900);

/// The open texts and their scene.
pub(crate) struct Session {
    /// Never empty.
    documents: Vec<Document>,
    active: usize,
    /// Which of them is drawn.
    scene: DocumentId,
    studio: Studio,
    watch: Watch,
    running: Option<Running>,
    revision: u64,
    /// The first revision of the text that is drawn since it is.
    scene_since: u64,
    /// Which state of the texts the newest picture is of.
    drawn: u64,
    /// What the command line said about top-level variables.
    given: Vec<(String, String)>,
    /// Values of parameters that are not the text's, by name: expressions of the language.
    pub(crate) definitions: BTreeMap<String, String>,
    /// Values of live numbers that are not the text's.
    pub(crate) values: Vec<LiveValue>,
    /// What compiling came to last.
    pub(crate) outcome: Option<Outcome>,
    /// The last scene without errors of the text that is drawn.
    pub(crate) shown: Option<Shown>,
    /// The newest picture, until somebody takes it.
    pub(crate) frame: Option<Box<Frame>>,
    /// What went wrong with the scene that is not the text's fault.
    pub(crate) trouble: Option<String>,
    /// What the user asked for last and could not be done, such as saving.
    pub(crate) failure: Option<String>,
    /// What draws.
    pub(crate) device: String,
    wanted: Wanted,
}

/// What the compiler was asked for last.
struct Running {
    since: Instant,
    /// The scene's own text when it was asked.
    text: String,
    live: Option<LiveLiteral>,
    /// The live number's value, if it moved since.
    moved: Option<LiveValue>,
    /// When a number was edited last, if the text has to be compiled as it stands.
    settles_after: Option<Instant>,
}

/// What compiling a text came to.
pub(crate) struct Outcome {
    /// The text that was drawn.
    document: DocumentId,
    pub(crate) revision: u64,
    pub(crate) sources: Arc<Sources>,
    pub(crate) diagnostics: Vec<Diagnostic>,
}

/// A scene that compiled.
pub(crate) struct Shown {
    /// The text that is drawn.
    pub(crate) document: DocumentId,
    pub(crate) revision: u64,
    pub(crate) sources: Arc<Sources>,
    pub(crate) scene: Arc<Scene>,
    /// What links it to its text, as soon as that is known.
    pub(crate) provenance: Option<Arc<Provenance>>,
}

impl Session {
    /// An empty text. `wake` is called when there is something to look at.
    pub(crate) fn new(
        preference: Preference,
        wake: impl Fn() + Send + Sync + Clone + 'static,
    ) -> std::io::Result<Self> {
        let document = Document::new(None, String::new());
        Ok(Self {
            scene: document.id,
            documents: vec![document],
            active: 0,
            studio: Studio::new(preference, wake.clone())?,
            watch: Watch::new(wake),
            running: None,
            revision: 0,
            scene_since: 0,
            drawn: 0,
            given: Vec::new(),
            definitions: BTreeMap::new(),
            values: Vec::new(),
            outcome: None,
            shown: None,
            frame: None,
            trouble: None,
            failure: None,
            device: String::new(),
            wanted: Wanted::default(),
        })
    }

    /// Opens a file beside what is open, or shows it if it is open already. An error says why it can't be read.
    pub(crate) fn open(&mut self, path: &Path) -> Result<(), String> {
        let document = Document::open(path).map_err(|reason| format!("cannot read {}: {reason}", path.display()))?;
        match self.documents.iter().position(|open| open.path == document.path) {
            Some(index) => self.activate(index),
            None => self.add(document),
        }
        self.watch_files();
        Ok(())
    }

    /// Opens a text that has no file yet, and is called something like that until it has.
    pub(crate) fn open_text(&mut self, title: &str, text: String) {
        let (stem, ending) = title.rsplit_once('.').unwrap_or((title, "csg"));
        let is_taken = |open: &Document, title: &String| open.path.is_none() && open.working_title == *title;
        let is_free = |title: &String| self.is_blank() || !self.documents.iter().any(|open| is_taken(open, title));
        let numbered = (2..).map(|number| format!("{stem}_{number}.{ending}"));
        let mut titles = std::iter::once(title.to_owned()).chain(numbered);
        let mut document = Document::new(None, text);
        if let Some(title) = titles.find(is_free) {
            document.working_title = title;
        }
        self.add(document);
    }

    /// Opens an empty text that will be saved to a file.
    pub(crate) fn begin(&mut self, path: PathBuf) {
        self.add(Document::new(Some(path), String::new()));
        self.watch_files();
    }

    /// Gives top-level variables of every scene other values.
    pub(crate) fn define(&mut self, definitions: Vec<(String, String)>) {
        self.given = definitions;
        if !self.given.is_empty() {
            self.compile(None);
        }
    }

    /// Whether nothing is open but a text that nobody has begun.
    pub(crate) fn is_blank(&self) -> bool {
        matches!(&self.documents[..], [only] if only.path.is_none() && only.text.is_empty())
    }

    /// Shows a text beside those that are open, or in the place of an empty one.
    fn add(&mut self, document: Document) {
        if self.is_blank() {
            let id = document.id;
            (self.documents, self.active) = (vec![document], 0);
            return self.draw(id);
        }
        self.documents.push(document);
        self.activate(self.documents.len() - 1);
    }

    /// Gives a text another file.
    pub(crate) fn rename(&mut self, id: DocumentId, path: PathBuf) {
        let Some(document) = self.documents.iter_mut().find(|document| document.id == id) else { return };
        document.path = Some(path);
        self.watch_files();
        self.compile(None);
    }

    /// Closes a text, saved or not.
    pub(crate) fn close(&mut self, index: usize) {
        let closed = self.documents.remove(index);
        if self.documents.is_empty() {
            self.documents.push(Document::new(None, String::new()));
        }
        if index < self.active {
            self.active -= 1;
        }
        self.active = self.active.min(self.documents.len() - 1);
        if closed.id == self.scene {
            self.draw(self.documents[self.active].id);
        }
        self.watch_files();
    }

    pub(crate) fn documents(&self) -> &[Document] {
        &self.documents
    }

    pub(crate) fn documents_mut(&mut self) -> &mut [Document] {
        &mut self.documents
    }

    pub(crate) fn active_index(&self) -> usize {
        self.active
    }

    /// Shows a text. It is drawn too, unless it is a part of the scene that is.
    pub(crate) fn activate(&mut self, index: usize) {
        self.active = index.min(self.documents.len() - 1);
        let (id, name) = (self.active().id, self.active().name());
        // (What was compiled before may be another text, of which the scene knows nothing.)
        let own = self.outcome.as_ref().filter(|outcome| outcome.document == self.scene);
        let is_part = own.is_some_and(|outcome| outcome.sources.iter().any(|(_, file)| file.name == name));
        if id != self.scene && !is_part {
            self.draw(id);
        }
    }

    /// The text that is being edited.
    pub(crate) fn active(&self) -> &Document {
        &self.documents[self.active]
    }

    pub(crate) fn active_mut(&mut self) -> &mut Document {
        &mut self.documents[self.active]
    }

    /// The text that is drawn.
    pub(crate) fn scene_document(&self) -> &Document {
        self.documents.iter().find(|document| document.id == self.scene).unwrap_or(&self.documents[0])
    }

    /// Draws another of the open texts.
    pub(crate) fn draw(&mut self, id: DocumentId) {
        self.scene = id;
        // The last good scene of another text says nothing about this one.
        self.shown.take_if(|shown| shown.document != id);
        self.definitions.clear();
        self.values.clear();
        self.compile(None);
        self.scene_since = self.revision;
    }

    /// To be called when any text changed: draws what it says now.
    pub(crate) fn text_changed(&mut self) {
        let text = &self.scene_document().text;
        let Some(running) = &self.running else { return self.compile(None) };
        let Some(edit) = number_edit(&running.text, text) else {
            // Another file may have changed; but what is the same everywhere is compiled already.
            return self.compile(None);
        };
        // What is being compiled with that number live will take its value when it is done.
        let takes = |value: &LiveValue| self.is_live(value) || !self.is_compiled();
        let value = running.live.as_ref().and_then(|live| edit.value(live)).filter(takes);
        match value {
            Some(value) => {
                if let Some(running) = &mut self.running {
                    running.moved = Some(value);
                    running.settles_after = Some(Instant::now());
                }
                self.show();
            }
            None => {
                self.compile(Some(edit.literal()));
                if let Some(running) = &mut self.running {
                    running.settles_after = Some(Instant::now());
                }
            }
        }
    }

    /// Whether the scene in the picture has that live number.
    fn is_live(&self, value: &LiveValue) -> bool {
        let shown = self.shown.as_ref().filter(|shown| shown.revision == self.revision);
        shown.is_some_and(|shown| shown.scene.parameters.iter().any(|parameter| *parameter.name == value.name))
    }

    /// Compiles the texts as they are, with one number live.
    pub(crate) fn compile(&mut self, live: Option<LiveLiteral>) {
        self.revision += 1;
        let mut program = self.program();
        program.options.live_literals = live.into_iter().collect();
        let text = self.scene_document().text.clone();
        self.running = Some(Running { since: Instant::now(), text, live, moved: None, settles_after: None });
        self.studio.compile(program);
    }

    /// The texts as they are, to be compiled.
    pub(crate) fn program(&self) -> Program {
        let buffers: Buffers =
            Arc::new(self.documents.iter().map(|open| (open.name(), open.text.as_str().into())).collect());
        let mut definitions: BTreeMap<String, String> = self.given.iter().cloned().collect();
        definitions.extend(self.definitions.clone());
        let definitions = definitions.into_iter().collect();
        let options = chiaro_compiler::Options { definitions, ..Default::default() };
        Program { revision: self.revision, main: self.scene_document().name(), buffers, options }
    }

    /// The parameters that moved in the picture since it was compiled, with their values as expressions of the language.
    pub(crate) fn moved(&self) -> BTreeMap<String, String> {
        let mut moved: BTreeMap<String, Vec<String>> = BTreeMap::new();
        // Numbers that are live because they were edited stand in the text; the clock is nobody's choice.
        for value in self.values.iter().filter(|value| !value.name.starts_with(['@', '$'])) {
            moved.entry(value.name.clone()).or_default().push(value.value.to_string());
        }
        let is_vector = |name: &str| self.values.iter().any(|value| value.name == name && value.component.is_some());
        let expression = |name: &str, values: Vec<String>| match is_vector(name) {
            true => format!("[{}]", values.join(", ")),
            false => values.concat(),
        };
        moved.into_iter().map(|(name, values)| (name.clone(), expression(&name, values))).collect()
    }

    /// Changes what is wanted of the picture; its live values are the session's.
    pub(crate) fn want(&mut self, wanted: Wanted) {
        let values = self.wanted.values.clone();
        if self.wanted != (Wanted { values: values.clone(), ..wanted.clone() }) {
            self.wanted = Wanted { values, ..wanted };
            self.studio.show(self.wanted.clone());
        }
    }

    /// Shows the live numbers' values.
    pub(crate) fn show(&mut self) {
        let moved = self.running.as_ref().and_then(|running| running.moved.clone());
        let values: Vec<LiveValue> = self.values.iter().cloned().chain(moved).collect();
        if values != self.wanted.values {
            self.wanted.values = values;
            self.studio.show(self.wanted.clone());
        }
    }

    pub(crate) fn wanted(&self) -> &Wanted {
        &self.wanted
    }

    /// The parameters of the scene in the picture, in the order of their ids.
    pub(crate) fn parameters(&self) -> Vec<f64> {
        self.shown.as_ref().map_or(Vec::new(), |shown| self.wanted.parameters(&shown.scene))
    }

    /// Looks at what happened. Answers after which time to look again, if something is due by itself.
    pub(crate) fn poll(&mut self) -> Option<Duration> {
        for event in self.studio.events() {
            self.take(event);
        }
        self.reload();
        let since = self.running.as_ref()?.settles_after?.elapsed();
        if since >= SETTLED {
            // The number stays live: the field is the same then, and needs no new pipelines.
            let live = self.running.as_ref().and_then(|running| running.live);
            self.compile(live);
            return None;
        }
        Some(SETTLED - since)
    }

    fn take(&mut self, event: Event) {
        match event {
            Event::Compiled(compiled) if compiled.revision == self.revision => {
                let (revision, sources) = (compiled.revision, compiled.sources);
                self.trouble = None;
                let document = self.scene;
                if let Some(scene) = compiled.scene {
                    self.shown = Some(Shown { document, revision, sources: sources.clone(), scene, provenance: None });
                    self.show();
                }
                self.outcome = Some(Outcome { document, revision, sources, diagnostics: compiled.diagnostics });
                self.watch_files();
                self.catch_up();
            }
            Event::Linked { revision, provenance } => {
                if let Some(shown) = self.shown.as_mut().filter(|shown| shown.revision == revision) {
                    shown.provenance = Some(provenance);
                }
            }
            Event::Noted { revision, notes } => {
                if let Some(outcome) = self.outcome.as_mut().filter(|outcome| outcome.revision == revision) {
                    outcome.diagnostics.extend(notes);
                }
            }
            Event::Frame(frame) => {
                self.drawn = frame.revision;
                self.frame = Some(frame);
            }
            Event::Trouble(message) => self.trouble = Some(message),
            Event::Device(name) => self.device = name,
            // An older text's.
            Event::Compiled(_) => {}
        }
    }

    /// Compiles once more, if a number moved meanwhile that did not come to be live.
    fn catch_up(&mut self) {
        let moved = self.running.as_ref().and_then(|running| running.moved.as_ref());
        if moved.is_some_and(|moved| !self.is_live(moved)) {
            self.compile(None);
        }
    }

    /// Takes over what other programs wrote.
    fn reload(&mut self) {
        let changes = self.watch.changes();
        if changes.is_empty() {
            return;
        }
        let mut is_new = false;
        for document in &mut self.documents {
            if document.path.as_ref().is_some_and(|path| changes.contains(path)) {
                is_new |= document.reload();
            }
        }
        let is_open = |path: &PathBuf| self.documents.iter().any(|document| document.path.as_ref() == Some(path));
        let files = self.files_read();
        is_new |= changes.iter().any(|path| !is_open(path) && files.contains(path));
        if is_new {
            self.compile(None);
        }
    }

    /// The files that the scene was compiled from.
    fn files_read(&self) -> Vec<PathBuf> {
        let sources = self.outcome.as_ref().map(|outcome| &outcome.sources);
        sources.into_iter().flat_map(|sources| sources.iter()).map(|(_, file)| PathBuf::from(&file.name)).collect()
    }

    fn watch_files(&mut self) {
        let read = self.files_read();
        let open = self.documents.iter().filter_map(|document| document.path.as_deref());
        self.watch.watch(open.chain(read.iter().map(PathBuf::as_path)));
    }

    #[cfg(test)]
    pub(crate) fn sabotage(&self) -> &crate::studio::sabotage::Sabotage {
        self.studio.sabotage()
    }

    /// Whether the text that is drawn has errors.
    pub(crate) fn has_errors(&self) -> bool {
        let is_error = |diagnostic: &Diagnostic| diagnostic.severity == Severity::Error;
        let own = self.outcome.as_ref().filter(|outcome| outcome.document == self.scene);
        own.is_some_and(|outcome| outcome.diagnostics.iter().any(is_error))
    }

    /// Whether what the compiler has to say is about the text that is open.
    pub(crate) fn is_compiled(&self) -> bool {
        self.outcome.as_ref().is_some_and(|outcome| outcome.revision == self.revision)
    }

    /// How long ago the compiler was asked last.
    pub(crate) fn waits_since(&self) -> Option<Duration> {
        self.running.as_ref().map(|running| running.since.elapsed())
    }

    /// Whether a frame is of the text that is drawn, and not of one that was drawn before.
    pub(crate) fn is_of_scene(&self, frame: &Frame) -> bool {
        frame.revision >= self.scene_since
    }

    /// Whether the picture is of an older text than the one that is open.
    pub(crate) fn is_outdated(&self) -> bool {
        self.drawn != self.revision
    }
}
