// Solids: signed distances in millimetres, negative inside.
//
// Rules of this folder: straight-line code of `let` and `select`, so that it suits SIMD machines, intervals
// and dual numbers alike; finite at every point, also at centres and on axes; names that no target language
// reserves.

// The ball of radius r around the origin.
fn sd_sphere(p: vec3<f32>, r: f32) -> f32 {
    return length(p) - r;
}

// The box that reaches half_size to each side of the origin (Quilez, "Distance functions").
fn sd_box(p: vec3<f32>, half_size: vec3<f32>) -> f32 {
    let q = abs(p) - half_size;
    return length(max(q, vec3(0.0))) + min(max(q.x, max(q.y, q.z)), 0.0);
}

// The round cylinder about z, from -half_height to half_height: a rectangle in the half plane of radius and
// height.
fn sd_cylinder(p: vec3<f32>, r: f32, half_height: f32) -> f32 {
    let q = vec2(length(p.xy) - r, abs(p.z) - half_height);
    return length(max(q, vec2(0.0))) + min(max(q.x, q.y), 0.0);
}

// The frustum about z, from r_bottom at -half_height to r_top at half_height. Either radius may be zero. In
// the half plane of radius and height it is the nearer of the slant, a segment, and the flat ends; a point is
// inside where it is between the ends and on the axis' side of the slant.
fn sd_cone(p: vec3<f32>, r_bottom: f32, r_top: f32, half_height: f32) -> f32 {
    let q = vec2(length(p.xy), p.z);
    let slant = vec2(r_top - r_bottom, 2.0 * half_height);
    let from_bottom = q - vec2(r_bottom, -half_height);
    let along = clamp(dot(from_bottom, slant) / max(dot(slant, slant), TINY), 0.0, 1.0);
    let to_slant = from_bottom - slant * along;
    let end_radius = select(r_top, r_bottom, q.y < 0.0);
    let beyond_end = abs(q.y) - half_height;
    let to_end = vec2(max(q.x - end_radius, 0.0), beyond_end);
    let outside_slant = from_bottom.x * slant.y - from_bottom.y * slant.x;
    let inside = (beyond_end < 0.0) & (outside_slant < 0.0);
    return select(1.0, -1.0, inside) * sqrt(min(dot(to_slant, to_slant), dot(to_end, to_end)));
}

// The ring of radius minor around the circle of radius major in the plane z = 0. Where minor exceeds major
// the ring meets itself on the axis in two tips: a point between them is nearest to a tip.
fn sd_torus(p: vec3<f32>, major: f32, minor: f32) -> f32 {
    let q = vec2(length(p.xy), abs(p.z));
    let tip = sqrt(max(minor * minor - major * major, 0.0));
    let between_tips = (major - q.x) * tip - major * q.y > 0.0;
    let to_circle = length(vec2(q.x - major, q.y)) - minor;
    return select(to_circle, -length(vec2(q.x, q.y - tip)), between_tips);
}

// The points within r of the segment from the origin up to z = h.
fn sd_capsule(p: vec3<f32>, h: f32, r: f32) -> f32 {
    return length(vec3(p.xy, p.z - clamp(p.z, 0.0, h))) - r;
}

// The convex hull of the ball of radius r_bottom at the origin and that of radius r_top at z = h. It is the
// union of all balls between, so the distance is that to the best of them: the one seen at a right angle to
// the slant. Where one of the two swallows the other, the larger is the best.
fn sd_round_cone(p: vec3<f32>, r_bottom: f32, r_top: f32, h: f32) -> f32 {
    let q = vec2(length(p.xy), p.z);
    let growth = r_top - r_bottom;
    let slope = growth * inverseSqrt(max(h * h - growth * growth, TINY));
    let tangent = clamp((q.y + q.x * slope) / max(h, TINY), 0.0, 1.0);
    let larger = select(0.0, 1.0, growth > 0.0);
    let best = select(tangent, larger, abs(growth) >= h);
    return length(vec2(q.x, q.y - h * best)) - mix(r_bottom, r_top, best);
}

