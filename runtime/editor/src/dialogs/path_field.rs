//! A field for a path, with what there is to choose from.

use std::path::{Path, is_separator};

use egui::text::{CCursor, CCursorRange};
use egui::{Context, Id, Key, Modifiers, Response, ScrollArea, TextEdit, Ui};

/// The height of the list, in points.
const LIST: f32 = 132.0;

/// A path as it is being typed.
pub(super) struct PathField {
    pub(super) path: String,
    /// The endings of the files that are offered.
    endings: Vec<String>,
    /// What is offered, and for which path.
    offered: Option<(String, Vec<String>)>,
    /// The field was shown already.
    is_shown: bool,
}

impl PathField {
    /// A field with a path in it that offers folders, and files with these endings.
    pub(super) fn new(path: &Path, endings: &[&str]) -> Self {
        let endings = endings.iter().map(|ending| (*ending).to_owned()).collect();
        Self { path: path.display().to_string(), endings, offered: None, is_shown: false }
    }

    /// The path; none, as long as it is that of a folder: that is opened in the list instead.
    pub(super) fn chosen(&mut self) -> Option<&Path> {
        let path = self.path.trim();
        if path.is_empty() || path.ends_with(is_separator) {
            return None;
        }
        if Path::new(path).is_dir() {
            self.path = format!("{path}{}", std::path::MAIN_SEPARATOR);
            return None;
        }
        Some(Path::new(self.path.trim()))
    }

    /// Lets the user go on writing.
    pub(super) fn go_on(&self, field: &Response) {
        field.request_focus();
        put_caret_at_end(&field.ctx, field.id, &self.path);
    }

    /// Shows the field. Tab completes what is typed.
    pub(super) fn show(&mut self, ui: &mut Ui) -> Response {
        let id = Id::unique("path field");
        let is_tab = |ui: &Ui| ui.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Tab));
        if ui.memory(|memory| memory.has_focus(id)) && is_tab(ui) {
            self.complete();
            put_caret_at_end(ui.ctx(), id, &self.path);
        }
        let field = TextEdit::singleline(&mut self.path).id(id).lock_focus(true).desired_width(f32::INFINITY);
        let response = ui.add(field);
        if response.changed() && self.replace_by_absolute() {
            put_caret_at_end(ui.ctx(), id, &self.path);
        }
        if !std::mem::replace(&mut self.is_shown, true) {
            self.go_on(&response);
        }
        response
    }

    /// Lists what the path could become, to be chosen by a click.
    pub(super) fn show_list(&mut self, ui: &mut Ui, field: &Response) {
        let mut clicked = None;
        ScrollArea::vertical().max_height(LIST).min_scrolled_height(LIST).auto_shrink(false).show(ui, |ui| {
            if self.offered().is_empty() {
                ui.weak("nothing there begins like this");
            }
            for name in self.offered() {
                if ui.selectable_label(false, name).clicked() {
                    clicked = Some(name.clone());
                }
            }
        });
        if let Some(name) = clicked {
            self.path = format!("{}{name}", split(&self.path)[0]);
            self.go_on(field);
        }
    }

    /// An absolute path that is typed behind another one takes its place.
    fn replace_by_absolute(&mut self) -> bool {
        let meant = meant(&self.path);
        let is_other = meant != self.path;
        self.path = meant;
        is_other
    }

    /// Writes what all that is offered begins with.
    fn complete(&mut self) {
        let folder = split(&self.path)[0].to_owned();
        if let Some(common) = common_beginning(self.offered()) {
            self.path = folder + &common;
        }
    }

    /// The folders and files whose paths begin with this one, by their names.
    fn offered(&mut self) -> &[String] {
        if self.offered.as_ref().is_none_or(|(path, _)| *path != self.path) {
            let [folder, begun] = split(&self.path);
            self.offered = Some((self.path.clone(), names(folder, begun, &self.endings)));
        }
        self.offered.as_ref().map_or(&[], |(_, names)| names)
    }
}

