// Outlines of lights, and integrals over what is within.
//
// Theory: The radiance of a light is constant, so that only its outline counts. ∫ cos θ dω over a polygon is a sum over its
// edges, ½ Σ ∠(vᵢ, vᵢ₊₁) n·(vᵢ × vᵢ₊₁)/|vᵢ × vᵢ₊₁| (Lambert 1760), after the part below the horizon is cut off.
// Changes: A sphere and a sun are the disk that touches the cone about them; disks and the ends of tubes are arcs of twelve
// corners. Edges are cut one by one, and the next one's start is joined to the last one's end along the horizon: so no
// list of corners is needed, and outlines that aren't convex, as a tube's seen past its end, come out right.
// Practice: Corners are kept as offsets from the middle, whose differences f32 knows well. Of outlines that are small as
// seen from p, terms along the edges cancel, and the vector area is used instead.

/// The corners of each of the two arcs of an outline that isn't a quadrilateral.
const ARC_CORNERS: u32 = 12u;
/// Outlines whose corners are nearer to the middle than this part of its distance, squared, are small.
const SMALL_OUTLINE: f32 = 1e-4;

/// The outline of a light as seen from a point; in units of the farthest.
struct Outline {
    /// From the point to its middle.
    middle: vec3<f32>,
    /// Of a quadrilateral: from there to its first three corners. Else the axes of the arcs, and from the middle to
    /// that of the first arc.
    x: vec3<f32>,
    y: vec3<f32>,
    z: vec3<f32>,
    /// The angles of the first arc's first corner and between corners.
    first: vec2<f32>,
    /// The same of the second arc.
    second: vec2<f32>,
    corners: u32,
}

fn outline_of(light: Light, p: vec3<f32>) -> Outline {
    let to_middle = light.a.xyz - p;
    if light.kind.x == LIGHT_QUAD {
        let middle = 0.25 * (light.a.xyz + light.b.xyz + light.c.xyz + light.d.xyz);
        let x = light.a.xyz - middle;
        let y = light.b.xyz - middle;
        let z = light.c.xyz - middle;
        return outline_scaled(Outline(middle - p, x, y, z, vec2<f32>(0.0), vec2<f32>(0.0), 4u));
    }
    if light.kind.x == LIGHT_TUBE {
        // Its ends are seen as the arcs that face p, up to where planes through p touch the tube.
        let axis = light.b.xyz / max(length(light.b.xyz), 1e-20);
        let from_axis = dot(to_middle, axis) * axis - to_middle;
        let from_axis_length = length(from_axis);
        let d = max(from_axis_length, light.a.w * 1.0001);
        let towards = light.a.w * select(basis_across(axis)[0], from_axis / max(from_axis_length, 1e-20), from_axis_length > 1e-12);
        let widest = acos(light.a.w / d);
        let step = 2.0 * widest / f32(ARC_CORNERS - 1u);
        let first = vec2<f32>(-widest, step);
        let sideways = cross(axis, towards);
        return outline_scaled(Outline(to_middle, towards, sideways, light.b.xyz, first, -first, 2u * ARC_CORNERS));
    }
    if light.kind.x == LIGHT_DISK {
        return outline_of_disk(to_middle, light.b.xyz, light.a.w);
    }
    let cone = light_bound(light, p);
    let sine = min(cone.w, 0.9999);
    return outline_of_disk(cone.xyz, cone.xyz, sine / sqrt(1.0 - sine * sine));
}

fn outline_of_disk(middle: vec3<f32>, normal: vec3<f32>, radius: f32) -> Outline {
    let across = basis_across(normal);
    // The polygon is as large as the disk.
    let step = PI / f32(ARC_CORNERS);
    let r = radius * sqrt(step / sin(step));
    let arcs = vec4<f32>(0.0, step, PI, step);
    return outline_scaled(Outline(middle, r * across[0], r * across[1], vec3<f32>(0.0), arcs.xy, arcs.zw, 2u * ARC_CORNERS));
}