// The ellipsoid with these radii along x, y and z.
//
// The nearest surface point of p is x_i = r_i² p_i / (r_i² + t), where t solves |s(t)| = 1 with s_i = r_i p_i
// / (r_i² + t). 1/|s| is concave and increasing in t, so a step of Newton's method never ends beyond the
// solution, and from there the next ones rise to it fast (Moré and Hebden's iteration for trust regions). It
// starts from the greater of two lower bounds: where the largest s_i is 1, and a step from t = 0, which is
// the surface itself. The unknown is u = t + r_min², which loses no digits near the singularity. Outside,
// what is left of the error makes the distance too short, so it is harmless. Deep inside, near the medial
// sheet, convergence is slow: there the value stops at half the least radius of curvature, unless r_min (1 -
// |p/r|), a bound of slope 1 or less, is deeper.
fn sd_ellipsoid(p: vec3<f32>, radii: vec3<f32>) -> f32 {
    let r_min = min(radii.x, min(radii.y, radii.z));
    let r_max = max(radii.x, max(radii.y, radii.z));
    let q = max(abs(p), vec3(1e-6 * r_min));
    let spread = (radii - r_min) * (radii + r_min);
    let pull = radii * q;
    let least = pull - spread;
    let from_surface = ellipsoid_step(r_min * r_min, pull, spread);
    let start = max(max(least.x, max(least.y, least.z)), from_surface);
    let u_a = ellipsoid_step(start, pull, spread);
    let u_b = ellipsoid_step(u_a, pull, spread);
    let u_c = ellipsoid_step(u_b, pull, spread);
    let u_d = ellipsoid_step(u_c, pull, spread);
    let u_e = ellipsoid_step(u_d, pull, spread);
    let u_f = ellipsoid_step(u_e, pull, spread);
    let u = ellipsoid_step(u_f, pull, spread);
    let reach = abs(u - r_min * r_min) * length(q / (spread + u));
    let depth = length(p / radii);
    let shallow = max(min(reach, 0.5 * r_min * r_min / r_max), r_min * (1.0 - depth));
    return select(-shallow, reach, depth > 1.0);
}

// One step of Newton's method towards the u with |pull / (spread + u)| = 1.
fn ellipsoid_step(u: f32, pull: vec3<f32>, spread: vec3<f32>) -> f32 {
    let s = pull / (spread + u);
    let squared = dot(s, s);
    return u + squared * (sqrt(squared) - 1.0) / dot(s * s, 1.0 / (spread + u));
}

// The half space below a plane: normal is of length 1 and points out, offset is the plane's distance from the
// origin.
fn sd_half_space(p: vec3<f32>, normal: vec3<f32>, offset: f32) -> f32 {
    return dot(p, normal) - offset;
}

// The twelve edges of a box as bars of square profile (Quilez, "Distance functions"): after folding, each
// axis has one bar along it.
fn sd_box_frame(p: vec3<f32>, half_size: vec3<f32>, thickness: f32) -> f32 {
    let half_bar = 0.5 * thickness;
    let q = abs(p) - half_size;
    let w = abs(q + half_bar) - half_bar;
    let along_x = vec3(q.x, w.y, w.z);
    let along_y = vec3(w.x, q.y, w.z);
    let along_z = vec3(w.x, w.y, q.z);
    let x_bar = length(max(along_x, vec3(0.0))) + min(max(along_x.x, max(along_x.y, along_x.z)), 0.0);
    let y_bar = length(max(along_y, vec3(0.0))) + min(max(along_y.x, max(along_y.y, along_y.z)), 0.0);
    let z_bar = length(max(along_z, vec3(0.0))) + min(max(along_z.x, max(along_z.y, along_z.z)), 0.0);
    return min(x_bar, min(y_bar, z_bar));
}

