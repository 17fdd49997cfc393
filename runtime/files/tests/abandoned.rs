//! What a process that is told to end leaves behind: nothing. Alone in its program, since nothing can be written afterwards.

use std::fs;

use chiaro_files::{Batch, Folders, Temporary, abandon};

#[test]
fn nothing_is_left_of_what_is_not_in_its_place() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    fs::write(path("old.png"), "old").unwrap();
    let mut batch = Batch::default();
    batch.write(&path("old.png"), b"new").unwrap();
    batch.write(&path("other.png"), b"new").unwrap();
    let mut folders = Folders::default();
    folders.make(&path("made/for/nothing")).unwrap();
    folders.make(&path("made/for/something")).unwrap();
    fs::write(path("made/for/something/file"), "kept").unwrap();
    let temporary = Temporary::folder().unwrap();
    let (temporary, place) = (temporary.path().to_owned(), std::mem::ManuallyDrop::new(temporary));
    fs::write(place.path().join("file"), "gone").unwrap();

    abandon();
    assert!(!temporary.exists());
    assert_eq!(fs::read(path("old.png")).unwrap(), b"old");
    assert_eq!(names(folder.path()), ["made", "old.png"]);
    assert_eq!(names(&path("made/for")), ["something"]);
    // Whoever would clean up waits for the end of the process.
    std::mem::forget((batch, folders));
}

fn names(folder: &std::path::Path) -> Vec<String> {
    let mut names: Vec<String> =
        fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}
