//! What the tests of this crate share.

use chiaro_eval::World;

/// A text without its `|`, and where that stood.
pub(crate) fn caret(text: &str) -> (String, usize) {
    let at = text.find('|').expect("a caret");
    (text.replacen('|', "", 1), at)
}

/// Files by their names.
pub(crate) struct Files(Vec<(String, String)>);

impl Files {
    pub(crate) fn new(files: &[(&str, &str)]) -> Self {
        Files(files.iter().map(|(name, text)| ((*name).to_owned(), (*text).to_owned())).collect())
    }
}

impl World for Files {
    fn find(&self, _: &str, path: &str) -> Option<String> {
        self.0.iter().find(|(name, _)| name == path).map(|(name, _)| name.clone())
    }

    fn read(&self, name: &str) -> Result<Vec<u8>, String> {
        let file = self.0.iter().find(|(other, _)| other == name);
        file.map(|(_, text)| text.clone().into_bytes()).ok_or_else(|| "no such file".to_owned())
    }
}

/// The scenes of this project, with their paths.
pub(crate) fn scenes() -> Vec<(String, String)> {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut scenes = Vec::new();
    let mut folders = vec![root.join("examples_csg"), root.join("tests/scenes")];
    while let Some(folder) = folders.pop() {
        let entries = std::fs::read_dir(&folder).expect("the folder of scenes");
        for path in entries.map(|entry| entry.expect("an entry").path()) {
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "csg" || extension == "scad") {
                let bytes = std::fs::read(&path).expect("a scene");
                scenes.push((path.display().to_string(), String::from_utf8_lossy(&bytes).into_owned()));
            }
        }
    }
    scenes.sort();
    assert!(scenes.len() > 50, "there are scenes");
    scenes
}

/// Words that programs are made of, and some that they are not.
pub(crate) const WORDS: &[&str] = &[
    "module",
    "function",
    "if",
    "else",
    "let",
    "assert",
    "echo",
    "for",
    "each",
    "true",
    "undef",
    "a",
    "cube",
    "sphere",
    "$fn",
    "1",
    "2.5",
    "0x1F",
    "1e-3",
    "\"s\"",
    "\"",
    "\\",
    "use <a>",
    "include <b>",
    "use <",
    "(",
    ")",
    "[",
    "]",
    "{",
    "}",
    ";",
    ",",
    ".",
    ":",
    "?",
    "=",
    "+",
    "-",
    "*",
    "/",
    "%",
    "^",
    "!",
    "~",
    "#",
    "&",
    "&&",
    "|",
    "||",
    "==",
    "<",
    "<<",
    ">=",
    "\n",
    "\r\n",
    "\r",
    "\n\n",
    "// c\n",
    "// [1:5]\n",
    "/* [G] */",
    "/* c\n c */",
    "/*",
    "é",
    "\u{a0}",
    "\x03",
    "color(\"re",
    "a = 5;",
    "translate([1, 2, a])",
    "text(text = \"",
    "\", size = 1, spacing = 1, font = \"",
    ");\n",
];
