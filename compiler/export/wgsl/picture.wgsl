// From where the scene is seen, and what a pixel shows of it.

struct Camera {
    eye: vec3<f32>,
    /// The ways from the picture's centre to its right and its upper edge, on the plane one millimetre before the eye.
    right: vec3<f32>,
    up: vec3<f32>,
    /// Where it looks, of length 1.
    forward: vec3<f32>,
}

/// v turned about an axis of length 1 by an angle in radians (Rodrigues).
fn turned_about(v: vec3<f32>, axis: vec3<f32>, angle: f32) -> vec3<f32> {
    return v * cos(angle) + cross(axis, v) * sin(angle) + axis * (dot(axis, v) * (1.0 - cos(angle)));
}

/// The scene's own view, turned about what it looks at: by turn.x radians to the left and turn.y upwards, and by this many
/// times as far away. `aspect` is the picture's width by its height.
fn orbiting_camera(turn: vec2<f32>, zoom: f32, aspect: f32) -> Camera {
    let z = vec3<f32>(0.0, 0.0, 1.0);
    let offset = turned_about(turned_about(CAMERA_EYE - CAMERA_TARGET, CAMERA_RIGHT, -turn.y), z, -turn.x);
    let right = turned_about(CAMERA_RIGHT, z, -turn.x);
    let up = turned_about(turned_about(CAMERA_UP, CAMERA_RIGHT, -turn.y), z, -turn.x);
    // What fits into the picture's own format fits into all narrower ones.
    let half_height = CAMERA_HALF_HEIGHT * max(1.0, CAMERA_ASPECT / aspect);
    return Camera(CAMERA_TARGET + zoom * offset, aspect * half_height * right, half_height * up, -normalize(offset));
}

/// What a pixel shows, in sRGB; `point` is its centre, in pixels from the lower left corner. w: how far away its surface is,
/// in millimetres, or -1 for none.
fn picture(point: vec2<f32>, size: vec2<f32>, camera: Camera, rays: i32) -> vec4<f32> {
    let pixel_angle = 2.0 * length(camera.up) / size.y;
    var sum = vec3<f32>(0.0);
    var t = -1.0;
    for (var i = 0; i < rays; i++) {
        let place = select(2.0 * (point + ray_offset(i)) - size, 2.0 * point - size, rays == 1);
        let at = place / size;
        let w = normalize(camera.forward + at.x * camera.right + at.y * camera.up);
        let seen = one_pass(camera.eye, w, pixel_angle, place / length(size), i);
        sum += seen.color;
        t = seen.t;
    }
    return vec4<f32>(srgb_from_linear(shown(sum / f32(rays))), t);
}