/// The path that is meant: where an absolute one stands behind a separator, that one. `~` is the
/// user's own folder.
pub(super) fn meant(path: &str) -> String {
    let begins = |at: &usize| *at == 0 || path[..*at].ends_with(is_separator);
    let is_absolute = |path: &str| Path::new(path).is_absolute() || path.starts_with("~/");
    let mut starts = path.char_indices().map(|(at, _)| at).filter(|at| begins(at) && is_absolute(&path[*at..]));
    let path = &path[starts.next_back().unwrap_or(0)..];
    match (path.strip_prefix("~/"), std::env::home_dir()) {
        (Some(rest), Some(home)) => home.join(rest).display().to_string(),
        _ => path.to_owned(),
    }
}

/// The folder of a path, with the separator behind it, and the name that is begun.
fn split(path: &str) -> [&str; 2] {
    let at = path.rfind(is_separator).map_or(0, |at| at + 1);
    [&path[..at], &path[at..]]
}

/// The names in a folder that begin in this way, in the order of the alphabet: those of folders,
/// with a separator behind them, and of files with these endings. Hidden ones are named only if
/// that is what was begun.
fn names(folder: &str, begun: &str, endings: &[String]) -> Vec<String> {
    let place = if folder.is_empty() { Path::new(".") } else { Path::new(folder) };
    let Ok(entries) = std::fs::read_dir(place) else { return Vec::new() };
    let named = |entry: std::fs::DirEntry| {
        let name = entry.file_name().into_string().ok()?;
        let fits =
            name.to_lowercase().starts_with(&begun.to_lowercase()) && name.starts_with('.') == begun.starts_with('.');
        let path = entry.path();
        let has_ending = path.extension().is_some_and(|ending| endings.iter().any(|other| *ending == **other));
        match path.is_dir() {
            true => fits.then(|| format!("{name}{}", std::path::MAIN_SEPARATOR)),
            false => (fits && has_ending).then_some(name),
        }
    };
    let mut names: Vec<String> = entries.flatten().filter_map(named).collect();
    names.sort();
    names
}

/// What all names begin with, upper and lower case being the same; none, if there are none.
fn common_beginning(names: &[String]) -> Option<String> {
    let (first, others) = names.split_first()?;
    let is_same = |(a, b): &(char, char)| a.to_lowercase().eq(b.to_lowercase());
    let common = |length: usize, other: &String| {
        let same = first.chars().zip(other.chars()).take_while(is_same);
        length.min(same.count())
    };
    let length = others.iter().fold(first.chars().count(), common);
    Some(first.chars().take(length).collect())
}

fn put_caret_at_end(context: &Context, id: Id, path: &str) {
    let mut state = TextEdit::load_state(context, id).unwrap_or_default();
    let end = CCursor::new(path.chars().count());
    state.cursor.set_char_range(Some(CCursorRange::one(end)));
    TextEdit::store_state(context, id, state);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_absolute_path_behind_a_folder_is_what_is_meant() {
        for (typed, expected) in [
            ("/home/a/", "/home/a/"),
            ("/home/a/b.csg", "/home/a/b.csg"),
            ("/home/a//tmp/b.csg", "/tmp/b.csg"),
            ("/home//a//tmp/b.csg", "/tmp/b.csg"),
            ("parts/b.csg", "parts/b.csg"),
            ("/home/a~/b.csg", "/home/a~/b.csg"),
        ] {
            assert_eq!(meant(typed), expected);
        }
        if let Some(home) = std::env::home_dir() {
            assert_eq!(meant("/tmp/~/b.csg"), home.join("b.csg").display().to_string());
        }
    }

    #[test]
    fn paths_are_completed_as_far_as_they_are_certain() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::create_dir(folder.path().join("parts")).unwrap();
        for name in ["plate.csg", "Plane.scad", "plan.txt", ".hidden.csg", "parts/pin.csg"] {
            std::fs::write(folder.path().join(name), "").unwrap();
        }
        let completed = |begun: &str| {
            let mut field = PathField::new(&folder.path().join(begun), &["csg", "scad"]);
            field.complete();
            Path::new(&field.path).strip_prefix(folder.path()).unwrap().display().to_string()
        };
        let mut field = PathField::new(&folder.path().join("p"), &["csg", "scad"]);
        assert_eq!(field.offered(), ["Plane.scad", "parts/", "plate.csg"]);
        assert_eq!(completed("pl"), "Pla");
        assert_eq!(completed("pa"), "parts");
        assert_eq!(completed("plat"), "plate.csg");
        assert_eq!(completed("x"), "x");
        assert_eq!(completed(".h"), ".hidden.csg");
    }
}
