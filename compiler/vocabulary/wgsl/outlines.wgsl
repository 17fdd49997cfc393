// Outlines and polytopes: distances reduced from their pieces, one call for each.

// An outline of lines and arcs, possibly of several contours. The state is the squared distance to the pieces
// so far and a sign that each piece flips where a ray from p towards +x crosses it: 1 outside, -1 inside of
// an odd number of contours.
fn outline_start() -> vec2<f32> {
    return vec2(FAR * FAR, 1.0);
}

// Adds the line from a to b. A crossing counts if exactly one end is above p; so a shared end of two lines
// counts once.
fn outline_line(state: vec2<f32>, p: vec2<f32>, a: vec2<f32>, b: vec2<f32>) -> vec2<f32> {
    let edge = b - a;
    let from_a = p - a;
    let gap = from_a - edge * clamp(dot(from_a, edge) / max(dot(edge, edge), TINY), 0.0, 1.0);
    let crossed = outline_crosses(p, a, b);
    return vec2(min(state.x, dot(gap, gap)), select(state.y, -state.y, crossed));
}

// Of a solid in stages from z = 0 to height, all as high as each other: the number of the stage that is asked at z, and
// how far up in it that is, from 0 to 1.
fn loft_level(z: f32, height: f32, stages: f32) -> vec2<f32> {
    let level = clamp(z / height, 0.0, 1.0) * stages;
    let stage = min(floor(level), stages - 1.0);
    return vec2(stage, level - stage);
}

// Adds the line from a to b, whose ends are where t, from 0 to 1, is between those below and those above.
fn loft_side(
    state: vec2<f32>, p: vec2<f32>, t: f32,
    a_below: vec2<f32>, a_above: vec2<f32>, b_below: vec2<f32>, b_above: vec2<f32>,
) -> vec2<f32> {
    return outline_line(state, p, mix(a_below, a_above, t), mix(b_below, b_above, t));
}

// Adds the arc around pivot from a over sweep radians to b, clockwise if negative, at most a full turn (then
// a = b). a and b must be the very numbers its neighbours have, however they round: what the ray crosses is
// the chord, and then the other side of the arc if p is in the circle and on the arc's side of the chord.
fn outline_arc(
    state: vec2<f32>, p: vec2<f32>, a: vec2<f32>, b: vec2<f32>, pivot: vec2<f32>, sweep: f32,
) -> vec2<f32> {
    let radius = length(a - pivot);
    let from_pivot = p - pivot;
    let q = length(from_pivot);
    let middle = turned_back(a - pivot, -0.5 * sweep);
    let in_sector = dot(from_pivot, middle) >= q * radius * cos(0.5 * sweep);
    let to_end = min(dot(p - a, p - a), dot(p - b, p - b));
    let squared = select(to_end, (q - radius) * (q - radius), in_sector);
    let closed = (a.x == b.x) & (a.y == b.y);
    let in_segment = (q < radius) & (closed | (outline_left(p, a, b) != (sweep > 0.0)));
    let crossed = outline_crosses(p, a, b) != in_segment;
    return vec2(min(state.x, squared), select(state.y, -state.y, crossed));
}

// Whether the ray from p towards +x crosses the line from a to b: one end is above p, and p is at the line's
// left side if it goes up and at its right if it goes down.
fn outline_crosses(p: vec2<f32>, a: vec2<f32>, b: vec2<f32>) -> bool {
    return ((a.y > p.y) != (b.y > p.y)) & (outline_left(p, a, b) == (b.y > a.y));
}

// Whether p is at the left side of the line from a to b. What is level with a level line counts as above it,
// as it does for crossings.
fn outline_left(p: vec2<f32>, a: vec2<f32>, b: vec2<f32>) -> bool {
    let turn = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    return select(turn > 0.0, (p.y >= a.y) == (b.x > a.x), a.y == b.y);
}

// The signed distance to an outline whose pieces have all been added.
fn outline_end(state: vec2<f32>) -> f32 {
    return state.y * sqrt(state.x);
}

// A convex polytope of triangles. The state is the squared distance to the triangles so far and the largest
// signed distance to their planes.
fn polytope_start() -> vec2<f32> {
    return vec2(FAR * FAR, -FAR);
}

// Adds the triangle a, b, c, anticlockwise seen from outside. One without an area adds no plane.
fn polytope_triangle(
    state: vec2<f32>, p: vec3<f32>, a: vec3<f32>, b: vec3<f32>, c: vec3<f32>,
) -> vec2<f32> {
    let normal = cross(b - a, c - a);
    let area = dot(normal, normal);
    let degenerate = area < 1e-20;
    let height = dot(normal, p - a) * inverseSqrt(max(area, 1e-20));
    let left_ab = dot(cross(normal, b - a), p - a);
    let left_bc = dot(cross(normal, c - b), p - b);
    let left_ca = dot(cross(normal, a - c), p - c);
    let to_ab = segment_squared(p - a, b - a);
    let to_bc = segment_squared(p - b, c - b);
    let to_ca = segment_squared(p - c, a - c);
    let above = !degenerate & (min(left_ab, min(left_bc, left_ca)) >= 0.0);
    let squared = select(min(to_ab, min(to_bc, to_ca)), height * height, above);
    return vec2(min(state.x, squared), select(max(state.y, height), state.y, degenerate));
}

// The squared distance from q to the segment from the origin to edge.
fn segment_squared(q: vec3<f32>, edge: vec3<f32>) -> f32 {
    let gap = q - edge * clamp(dot(q, edge) / max(dot(edge, edge), TINY), 0.0, 1.0);
    return dot(gap, gap);
}

// The signed distance to a convex polytope whose triangles have all been added: inside, the nearest plane's.
fn polytope_end(state: vec2<f32>) -> f32 {
    return select(state.y, sqrt(state.x), state.y > 0.0);
}

// Whether pieces of an outline within the box from low to high may be nearer to p than the state says.
fn outline_near(state: vec2<f32>, p: vec2<f32>, low: vec2<f32>, high: vec2<f32>) -> bool {
    let gap = max(max(low - p, p - high), vec2(0.0));
    return dot(gap, gap) <= state.x;
}

// Adds pieces that lead from a to b within a box that is not near: p is beside them, so that a ray which meets
// them goes from one end's side to the other's.
fn outline_far(state: vec2<f32>, p: vec2<f32>, a: vec2<f32>, b: vec2<f32>) -> vec2<f32> {
    let crossed = ((a.y > p.y) != (b.y > p.y)) & (p.x < a.x);
    return vec2(state.x, select(state.y, -state.y, crossed));
}

// How far p is outside of the box from low to high along the axis where it is farthest; negative inside.
fn box_gap(p: vec3<f32>, low: vec3<f32>, high: vec3<f32>) -> f32 {
    let gap = max(low - p, p - high);
    return max(gap.x, max(gap.y, gap.z));
}
