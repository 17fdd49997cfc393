//! Draws a compiled scene with wgpu: devices, pipelines, progressive pictures, readback.
//!
//! [`Gpu`] is a device; [`Model`] is a scene compiled for it, slow to make; [`View`] says from where to look;
//! [`Picture`] gathers samples of what is seen there, and can be shown after each; [`distances`] asks the field itself.
//! [`Inspector`] draws what is not lit: normals, costs, sections; [`Masker`] finds the pixels that show a part of the scene.

mod cells;
mod crowds;
mod error;
mod gpu;
mod inspect;
mod kernel;
mod kernels;
mod lights;
mod mask;
mod measure;
mod model;
mod one_pass;
mod parts;
mod pick;
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
pub use inspect::{Drawing, Inspection, Inspector, Legend, Mark, Plane};
pub use lights::{Direct, LightRow, LightSource, Lighting, Surroundings};
pub use mask::{Mask, Masker};
pub use model::Model;
pub use one_pass::{Eye, setting_within_bounds};
pub use picture::{Evaluations, Floor, Picture, Timings};
pub use probe::distances;
pub use study::{Outcome, Receiver, Study, Truth};
pub use view::View;
