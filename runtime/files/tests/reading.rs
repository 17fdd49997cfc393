//! What scenes may read.
#![cfg(unix)]

use std::ffi::OsStr;
use std::fs;
use std::os::unix::ffi::OsStrExt;
use std::os::unix::fs::symlink;
use std::path::Path;
use std::process::Command;

use chiaro_compiler::World;
use chiaro_files::FileWorld;

#[test]
fn only_files_are_read() {
    let folder = tempfile::tempdir().unwrap();
    let pipe = folder.path().join("pipe.scad");
    assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    let socket = folder.path().join("socket.scad");
    let _socket = std::os::unix::net::UnixListener::bind(&socket).unwrap();
    let world = FileWorld::new();
    for (path, reason) in [
        (&*pipe, "it is a pipe, and scenes are files"),
        (&socket, "it is a socket, and scenes are files"),
        (Path::new("/dev/zero"), "it is a device, and scenes are files"),
        (folder.path(), "it is a folder"),
        (&folder.path().join("nowhere"), "there is no such file"),
    ] {
        assert_eq!(world.read(&world.name_of(path)), Err(reason.to_owned()));
    }
    #[cfg(target_os = "linux")]
    assert_eq!(world.read("/proc/self/environ"), Err("it is no ordinary file".to_owned()));
    fs::write(folder.path().join("empty.scad"), "").unwrap();
    assert_eq!(world.read_file(&folder.path().join("empty.scad")), Ok(Vec::new()));
}

#[test]
fn a_confined_world_has_nothing_outside_of_its_folders() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    for name in ["jail/inner", "jail_too", "second"] {
        fs::create_dir_all(path(name)).unwrap();
        fs::write(path(name).join("a.scad"), "x = 1;").unwrap();
    }
    fs::write(path("jail/main.scad"), "").unwrap();
    fs::write(path("outside.scad"), "secret").unwrap();
    symlink("../outside.scad", path("jail/link.scad")).unwrap();
    symlink("inner/a.scad", path("jail/good.scad")).unwrap();
    symlink("..", path("jail/up")).unwrap();
    symlink("jail", path("to_jail")).unwrap();

    let world = FileWorld::confined(&[path("to_jail"), path("second")]).unwrap();
    let from = path("jail/main.scad").to_string_lossy().into_owned();
    for inside in ["inner/a.scad", "good.scad", "../second/a.scad", "inner/../inner/a.scad"] {
        let name = world.find(&from, inside).unwrap_or_else(|| panic!("{inside}"));
        assert_eq!(world.read(&name).unwrap(), b"x = 1;");
    }
    for outside in ["link.scad", "up/outside.scad", "../outside.scad", "../jail_too/a.scad", "/etc/passwd"] {
        assert_eq!(world.find(&from, outside), None, "{outside}");
    }
    for outside in ["jail/link.scad", "outside.scad", "jail_too/a.scad"] {
        let error = world.read(&path(outside).to_string_lossy()).unwrap_err();
        assert_eq!(error, "it is outside of the folders that may be read", "{outside}");
    }
    assert!(FileWorld::confined(&[path("nowhere")]).is_err());
    assert!(FileWorld::confined(&[path("outside.scad")]).is_err());
}

#[test]
fn names_that_are_not_unicode_are_names() {
    let folder = tempfile::tempdir().unwrap();
    let odd = |bytes: &[u8]| folder.path().join(OsStr::from_bytes(bytes));
    let world = FileWorld::new();
    let mut names = Vec::new();
    for bytes in [b"a\xff.scad", b"a\xfe.scad"] {
        fs::create_dir(odd(&bytes[..2])).unwrap();
        fs::write(odd(bytes), bytes).unwrap();
        names.push(world.name_of(&odd(bytes)));
        assert_eq!(world.read(&names[names.len() - 1]).unwrap(), bytes);
    }
    assert_ne!(names[0], names[1]);
    // What is beside such a file is found from it.
    fs::write(odd(b"a\xff").join("part.scad"), "part").unwrap();
    fs::write(odd(b"a\xff").join("main.scad"), "").unwrap();
    let main = world.name_of(&odd(b"a\xff").join("main.scad"));
    let part = world.find(&main, "part.scad").unwrap();
    assert_eq!(world.read(&part).unwrap(), b"part");
}
