// Joints: how the surfaces of united solids meet. The joint of distances d with radius r and exponent p is
// the x that solves sum of max(0, 1 - (d - x) / r)^p = 1. It is the plain minimum where no other operand is
// within r of it, and its gradient is a convex combination of the operands'.

// Two operands, p = 1: where both count, the equation is linear in x.
fn joint_chamfer(a: f32, b: f32, r: f32) -> f32 {
    return min(min(a, b), 0.5 * (a + b - r));
}

// Two operands, p = 2: a quadratic in x. Between perpendicular faces, the circle of radius r.
fn joint_fillet(a: f32, b: f32, r: f32) -> f32 {
    let apart = min(abs(a - b), r);
    return min(a, b) + 0.5 * (apart + sqrt(2.0 * r * r - apart * apart)) - r;
}

// Two operands, p = 3: continuous in curvature. With u = 1 - (min(a, b) - x) / r and e = |a - b| / r the
// equation is u³ + max(u - e, 0)³ = 1; Newton's method from u = 1 falls monotonically onto its solution.
fn joint_smooth(a: f32, b: f32, r: f32) -> f32 {
    let e = min(abs(a - b) / max(r, TINY), 1.0);
    let u_a = joint_smooth_step(1.0, e);
    let u_b = joint_smooth_step(u_a, e);
    let u_c = joint_smooth_step(u_b, e);
    let u = joint_smooth_step(u_c, e);
    return min(a, b) - r * (1.0 - u);
}

// One step of Newton's method on u³ + max(u - e, 0)³ = 1.
fn joint_smooth_step(u: f32, e: f32) -> f32 {
    let v = max(u - e, 0.0);
    return u - (u * u * u + v * v * v - 1.0) / (3.0 * (u * u + v * v));
}

// Any number of operands, by Newton's method on the sum, which is convex and increasing in x: start at x =
// min of all d, where the sum is at least 1; for each step start from (0, 0), add a term for every operand,
// and step. x falls monotonically onto the joint.
fn joint_term(state: vec2<f32>, d: f32, x: f32, r: f32, exponent: f32) -> vec2<f32> {
    let u = max(1.0 - (d - x) / max(r, TINY), 0.0);
    let weight = joint_weight(d, x, r, exponent);
    return state + vec2(u * weight, exponent * weight);
}

// The next x, from the sum and its slope at x.
fn joint_step(state: vec2<f32>, x: f32, r: f32) -> f32 {
    return x - r * (state.x - 1.0) / max(state.y, TINY);
}

// How much an operand at distance d counts in the joint x: u^(p - 1), for p = 1, 2 or 3. Divided by the sum
// of all weights it is the operand's share in gradient and material.
fn joint_weight(d: f32, x: f32, r: f32, exponent: f32) -> f32 {
    let u = max(1.0 - (d - x) / max(r, TINY), 0.0);
    let chamfer = select(0.0, 1.0, u > 0.0);
    return select(select(u * u, u, exponent < 2.5), chamfer, exponent < 1.5);
}
