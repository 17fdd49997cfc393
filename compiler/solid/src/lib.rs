//! The solid tree as plain data: shapes, operators, materials, camera.
//!
//! It is what the evaluator answers and what the field is lowered from. It knows no text beyond spans.

pub mod affine;
pub mod light;
pub mod print;
pub mod scalar;
pub mod scene;
pub mod singular;
pub mod tree;

pub use affine::Affine;
pub use light::{Emitter, Light, PlacedLight, SHADOW_METHODS, Strength};
pub use print::{print, print_camera, print_lights};
pub use scalar::{LiveParameter, ParameterId, Scalar};
pub use scene::{Camera, Material, Scene};
pub use tree::{Boolean, Dimension, Joint, Profile, Solid, SolidKind};
