//! Files written whole or not at all, whatever is at their places already.

use std::fs;
use std::path::{Path, PathBuf};

use chiaro_files::{Batch, Folders, is_stream_at, write, write_all, write_folder};

struct Folder(tempfile::TempDir);

impl Folder {
    fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(self.0.path()).unwrap();
        let mut names: Vec<String> =
            entries.map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }
}

fn text(path: &Path) -> String {
    fs::read_to_string(path).unwrap()
}

#[test]
fn what_is_not_finished_leaves_nothing() {
    let folder = Folder::new();
    fs::write(folder.path("a"), "old").unwrap();
    let mut batch = Batch::default();
    batch.write(&folder.path("a"), b"new").unwrap();
    batch.write(&folder.path("b"), b"new").unwrap();
    assert!(batch.write(&folder.path("no/c"), b"new").is_err());
    drop(batch);
    assert_eq!((folder.names(), text(&folder.path("a"))), (vec!["a".to_owned()], "old".to_owned()));
}

#[test]
fn where_one_file_cannot_be_none_is() {
    let folder = Folder::new();
    fs::create_dir(folder.path("b")).unwrap();
    let (a, b) = (folder.path("a"), folder.path("b"));
    let error = write_all(&[(&a, b"1"), (&b, b"2")]).unwrap_err();
    assert_eq!(format!("{error:#}"), format!("cannot write {}: it is a folder", b.display()));
    assert_eq!(folder.names(), ["b"]);
}

#[test]
fn folders_that_nothing_came_into_are_removed() {
    let folder = Folder::new();
    let output = folder.path("out");
    fs::create_dir_all(output.join("README.md")).unwrap();
    let (readme, inner) = (output.join("README.md"), output.join("web/deep/a.js"));
    let error = write_folder(&output, &[(&inner, b"1"), (&readme, b"2")]).unwrap_err();
    assert!(format!("{error:#}").contains("README.md: it is a folder"), "{error:#}");
    assert!(!output.join("web").exists());
    fs::remove_dir(&readme).unwrap();
    write_folder(&output, &[(&inner, b"1"), (&readme, b"2")]).unwrap();
    assert_eq!((text(&inner), text(&readme)), ("1".to_owned(), "2".to_owned()));

    let mut folders = Folders::default();
    folders.make(&folder.path("report/of/nothing")).unwrap();
    assert!(folder.path("report/of/nothing").is_dir());
    drop(folders);
    assert_eq!(folder.names(), ["out"]);
}

#[test]
fn messages_name_the_file_and_nothing_else() {
    let folder = Folder::new();
    let file = folder.path("no/a.png");
    let error = write(&file, b"1").unwrap_err();
    assert_eq!(format!("{error:#}"), format!("cannot write {}: there is no such folder", file.display()));
    fs::write(folder.path("f"), "").unwrap();
    let (output, file) = (folder.path("f/out"), folder.path("f/out/a"));
    let error = write_folder(&output, &[(&file, b"1")]).unwrap_err();
    assert_eq!(format!("{error:#}"), format!("cannot write {}: what should be a folder is a file", output.display()));
}

#[cfg(unix)]
mod unix {
    use std::io::Read;
    use std::os::unix::fs::{MetadataExt, PermissionsExt, symlink};
    use std::process::Command;

    use super::*;

    #[test]
    fn links_stay_and_what_they_lead_to_is_written() {
        let folder = Folder::new();
        fs::create_dir(folder.path("there")).unwrap();
        fs::write(folder.path("there/a"), "old").unwrap();
        symlink("there/a", folder.path("link")).unwrap();
        symlink("link", folder.path("link_to_link")).unwrap();
        symlink("there/new", folder.path("dangling")).unwrap();
        write(&folder.path("link_to_link"), b"new").unwrap();
        write(&folder.path("dangling"), b"new").unwrap();
        for name in ["link", "link_to_link", "dangling"] {
            assert!(folder.path(name).is_symlink(), "{name}");
        }
        assert_eq!((text(&folder.path("there/a")), text(&folder.path("there/new"))), ("new".into(), "new".into()));

        symlink("round", folder.path("round")).unwrap();
        assert!(format!("{:#}", write(&folder.path("round"), b"1").unwrap_err()).contains("circle"));
    }

    #[test]
    fn a_link_to_no_folder_becomes_one_to_a_folder() {
        let folder = Folder::new();
        symlink("nowhere", folder.path("out")).unwrap();
        let (output, file) = (folder.path("out"), folder.path("out/web/a.js"));
        write_folder(&output, &[(&file, b"1")]).unwrap();
        assert!(output.is_symlink());
        assert_eq!((folder.names(), text(&file)), (vec!["nowhere".to_owned(), "out".to_owned()], "1".to_owned()));

        symlink("no/where", folder.path("far")).unwrap();
        let (output, file) = (folder.path("far"), folder.path("far/a.js"));
        assert!(write_folder(&output, &[(&file, b"1")]).is_err());
        assert_eq!(folder.names(), ["far", "nowhere", "out"]);
    }

    #[test]
    fn other_names_of_a_file_keep_being_its_names() {
        let folder = Folder::new();
        fs::write(folder.path("a"), "an old text").unwrap();
        fs::hard_link(folder.path("a"), folder.path("b")).unwrap();
        write(&folder.path("a"), b"new").unwrap();
        assert_eq!((text(&folder.path("a")), text(&folder.path("b"))), ("new".to_owned(), "new".to_owned()));
        assert_eq!(fs::metadata(folder.path("a")).unwrap().nlink(), 2);
        assert_eq!(folder.names(), ["a", "b"]);
    }

    #[test]
    fn what_may_not_be_written_to_is_not_replaced() {
        let folder = Folder::new();
        fs::write(folder.path("a"), "old").unwrap();
        fs::set_permissions(folder.path("a"), fs::Permissions::from_mode(0o444)).unwrap();
        let error = write(&folder.path("a"), b"new").unwrap_err();
        assert!(format!("{error:#}").contains("may not be written to"), "{error:#}");
        assert_eq!((folder.names(), text(&folder.path("a"))), (vec!["a".to_owned()], "old".to_owned()));
    }

    #[test]
    fn pipes_and_devices_get_the_bytes() {
        let folder = Folder::new();
        let pipe = folder.path("pipe");
        assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
        assert!(is_stream_at(&pipe) && is_stream_at(Path::new("/dev/null")) && !is_stream_at(&folder.path("a")));
        let reader = std::thread::spawn({
            let pipe = pipe.clone();
            move || {
                let mut read = String::new();
                fs::File::open(pipe).unwrap().read_to_string(&mut read).unwrap();
                read
            }
        });
        write(&pipe, b"through the pipe").unwrap();
        assert_eq!(reader.join().unwrap(), "through the pipe");
        assert_eq!(folder.names(), ["pipe"]);
        write(Path::new("/dev/null"), b"gone").unwrap();
        assert!(!fs::metadata("/dev/null").unwrap().is_file());

        let _socket = std::os::unix::net::UnixListener::bind(folder.path("socket")).unwrap();
        let error = write(&folder.path("socket"), b"1").unwrap_err();
        assert!(format!("{error:#}").ends_with("it is a socket"), "{error:#}");
    }
}
