// Verified cones, second pass of a stage: which receivers in penumbrae are as their neighbours say.
//
// Theory: Across a smooth surface penumbrae are smooth but for contacts and corners. A receiver midway between others that
// lie on the same surface is predicted by the cubics through four of them along two lines; where the cubics agree with
// each other and with the straight lines between the nearest two, the prediction holds.
// Practice: Whatever doesn't hold is left to the cells. The first stage predicts nothing. Stages read what stages before
// them wrote, and nothing else, so that the order of the lists doesn't matter.

/// For each receiver: V, or where it is not yet known minus how far the light's cone is free; V₀; evaluations; E₀.
@group(1) @binding(2) var<storage, read_write> visibilities: array<vec4<f32>>;
@group(1) @binding(4) var<storage, read> touched: array<u32>;
/// How many receivers of each stage are left to the cells; then room for their indices.
@group(1) @binding(5) var<storage, read_write> left: array<atomic<u32>>;
/// For each stage, the workgroups of the cells.
@group(1) @binding(6) var<storage, read_write> left_groups: array<atomic<u32>>;
/// See `sums.wgsl`.
@group(1) @binding(7) var<storage, read> sums: array<u32>;

/// By how much the cubics may differ from each other and from the straight lines, for eight cells or fewer: about as much
/// as the cells err. More cells are asked for by whoever wants less.
const AGREEMENT: f32 = 0.02;
const CELLS_OF_AGREEMENT: f32 = 8.0;

/// A neighbour: V, and whether it counts.
struct Neighbour {
    seen: f32,
    counts: bool,
}

@compute @workgroup_size(64)
fn choose(@builtin(workgroup_id) group: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let place = linear_index(group, groups, lane);
    if place >= touched[task.stage] {
        return;
    }
    let index = touched[STAGES + task.stage * task.receivers + place];
    var predicted = -1.0;
    if task.stage > 0u {
        predicted = prediction(index);
    }
    if predicted >= 0.0 {
        visibilities[index].x = min(predicted, visibilities[index].y);
        return;
    }
    let work = atomicAdd(&left[task.stage], 1u);
    atomicStore(&left[STAGES + work], index);
    if work % 64u == 0u {
        let number = work / 64u;
        atomicMax(&left_groups[4u * task.stage], min(number + 1u, GROUPS_IN_ROW));
        atomicMax(&left_groups[4u * task.stage + 1u], number / GROUPS_IN_ROW + 1u);
        atomicMax(&left_groups[4u * task.stage + 2u], task.cells);
    }
}

/// The edge in pixels of the tiles that neighbours have to share. The parts of a picture consist of such tiles.
const TILE: i32 = 32;

/// What the neighbours say, or −1.
fn prediction(index: u32) -> f32 {
    let receiver = receivers[index];
    let off = i32(half_spacing(task.stage));
    let is_diagonal = task.stage % 2u == 1u;
    var sum = 0.0;
    var apart = 0.0;
    var before = 0.0;
    for (var line = 0; line < 2; line++) {
        let way = select(vec2<i32>(1 - line, line), vec2<i32>(1, 1 - 2 * line), is_diagonal) * off;
        let a = neighbour(index, receiver, -way);
        let b = neighbour(index, receiver, way);
        let c = neighbour(index, receiver, -3 * way);
        let d = neighbour(index, receiver, 3 * way);
        // Between two that see the same there is no penumbra, or one that is too slim for them to tell.
        if !a.counts || !b.counts || a.seen == b.seen {
            return -1.0;
        }
        let straight = 0.5 * (a.seen + b.seen);
        var curved = straight;
        var error = 0.5 * abs(a.seen - b.seen);
        if c.counts || d.counts {
            curved = select(
                select(6.0 * b.seen + 3.0 * a.seen - d.seen, 6.0 * a.seen + 3.0 * b.seen - c.seen, c.counts) / 8.0,
                (9.0 * (a.seen + b.seen) - c.seen - d.seen) / 16.0,
                c.counts && d.counts,
            );
            error = abs(curved - straight);
        }
        apart = max(apart, max(error, select(0.0, abs(curved - before), line == 1)));
        before = curved;
        sum += 0.5 * curved;
    }
    let agreement = AGREEMENT * min(1.0, CELLS_OF_AGREEMENT / f32(task.cells));
    return select(-1.0, clamp(sum, 0.0, 1.0), apart < agreement);
}

/// The receiver so many pixels off, which counts if it lies on the same smooth surface and its V is of the same light.
fn neighbour(index: u32, receiver: Receiver, off: vec2<i32>) -> Neighbour {
    let x = i32(index % task.width) + off.x;
    let y = i32(index / task.width) + off.y;
    let at = y * i32(task.width) + x;
    // Beyond the tile there may be another part, or none: then pictures would depend on how they are cut into parts.
    let same_tile = x / TILE == i32(index % task.width) / TILE && y / TILE == i32(index / task.width) / TILE;
    if x < 0 || y < 0 || x >= i32(task.width) || at >= i32(task.receivers) || !same_tile {
        return Neighbour(0.0, false);
    }
    let other = receivers[at];
    let way = other.p.xyz - receiver.p.xyz;
    let is_smooth = dot(other.n.xyz, receiver.n.xyz) > 0.95 && abs(dot(way, receiver.n.xyz)) <= 0.2 * length(way) + TINY;
    let same_light = task.light != DRAWN_LIGHT || other.drawn.x == receiver.drawn.x && other.drawn.y > 0.0;
    let answer = visibilities[at];
    let seen = select(answer.x, summed_visibility(u32(at), answer), answer.x < 0.0);
    return Neighbour(seen, other.p.w >= 0.0 && is_smooth && same_light);
}

fn summed_visibility(at: u32, answer: vec4<f32>) -> f32 {
    return visible_part(sums[SUMS * at], sums[SUMS * at + 1u], answer.y);
}
