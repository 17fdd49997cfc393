//! The editor as a person uses it: the whole window without a screen, drawn by a software adapter.

mod dialogs;
mod figures;
mod files;
mod kept;
mod likeness;
mod panels;
mod person;
mod picture;
mod text;
