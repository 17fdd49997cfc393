// Resolves the sum of samples to what a screen shows.
//
// Practice: one invocation a pixel, below the functions of `display.wgsl`; the sRGB curve is applied here and nowhere else.

struct Resolution {
    /// One over the number of samples, times the exposure.
    scale: f32,
}

@group(0) @binding(0) var<uniform> resolution: Resolution;
@group(0) @binding(1) var<storage, read> sums: array<vec4<f32>>;
@group(0) @binding(2) var pixels: texture_storage_2d<rgba8unorm, write>;

/// Noise from −½ to ½ that hides the steps of 8 bits (Jimenez's interleaved gradient noise).
fn dither(pixel: vec2<f32>) -> f32 {
    return fract(52.9829189 * fract(dot(pixel, vec2<f32>(0.06711056, 0.00583715)))) - 0.5;
}

@compute @workgroup_size(8, 8)
fn resolve(@builtin(global_invocation_id) id: vec3<u32>) {
    let size = textureDimensions(pixels);
    if any(id.xy >= size) {
        return;
    }
    let radiance = max(sums[id.y * size.x + id.x].rgb * resolution.scale, vec3<f32>(0.0));
    let encoded = srgb_from_linear(clamp(tone_mapped(radiance), vec3<f32>(0.0), vec3<f32>(1.0)));
    textureStore(pixels, id.xy, vec4<f32>(encoded + dither(vec2<f32>(id.xy)) / 255.0, 1.0));
}
