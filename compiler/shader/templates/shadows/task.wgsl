// What shadow passes are told.

@group(1) @binding(0) var<storage, read> receivers: array<Receiver>;
@group(1) @binding(3) var<storage, read> task: Task;

/// In a storage buffer, because lavapipe compiles anew for values of uniforms.
struct Task {
    /// The light's index, or `DRAWN_LIGHT`.
    light: u32,
    /// The number of the sample, for methods that draw at random.
    sample: u32,
    /// The number of cells that a light is cut into, or of samples that are drawn at once, where a method has such.
    cells: u32,
    /// How many receivers there are.
    receivers: u32,
    /// How many of them lie in a row of pixels.
    width: u32,
    /// How far ahead a planar silhouette lets a step of verified cones go, of what it would allow: while looking for
    /// contact, and behind it.
    looking: f32,
    following: f32,
    /// Of verified cones: which receivers a pass is about.
    stage: u32,
    /// The cells of a unit disc: centre, share of the area, radius of a disc with that area.
    cells_of_disc: array<vec4<f32>>,
}

/// A cell of the unit disc: centre, share of the area, radius of a disc with that area.
fn disc_cell(k: u32) -> vec4<f32> {
    return task.cells_of_disc[k];
}

/// No axis of a dispatch may have more than 65535 workgroups.
const GROUPS_IN_ROW: u32 = 32768u;

/// The index of an invocation of a dispatch of rows of workgroups.
fn linear_index(group: vec3<u32>, groups: vec3<u32>, lane: u32) -> u32 {
    return 64u * (group.y * groups.x + group.x) + lane;
}
