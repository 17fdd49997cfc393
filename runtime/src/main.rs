//! The `chiaro` command.
//!
//! Only this crate touches the terminal. Each subcommand is one file of [`commands`]; each of them compiles
//! through [`compile`], which reports what there is to say.

mod arguments;
mod commands;
mod comparison;
mod compile;
mod terminal;
mod view;

use std::process::ExitCode;

use chiaro_files::{self as files, images};
use clap::Parser;

use crate::arguments::{Arguments, Command};

fn main() -> ExitCode {
    env_logger::init();
    let arguments = Arguments::parse();
    let result = match &arguments.command {
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
    };
    match result {
        Ok(code) => code,
        Err(error) => {
            terminal::fail(&error, arguments.global.message_format);
            ExitCode::FAILURE
        }
    }
}
