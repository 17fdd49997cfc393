// The plane that an inspection cuts the scene with.

/// The plane's unit normal; w: what the normal's product with its points is. Behind it: x: 1 if there is a plane, else 0.
@group(1) @binding(0) var<storage, read> cut: array<vec4<f32>, 2>;

/// How far along a ray from the eye the plane is met; FAR if it is not. The eye sees the plane from either side.
fn plane_crossing(ray: Ray) -> f32 {
    let height = dot(cut[0].xyz, ray.o) - cut[0].w;
    let falls = -dot(cut[0].xyz, ray.w) * sign(height);
    return select(FAR, min(abs(height) / max(falls, TINY), FAR), falls > 0.0);
}
