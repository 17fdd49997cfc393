//! The live-reload editor.
