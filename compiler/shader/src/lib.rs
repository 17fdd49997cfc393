//! Emits a field graph as a naga module and splices it into the tracing templates.
//!
//! [`splice`] builds the functions `scene_distance` and `scene_surface` as naga's IR, without a detour through text, and
//! puts them in the place of a [`Template`]'s stubs: the module goes to the GPU as it is. [`splice_with_crowds`] makes loops of
//! large unions, which read [`CrowdData`]. [`wgsl`] prints the same
//! functions, below what they call of the vocabulary, for people to read and to take elsewhere. What all templates share
//! is in [`bindings`].

pub mod bindings;
mod build;
mod crowd;
mod emit;
pub mod lights;
mod link;
mod names;
mod one_pass;
mod shadows;
mod splice;
mod tables;
mod template;
mod text;

pub use crowd::CrowdData;
pub use emit::MAX_NODES;
pub use one_pass::{Light, Setting, Sky, one_pass};
pub use shadows::{Shadows, Verified};
pub use splice::{Shader, splice, splice_with_crowds};
pub use tables::{Tables, single};
pub use template::{FOR_SCREENS, GLOSS_TABLE, Inspect, Template};
pub use text::{Library, Listing, Names, library, listing, wgsl};
