// Sections: where a solid made from a plane shape asks that shape.

// A full turn about z: the distance from the axis, and the height.
fn section_revolve(p: vec3<f32>) -> vec2<f32> {
    return vec2(length(p.xy), p.z);
}

// A turn about z on the regular n-gon with its first corner at angle 0, instead of a circle: an edge at radius r of the
// plane shape becomes an n-gon with its corners at radius r. Its Lipschitz constant is 1 / cos(pi / n).
fn section_revolve_facets(p: vec3<f32>, n: f32) -> vec2<f32> {
    return vec2(sector_of(p.xy, n).x / cos(PI / n), p.z);
}

// An upright solid: every level alike.
fn section_slice(p: vec3<f32>) -> vec2<f32> {
    return p.xy;
}

// An upright solid from z = 0 to height whose levels are turned from 0 to twist radians, anticlockwise seen from
// above, and then scaled from 1 to scale_top along the fixed x and y.
fn section_extrude(p: vec3<f32>, height: f32, twist: f32, scale_top: vec2<f32>) -> vec2<f32> {
    let t = clamp(p.z / height, 0.0, 1.0);
    return turned_back(p.xy / max(mix(vec2(1.0), scale_top, t), vec2(1e-4)), twist * t);
}

// The distance at p from the distance in the section above, where lengths are those of p divided by the
// level's scale: times the lesser of its two scales.
fn op_taper(d: f32, z: f32, height: f32, scale_top: vec2<f32>) -> f32 {
    let scale = mix(vec2(1.0), scale_top, clamp(z / height, 0.0, 1.0));
    return d * max(min(scale.x, scale.y), 1e-4);
}

// The solid between the levels z = 0 and z = height of an upright solid at distance d in its own level.
fn op_extrude(d: f32, z: f32, height: f32) -> f32 {
    let q = vec2(d, abs(z - 0.5 * height) - 0.5 * height);
    return length(max(q, vec2(0.0))) + min(max(q.x, q.y), 0.0);
}