// The octahedron |x| + |y| + |z| <= r. Folded into one octant, its face is a simplex, and the nearest point
// of a simplex is max(p - t, 0) with t the largest of (sum of the k largest coordinates - r) / k. So the way
// to it is min(p, t); inside, t is negative and all of that.
fn sd_octahedron(p: vec3<f32>, r: f32) -> f32 {
    let q = abs(p);
    let sum = q.x + q.y + q.z - r;
    let largest = max(q.x, max(q.y, q.z)) - r;
    let two_largest = sum - min(q.x, min(q.y, q.z));
    let t = max(sum / 3.0, max(0.5 * two_largest, largest));
    return sign(t) * length(min(q, vec3(t)));
}

// A chain's link: a ring about z drawn out by half_length to each side along y.
fn sd_link(p: vec3<f32>, half_length: f32, major: f32, minor: f32) -> f32 {
    return sd_torus(vec3(p.x, p.y - clamp(p.y, -half_length, half_length), p.z), major, minor);
}

// The pyramid on a square in the plane z = 0 with edges of length base, its apex at z = h. Folded so that the
// face towards +x is the nearest. In that face's plane, v runs up from the middle of its lower edge.
fn sd_pyramid(p: vec3<f32>, base: f32, h: f32) -> f32 {
    let half_base = 0.5 * base;
    let q = vec3(max(abs(p.x), abs(p.y)), min(abs(p.x), abs(p.y)), p.z);
    let height = length(vec2(half_base, h));
    let up = vec2(-half_base, h) / height;
    let from_edge = vec2(q.x - half_base, q.z);
    let v = dot(from_edge, up);
    let above_face = from_edge.x * up.y - from_edge.y * up.x;
    let to_face = vec2(q.y, v) - pyramid_nearest(vec2(q.y, v), half_base, height);
    let to_base = vec3(max(q.x - half_base, 0.0), max(q.y - half_base, 0.0), q.z);
    let squared = min(dot(to_face, to_face) + above_face * above_face, dot(to_base, to_base));
    let inside = (q.z > 0.0) & (above_face < 0.0);
    return select(1.0, -1.0, inside) * sqrt(squared);
}

// The point nearest to q, with q.x >= 0, of the triangle with corners (-half_base, 0), (half_base, 0) and (0,
// height).
fn pyramid_nearest(q: vec2<f32>, half_base: f32, height: f32) -> vec2<f32> {
    let side = vec2(-half_base, height);
    let from_corner = q - vec2(half_base, 0.0);
    let on_side = vec2(half_base, 0.0) + side * clamp(dot(from_corner, side) / dot(side, side), 0.0, 1.0);
    let beyond_side = from_corner.x * side.y - from_corner.y * side.x > 0.0;
    let on_edge = vec2(min(q.x, half_base), max(q.y, 0.0));
    let below = q.y < 0.0;
    return select(select(q, on_side, beyond_side | below), on_edge, below & (q.x <= half_base));
}

// A wall along the gyroid sin x cos y + sin y cos z + sin z cos x = 0 of this period, at least thickness
// thick. The gradient of the left side is at most sqrt(3): by Cauchy and Schwarz each of its components, such
// as cos x cos y - sin z sin x, has a square of at most cos² y + sin² z, and over the three those sum to 3.
fn sd_gyroid(p: vec3<f32>, period: f32, thickness: f32) -> f32 {
    let wave_number = TAU / period;
    let q = p * wave_number;
    let wave = dot(sin(q), cos(q.yzx));
    return abs(wave) / (wave_number * ROOT_THREE) - 0.5 * thickness;
}

// What lies above the plane z = cut of the ball of radius r around the origin. In the half plane of radius
// and height the outline is an arc from the pole to the rim and a segment from the rim inwards.
fn sd_dome(p: vec3<f32>, r: f32, cut: f32) -> f32 {
    let q = vec2(length(p.xy), p.z);
    let level = clamp(cut, -r, r);
    let rim = vec2(sqrt(max(r * r - level * level, 0.0)), level);
    let depth = length(q) - r;
    let to_arc = select(length(q - rim), abs(depth), q.y * rim.x >= q.x * rim.y);
    let to_flat = length(vec2(max(q.x - rim.x, 0.0), q.y - level));
    let inside = (depth < 0.0) & (q.y > level);
    return select(1.0, -1.0, inside) * min(to_arc, to_flat);
}

