// The setting's lights, from the renderer's buffer.

@group(1) @binding(0) var<storage, read> lights: array<Light>;

/// How many lights there are.
fn setting_light_count() -> i32 {
    return i32(arrayLength(&lights));
}

/// One of them, as the picture is exposed for it.
fn setting_light(i: i32) -> Light {
    return lights[i];
}
