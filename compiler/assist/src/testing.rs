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