// Regular polyhedra with their corners at distance r from the origin. Mirrors of their symmetry fold space
// into a wedge that holds a part of one face: from the face's middle towards an edge (across) and from the
// middle of that edge towards a corner (along).

// The signed distance in the wedge: height above the face, and how far beyond its edge and beyond the corner.
fn face_distance(height: f32, across: f32, along: f32) -> f32 {
    return select(-1.0, 1.0, height > 0.0) * length(vec3(height, max(across, 0.0), max(along, 0.0)));
}

// The tetrahedron with a corner in the direction (1, 1, 1) and edges across the axes. Its mirrors swap two
// coordinates, with or without a change of both signs; they fold space to z >= y >= |x|.
fn sd_tetrahedron(p: vec3<f32>, r: f32) -> f32 {
    let least = min(p.x, min(p.y, p.z));
    let middle = max(min(p.x, p.y), min(max(p.x, p.y), p.z));
    let greatest = max(p.x, max(p.y, p.z));
    let flip = max(-least - middle, 0.0);
    let low = least + flip;
    let high = middle + flip;
    let q = vec3(min(low, greatest), max(low, min(high, greatest)), max(high, greatest));
    let height = (q.y + q.z - q.x) / ROOT_THREE - r / 3.0;
    let across = (q.x - q.y + 2.0 * q.z) / (ROOT_TWO * ROOT_THREE) - r * (ROOT_TWO / 3.0);
    let along = (q.x + q.y) / ROOT_TWO - r * (ROOT_TWO / ROOT_THREE);
    return face_distance(height, across, along);
}

// The golden ratio g, and the mirror of the icosahedron that is not along an axis: (-1, -g, g - 1) / 2.
const GOLDEN: f32 = 1.6180339887498948;
const OBLIQUE: vec3<f32> = vec3<f32>(-0.5, -0.8090169943749474, 0.3090169943749474);

// Space folded by the mirrors of the icosahedron into x >= 0, y >= 0 and dot(p, OBLIQUE) >= 0. The wedge's
// edges run from the origin through the middle of a dodecahedron's edge (0, 0, 1), face (1, 0, g) and corner
// (0, 1/g, g).
fn icosahedral_fold(p: vec3<f32>) -> vec3<f32> {
    let once = icosahedral_mirror(p);
    let twice = icosahedral_mirror(once);
    let thrice = icosahedral_mirror(twice);
    return icosahedral_mirror(thrice);
}

// One round of mirrors.
fn icosahedral_mirror(p: vec3<f32>) -> vec3<f32> {
    let q = abs(p);
    return q - OBLIQUE * (2.0 * min(dot(q, OBLIQUE), 0.0));
}

// The dodecahedron with edges across the axes.
fn sd_dodecahedron(p: vec3<f32>, r: f32) -> f32 {
    let q = icosahedral_fold(p);
    let edge = r * (GOLDEN / ROOT_THREE);
    let normal = normalize(vec2(1.0, GOLDEN));
    let height = dot(q.xz, normal) - edge * normal.y;
    let across = dot(q.xz, vec2(-normal.y, normal.x)) - edge * normal.x;
    return face_distance(height, across, q.y - edge / (GOLDEN * GOLDEN));
}

// The icosahedron with edges across the axes.
fn sd_icosahedron(p: vec3<f32>, r: f32) -> f32 {
    let q = icosahedral_fold(p);
    let edge = r * normalize(vec2(1.0, GOLDEN)).y;
    let normal = normalize(vec2(1.0, GOLDEN * GOLDEN));
    let height = dot(q.yz, normal) - edge * normal.y;
    let across = dot(q.yz, vec2(-normal.y, normal.x)) - edge * normal.x;
    return face_distance(height, across, q.x - edge / GOLDEN);
}