fn outline_scaled(outline: Outline) -> Outline {
    let size = length(outline.middle) + length(outline.x) + length(outline.y) + length(outline.z);
    let scale = 1.0 / clamp(size, 1e-20, 1e20);
    var scaled = outline;
    scaled.middle *= scale;
    scaled.x *= scale;
    scaled.y *= scale;
    scaled.z *= scale;
    return scaled;
}

/// From an outline's middle to its i-th corner.
fn outline_corner(outline: Outline, i: u32) -> vec3<f32> {
    if outline.corners == 4u {
        let fourth = -(outline.x + outline.y + outline.z);
        return select(select(outline.x, outline.y, i == 1u), select(outline.z, fourth, i == 3u), i >= 2u);
    }
    let is_second = i >= ARC_CORNERS;
    let arc = select(outline.first, outline.second, is_second);
    let angle = arc.x + arc.y * f32(select(i, i - ARC_CORNERS, is_second));
    return cos(angle) * outline.x + sin(angle) * outline.y + select(outline.z, -outline.z, is_second);
}

/// A polygon that is followed from corner to corner and cut by the plane through the origin with the normal n.
struct Boundary {
    n: vec3<f32>,
    middle: vec3<f32>,
    /// The last corner and the first, as offsets from the middle.
    last: vec3<f32>,
    first: vec3<f32>,
    /// The same of what is above the plane.
    last_above: vec3<f32>,
    first_above: vec3<f32>,
    /// Whether there are such.
    is_begun: bool,
    is_above: bool,
    /// Of what is above, ∫ w dω over its directions w, twice; and the vector area.
    sum: vec3<f32>,
    area: vec3<f32>,
    /// The square of its greatest offset.
    reach2: f32,
}

fn boundary_begun(n: vec3<f32>, middle: vec3<f32>) -> Boundary {
    let zero = vec3<f32>(0.0);
    return Boundary(n, middle, zero, zero, zero, zero, false, false, zero, zero, 0.0);
}

/// Goes on to the next corner.
fn boundary_to(boundary: Boundary, corner: vec3<f32>) -> Boundary {
    var b = boundary;
    b.last = corner;
    if !b.is_begun {
        b.is_begun = true;
        b.first = corner;
        return b;
    }
    let height = dot(b.middle + boundary.last, b.n);
    let next_height = dot(b.middle + corner, b.n);
    if height <= 0.0 && next_height <= 0.0 {
        return b;
    }
    let way = corner - boundary.last;
    let crossing = height / select(height - next_height, 1.0, height == next_height);
    let starts = select(boundary.last + clamp(crossing, 0.0, 1.0) * way, boundary.last, height >= 0.0);
    let ends = select(boundary.last + clamp(crossing, 0.0, 1.0) * way, corner, next_height >= 0.0);
    if !b.is_above {
        b.is_above = true;
        b.first_above = starts;
        b.last_above = starts;
    }
    b = boundary_edge(b, b.last_above, starts);
    b = boundary_edge(b, starts, ends);
    b.last_above = ends;
    return b;
}

/// Adds an edge from one offset to another.
fn boundary_edge(boundary: Boundary, starts: vec3<f32>, ends: vec3<f32>) -> Boundary {
    var b = boundary;
    let way = ends - starts;
    let across = cross(b.middle + starts, way);
    let size = length(across);
    b.sum += atan2(size, dot(b.middle + starts, b.middle + ends)) / max(size, 1e-30) * across;
    b.area += 0.5 * cross(starts, way);
    b.reach2 = max(b.reach2, dot(ends, ends));
    return b;
}

/// ∫ w dω over the directions w of the polygon, once all corners are there.
fn boundary_integral(boundary: Boundary) -> vec3<f32> {
    var b = boundary_to(boundary, boundary.first);
    b = boundary_edge(b, b.last_above, b.first_above);
    let distance2 = max(dot(b.middle, b.middle), 1e-30);
    let of_small = abs(dot(b.area, b.middle)) / (distance2 * distance2) * b.middle;
    let sum = 0.5 * sign(dot(b.sum, b.n)) * b.sum;
    return select(sum, of_small, b.reach2 < SMALL_OUTLINE * distance2);
}
