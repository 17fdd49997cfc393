/// What a display shows of a radiance: tone-mapped, between 0 and 1, linear.
fn shown(radiance: vec3<f32>) -> vec3<f32> {
    return clamp(tone_mapped(max(radiance, vec3<f32>(0.0))), vec3<f32>(0.0), vec3<f32>(1.0));
}
