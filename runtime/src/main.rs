//! The `chiaro` command.
//!
//! Only this crate touches the terminal. Each subcommand is one file of [`commands`]; each of them compiles
//! through [`compile`], which reports what there is to say.

mod arguments;
mod commands;
mod comparison;
mod compile;
mod output;
mod shown;
#[cfg(unix)]
mod signals;
mod terminal;
mod view;

#[cfg(unix)]
use std::path::Path;
use std::process::ExitCode;

use anyhow::Result;
use chiaro_files::{self as files, images};
use clap::Parser;

use crate::arguments::{Arguments, Command};

fn main() -> ExitCode {
    #[cfg(unix)]
    silence_device_selection();
    env_logger::init();
    #[cfg(unix)]
    signals::watch();
    let arguments = Arguments::parse();
    let result = files::confine(&arguments.jail).and_then(|()| run(&arguments));
    match result {
        Ok(code) => code,
        Err(error) => {
            terminal::fail(&error, arguments.global.message_format);
            ExitCode::FAILURE
        }
    }
}

fn run(arguments: &Arguments) -> Result<ExitCode> {
    match &arguments.command {
        #[cfg(feature = "editor")]
        Command::Edit(edit) => commands::edit::run(edit),
        #[cfg(feature = "editor")]
        Command::Watch(watch) => commands::watch::run(watch),
        Command::Render(render) => commands::render::run(render, &arguments.global),
        Command::Export(export) => commands::export::run(export, &arguments.global),
        Command::Check(check) => commands::check::run(check, &arguments.global),
        Command::Fmt(fmt) => commands::fmt::run(fmt, &arguments.global),
        Command::Dump(dump) => commands::dump::run(dump, &arguments.global),
        Command::Distance(distance) => commands::distance::run(distance, &arguments.global),
        Command::Compare(compare) => commands::compare::run(compare, &arguments.global),
        Command::Adapters => commands::adapters::run(),
    }
}

/// Where there is no place for the sockets of a desktop, keeps a layer of Mesa's from looking there for a display: the library that
/// it does so with complains to standard error. The layer puts the desktop's graphics card first; ours are sorted anyway.
#[cfg(unix)]
fn silence_device_selection() {
    use std::env;
    let has_place = env::var_os("XDG_RUNTIME_DIR").is_some_and(|folder| Path::new(&folder).is_absolute());
    let is_chosen = ["DRI_PRIME", "MESA_VK_DEVICE_SELECT"].into_iter().any(|name| env::var_os(name).is_some());
    if !has_place && !is_chosen {
        #[expect(unsafe_code, reason = "the program's first statement: no other thread reads the environment")]
        unsafe {
            env::set_var("NODEVICE_SELECT", "1");
        }
    }
}
