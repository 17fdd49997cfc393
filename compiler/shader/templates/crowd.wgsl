// Crowds: large unions, of whose members each place asks those alone that can be the nearest there.
//
// Theory: A grid of cubes, some of them divided into 4 × 4 × 4, lists for each cube the members that can be the nearest in
// it (Barbier et al., "Lipschitz Pruning", 2025). Outside the grid, q is its nearest point: since the grid is convex and holds
// all members, none is nearer to p than √(|p − q|² + d(q)²), which changes as slowly as the distance does and goes over
// into it at the grid's sides.
// Practice: a question takes one to four words to find the list, and a word and a row of numbers for each member in it.

/// For each crowd its header; then, wherever that and the cells say, rows of numbers, cells, and lists.
@group(0) @binding(4) var<storage, read> crowds: array<u32>;

/// A cell that is divided: the other bits say where its cells are. Without this bit they say where its list is.
const CROWD_BLOCK: u32 = 0x80000000u;
/// The edge of blocks in cells, and how often cells are divided at the most.
const CROWD_BLOCK_EDGE: u32 = 4u;
const CROWD_MOST_DIVISIONS: u32 = 3u;

/// The word at a place.
fn crowd_word(place: u32) -> u32 {
    return crowds[place];
}

/// The number at a place.
fn crowd_number(place: u32) -> f32 {
    return bitcast<f32>(crowds[place]);
}

fn crowd_numbers(place: u32) -> vec3<f32> {
    return vec3<f32>(crowd_number(place), crowd_number(place + 1u), crowd_number(place + 2u));
}

/// The point of a crowd's grid that is nearest to p.
fn crowd_nearest(p: vec3<f32>, header: u32) -> vec3<f32> {
    return clamp(p, crowd_numbers(header), crowd_numbers(header + 3u));
}

/// Where the list of the cell is that a point of the grid is in.
fn crowd_list(q: vec3<f32>, header: u32) -> u32 {
    var local = (q - crowd_numbers(header)) * crowd_number(header + 6u);
    let counts = vec3<u32>(crowds[header + 7u], crowds[header + 8u], crowds[header + 9u]);
    var cube = min(vec3<u32>(max(local, vec3<f32>(0.0))), counts - 1u);
    var cell = crowds[crowds[header + 10u] + (cube.z * counts.y + cube.y) * counts.x + cube.x];
    for (var k = 0u; k < CROWD_MOST_DIVISIONS && (cell & CROWD_BLOCK) > 0u; k++) {
        local = (local - vec3<f32>(cube)) * f32(CROWD_BLOCK_EDGE);
        cube = min(vec3<u32>(max(local, vec3<f32>(0.0))), vec3<u32>(CROWD_BLOCK_EDGE - 1u));
        cell = crowds[(cell & ~CROWD_BLOCK) + (cube.z * CROWD_BLOCK_EDGE + cube.y) * CROWD_BLOCK_EDGE + cube.x];
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
    let color = vec4<f32>(crowd_numbers(row - 8u), crowd_number(row - 5u));
    let finish = vec4<f32>(crowd_numbers(row - 4u), 0.0);
    if crowd_number(row - 1u) > 0.5 {
        return unpainted;
    }
    return Surface(color, finish);
}
