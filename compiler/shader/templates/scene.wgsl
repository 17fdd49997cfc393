// The scene's two functions. Their bodies here are stubs, which splicing a scene replaces.

// What a surface looks like: color is linear red, green, blue and opacity; finish is roughness, metallic,
// emission as a multiple of the color, and 0.
struct Surface {
    color: vec4<f32>,
    finish: vec4<f32>,
}

// Linear light from an sRGB color (IEC 61966-2-1).
fn linear_from_srgb(srgb: vec3<f32>) -> vec3<f32> {
    let toe = srgb / 12.92;
    let power = pow((srgb + 0.055) / 1.055, vec3(2.4));
    return select(power, toe, srgb <= vec3(0.04045));
}

// The signed distance to the scene, in millimetres.
fn scene_distance(p: vec3<f32>) -> f32 {
    return p.x;
}

// The material of the surface at p.
fn scene_surface(p: vec3<f32>) -> Surface {
    return Surface(vec4(1.0), vec4(0.0));
}
