//! The bindings that all templates share; `templates/bindings.md` describes them.

use naga::ResourceBinding;

/// The template's `view` uniform.
pub const VIEW: ResourceBinding = ResourceBinding { group: 0, binding: 0 };

/// The uniform of live numbers, `array<vec4<f32>, N>`. Only in modules of scenes that have any.
pub const LIVE: ResourceBinding = ResourceBinding { group: 0, binding: 1 };

/// The storage buffer of large outlines and polytopes, `array<vec4<f32>>`. Only in modules of scenes that have any.
pub const TABLES: ResourceBinding = ResourceBinding { group: 0, binding: 2 };

/// The storage buffer of the glossy lobe, [`GLOSS_TABLE`](crate::GLOSS_TABLE). Only in templates that light surfaces.
pub const GLOSS: ResourceBinding = ResourceBinding { group: 0, binding: 3 };

/// The group of the template's own buffers and textures.
pub const OWN_GROUP: u32 = 1;

/// The storage buffer of crowds, `array<vec4<u32>>`. Only in modules that loop over members of crowds.
pub const CROWDS: ResourceBinding = ResourceBinding { group: 0, binding: 4 };

/// The uniform of crowds' grids, `array<vec4<u32>, 24>`. Only in modules that loop over members of crowds.
pub const CROWD_GRIDS: ResourceBinding = ResourceBinding { group: 0, binding: 5 };
