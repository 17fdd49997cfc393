// Warps and adjustments: where a changed solid asks the original, and what it makes of the answer.

// Turns p about z by -rate * z, so that the solid asked there appears turned by rate radians per millimetre
// of height, anticlockwise seen from above. At distance d from the axis it stretches distances up to (w +
// sqrt(w² + 4)) / 2 times, where w = |rate| d.
fn warp_twist(p: vec3<f32>, rate: f32) -> vec3<f32> {
    return vec3(turned_back(p.xy, rate * p.z), p.z);
}

// The point of the plane z = 0 below or above p, where a slice asks its solid.
fn plane_point(p: vec3<f32>) -> vec3<f32> {
    return vec3(p.xy, 0.0);
}

// The solid grown by r.
fn adjust_offset(d: f32, r: f32) -> f32 {
    return d - r;
}

// The wall of this thickness around the surface, half to each side.
fn adjust_shell(d: f32, thickness: f32) -> f32 {
    return abs(d) - 0.5 * thickness;
}

// The distance to the solid made `factor` times as large.
fn adjust_scale(d: f32, factor: f32) -> f32 {
    return d * factor;
}

// p moved towards the z axis into the cylinder of this radius: where a warp that stretches without limit is
// asked instead.
fn confine_disc(p: vec3<f32>, radius: f32) -> vec3<f32> {
    return vec3(p.xy * min(radius / max(length(p.xy), TINY), 1.0), p.z);
}

// The distance at a point that lies gap away from where d was found, d's Lipschitz constant being as given:
// the solid is at least that far away in two directions at right angles, the one to the confining surface and
// one along it.
fn confine_join(d: f32, gap: f32, lipschitz: f32) -> f32 {
    return select(d, length(vec2(max(d, 0.0), lipschitz * gap)), gap > 0.0);
}
