// The setting: what kernels know of a scene beside its two functions, as the renderer's uniform says it.
//
// Practice: an exported shader has functions of the same names that answer constants (`setting.rs` writes them), so that the
// texts which ask them serve both.

/// The Lipschitz constant L of the scene's distance: nothing is nearer than the distance over L.
fn setting_lipschitz() -> f32 {
    return view.eye.w;
}

/// The length in millimetres below which f32 can't tell points of the scene apart.
fn setting_epsilon() -> f32 {
    return view.box_min.w;
}

/// The least corner of the box outside which there is nothing.
fn setting_box_min() -> vec3<f32> {
    return view.box_min.xyz;
}

/// The greatest corner of that box.
fn setting_box_max() -> vec3<f32> {
    return view.box_max.xyz;
}

/// Whether there is a floor.
fn setting_has_floor() -> bool {
    return view.studio.y > 0.5;
}

/// The floor's height in millimetres.
fn setting_floor() -> f32 {
    return view.studio.x;
}

/// Whether the scene stands in the studio, and not under a sky.
fn setting_is_studio() -> bool {
    return view.zenith.w > 0.5;
}

/// How the studio is turned about z: the angle's cosine and sine.
fn setting_azimuth() -> vec2<f32> {
    return view.studio.zw;
}

/// The sky's radiance overhead, as the picture is exposed for it.
fn setting_zenith() -> vec3<f32> {
    return view.zenith.rgb;
}

/// The sky's radiance at the horizon.
fn setting_horizon() -> vec3<f32> {
    return view.horizon.rgb;
}

/// The radiance from below the horizon.
fn setting_ground() -> vec3<f32> {
    return view.ground.rgb;
}
