// Plane shapes: signed distances in the plane, negative inside.

// The angle of p, anticlockwise from the x axis, in (-pi, pi]; 0 at the origin.
fn angle_of(p: vec2<f32>) -> f32 {
    let at_origin = (p.x == 0.0) & (p.y == 0.0);
    return atan2(p.y, select(p.x, 1.0, at_origin));
}

// p turned clockwise by an angle: its coordinates in axes turned anticlockwise.
fn turned_back(p: vec2<f32>, angle: f32) -> vec2<f32> {
    let c = cos(angle);
    let s = sin(angle);
    return vec2(c * p.x + s * p.y, c * p.y - s * p.x);
}

// p turned about the origin into the sector of width 2 pi / n around the x axis, from the sector of that
// width it lies in; the sectors' borders are at the multiples of that angle. So corners of an n-gon, the
// first at angle 0, come to the borders and its sides to a right angle with the x axis.
fn sector_of(p: vec2<f32>, n: f32) -> vec2<f32> {
    let sector = TAU / n;
    return turned_back(p, (floor(angle_of(p) / sector) + 0.5) * sector);
}

// The disc of radius r around the origin.
fn sd_circle(p: vec2<f32>, r: f32) -> f32 {
    return length(p) - r;
}

// The rectangle that reaches half_size to each side of the origin.
fn sd_rectangle(p: vec2<f32>, half_size: vec2<f32>) -> f32 {
    let q = abs(p) - half_size;
    return length(max(q, vec2(0.0))) + min(max(q.x, q.y), 0.0);
}

// The regular polygon of n sides with its corners on the circle of radius r, the first at angle 0.
fn sd_ngon(p: vec2<f32>, r: f32, n: f32) -> f32 {
    let q = sector_of(p, n);
    let beyond_side = q.x - r * cos(PI / n);
    let beyond_corner = max(abs(q.y) - r * sin(PI / n), 0.0);
    return select(-1.0, 1.0, beyond_side > 0.0) * length(vec2(beyond_side, beyond_corner));
}

// The ellipse with these radii along x and y: the middle section of an ellipsoid, whose third radius is so
// large that nothing nearer lies off the plane.
fn sd_ellipse(p: vec2<f32>, radii: vec2<f32>) -> f32 {
    return sd_ellipsoid(vec3(p, 0.0), vec3(radii, max(radii.x, radii.y)));
}

// The ring between the circles of radius inner and outer; a disc, if inner is zero or less.
fn sd_ring(p: vec2<f32>, outer: f32, inner: f32) -> f32 {
    let q = length(p);
    return max(q - outer, select(-outer, inner - q, inner > 0.0));
}

// The star with n points at radius outer, the first at angle 0, and n notches at radius inner between them.
// Mirrored into half a sector its outline is one segment, from a point to a notch.
fn sd_star(p: vec2<f32>, outer: f32, inner: f32, n: f32) -> f32 {
    let turned = sector_of(p, n);
    let q = vec2(turned.x, abs(turned.y));
    let notch = vec2(inner, 0.0);
    let side = outer * vec2(cos(PI / n), sin(PI / n)) - notch;
    let from_notch = q - notch;
    let along = clamp(dot(from_notch, side) / max(dot(side, side), TINY), 0.0, 1.0);
    let outside = from_notch.x * side.y - from_notch.y * side.x;
    return select(-1.0, 1.0, outside > 0.0) * length(from_notch - side * along);
}

// The sector from angle start anticlockwise over sweep, at most a full turn, with its apex at the origin.
// Mirrored at its bisector it has one border, a ray. (Just short of a full turn the two borders still differ,
// so that rounding can't take one side of the bisector for the other.)
fn sd_wedge(p: vec2<f32>, start: f32, sweep: f32) -> f32 {
    let q = turned_back(p, start + 0.5 * sweep);
    let folded = vec2(q.x, abs(q.y));
    let half_sweep = clamp(0.5 * sweep, 0.0, 3.14159);
    let ray = vec2(cos(half_sweep), sin(half_sweep));
    let to_ray = folded - ray * max(dot(folded, ray), 0.0);
    let inside = folded.x * ray.y - folded.y * ray.x > 0.0;
    return select(1.0, -1.0, inside) * length(to_ray);
}

// The points within half the thickness of the arc of radius r from angle start anticlockwise over sweep.
// Mirrored at its bisector the arc has one end.
fn sd_arc(p: vec2<f32>, r: f32, thickness: f32, start: f32, sweep: f32) -> f32 {
    let q = turned_back(p, start + 0.5 * sweep);
    let folded = vec2(q.x, abs(q.y));
    let half_sweep = clamp(0.5 * sweep, 0.0, PI);
    let ray = vec2(cos(half_sweep), sin(half_sweep));
    let beside = folded.x * ray.y - folded.y * ray.x >= 0.0;
    return select(length(folded - r * ray), abs(length(p) - r), beside) - 0.5 * thickness;
}

// The part of the disc of radius r from angle start anticlockwise over sweep, less than a full turn.
fn sd_pie(p: vec2<f32>, r: f32, start: f32, sweep: f32) -> f32 {
    let q = turned_back(p, start + 0.5 * sweep);
    let folded = vec2(q.x, abs(q.y));
    let half_sweep = clamp(0.5 * sweep, 0.0, 3.14159);
    let ray = vec2(cos(half_sweep), sin(half_sweep));
    let depth = length(p) - r;
    let to_side = length(folded - ray * clamp(dot(folded, ray), 0.0, r));
    let beside = folded.x * ray.y - folded.y * ray.x > 0.0;
    let inside = beside & (depth < 0.0);
    return select(1.0, -1.0, inside) * select(to_side, min(to_side, abs(depth)), beside);
}

// The convex hull of the disc of radius r_bottom at the origin and that of radius r_top at y = h: the middle
// section of a round cone.
fn sd_egg(p: vec2<f32>, r_bottom: f32, r_top: f32, h: f32) -> f32 {
    return sd_round_cone(vec3(p.x, 0.0, p.y), r_bottom, r_top, h);
}

// What two discs of radius r have in common whose centres are `apart` from each other along x. Mirrored into
// one quarter the outline is an arc around the far centre, which ends in the tip on the y axis.
fn sd_vesica(p: vec2<f32>, r: f32, apart: f32) -> f32 {
    let shift = min(0.5 * apart, r);
    let tip = sqrt(max(r * r - shift * shift, 0.0));
    let q = vec2(abs(p.x) + shift, abs(p.y));
    let beyond_tip = q.y * shift > q.x * tip;
    return select(length(q) - r, length(vec2(q.x - shift, q.y - tip)), beyond_tip);
}
