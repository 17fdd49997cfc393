// Crowds: large unions, of whose members each place asks those alone that can be the nearest there.
//
// Theory: A grid of cubes, some of them divided into 4 × 4 × 4, lists for each cube the members that can be the nearest in
// it (Barbier et al., "Lipschitz Pruning", 2025). Outside the grid, q is its nearest point: since the grid is convex and holds
// all members, none is nearer to p than √(|p − q|² + d(q)²), which changes as slowly as the distance does and goes over
// into it at the grid's sides.
// Practice: a question takes one to four words to find the list, and a word and some quadruples of numbers for each member in
// it. Software GPUs take a load's time for each component that is loaded by itself.

/// Rows of members' numbers, cells, and lists of entries; where each is, the others say.
@group(0) @binding(4) var<storage, read> crowds: array<vec4<u32>>;
/// The grid of each crowd: its least corner, and cubes per millimetre; its greatest corner, and where the cubes are; how many
/// cubes there are along each axis.
@group(0) @binding(5) var<uniform> crowd_grids: array<vec4<u32>, 24>;

/// A cell that is divided: the other bits say where its cells are. Without this bit they say where its list is.
const CROWD_BLOCK: u32 = 0x80000000u;
/// The edge of blocks in cells, and how often cells are divided at the most.
const CROWD_BLOCK_EDGE: u32 = 4u;
const CROWD_MOST_DIVISIONS: u32 = 3u;

/// The word at a place: a cell, or an entry of a list.
fn crowd_word(place: u32) -> u32 {
    return crowds[place >> 2u][place & 3u];
}

/// Four numbers of a row.
fn crowd_numbers(row: u32) -> vec4<f32> {
    return bitcast<vec4<f32>>(crowds[row]);
}

/// The point of a grid that is nearest to p.
fn crowd_nearest(p: vec3<f32>, grid: u32) -> vec3<f32> {
    return clamp(p, bitcast<vec3<f32>>(crowd_grids[grid].xyz), bitcast<vec3<f32>>(crowd_grids[grid + 1u].xyz));
}

/// Where the list of the cell is that a point of a grid is in.
fn crowd_list(q: vec3<f32>, grid: u32) -> u32 {
    var local = (q - bitcast<vec3<f32>>(crowd_grids[grid].xyz)) * bitcast<f32>(crowd_grids[grid].w);
    let counts = crowd_grids[grid + 2u];
    var cube = min(vec3<u32>(max(local, vec3<f32>(0.0))), counts.xyz - 1u);
    var cell = crowd_word(crowd_grids[grid + 1u].w + (cube.z * counts.y + cube.y) * counts.x + cube.x);
    for (var k = 0u; k < CROWD_MOST_DIVISIONS && (cell & CROWD_BLOCK) > 0u; k++) {
        local = (local - vec3<f32>(cube)) * f32(CROWD_BLOCK_EDGE);
        cube = min(vec3<u32>(max(local, vec3<f32>(0.0))), vec3<u32>(CROWD_BLOCK_EDGE - 1u));
        cell = crowd_word((cell & ~CROWD_BLOCK) + (cube.z * CROWD_BLOCK_EDGE + cube.y) * CROWD_BLOCK_EDGE + cube.x);
    }
    return cell;
}

/// The distance at p, from that at the grid's nearest point q.
fn crowd_beyond(p: vec3<f32>, q: vec3<f32>, distance: f32) -> f32 {
    let gap = length(p - q);
    return select(distance, length(vec2<f32>(gap, max(distance, 0.0))), gap > 0.0);
}

/// The look that stands before a member's numbers, or this one if nobody painted the member.
fn crowd_look(row: u32, unpainted: Surface) -> Surface {
    let finish = crowd_numbers(row - 1u);
    if finish.w > 0.5 {
        return unpainted;
    }
    return Surface(crowd_numbers(row - 2u), finish);
}
