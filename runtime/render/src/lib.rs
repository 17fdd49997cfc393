//! Draws a compiled scene with wgpu: devices, pipelines, progressive pictures, readback.
//!
//! [`Gpu`] is a device; [`Model`] is a scene compiled for it, slow to make; [`View`] says from where to look;
//! [`Picture`] gathers samples of what is seen there, and can be shown after each; [`distances`] asks the field itself.

mod cells;
mod error;
mod gpu;
mod kernel;
mod lights;
mod measure;
mod model;
mod parts;
mod picture;
mod probe;
mod resolve;
mod shade;
mod shadow;
mod stopwatch;
mod study;
mod uniform;
mod verified;
mod view;

pub use error::{Error, Result};
pub use gpu::{AdapterDescription, Gpu, Preference, adapters};
pub use lights::{Direct, LightRow, LightSource, Lighting, Surroundings};
pub use model::Model;
pub use picture::{Evaluations, Floor, Picture, Timings};
pub use probe::distances;
pub use study::{Outcome, Receiver, Study, Truth};
pub use view::View;
