// Resolves the sum of samples to what a screen shows.
//
// Theory: Khronos's PBR Neutral tone mapper keeps a colour as it is up to a peak of 0.8, so that materials look like
// their sRGB numbers in full white light, and rolls brighter ones off towards white.
// Practice: one invocation a pixel; the sRGB curve is applied here and nowhere else.

struct Resolution {
    /// One over the number of samples, times the exposure.
    scale: f32,
}

@group(0) @binding(0) var<uniform> resolution: Resolution;
@group(0) @binding(1) var<storage, read> sums: array<vec4<f32>>;
@group(0) @binding(2) var pixels: texture_storage_2d<rgba8unorm, write>;

/// Where compression starts, and how much what is compressed loses of its colour.
const COMPRESSED_FROM: f32 = 0.76;
const DESATURATION: f32 = 0.15;

fn tone_mapped(radiance: vec3<f32>) -> vec3<f32> {
    // Take off what a dielectric's interface reflects head-on of white light.
    let least = min(radiance.r, min(radiance.g, radiance.b));
    let color = radiance - select(0.04, least - 6.25 * least * least, least < 0.08);
    let peak = max(color.r, max(color.g, color.b));
    if peak < COMPRESSED_FROM {
        return color;
    }
    // Roll off: all that is brighter fits between where compression starts and 1.
    let room = 1.0 - COMPRESSED_FROM;
    let rolled = 1.0 - room * room / (peak + room - COMPRESSED_FROM);
    let white = 1.0 - 1.0 / (DESATURATION * (peak - rolled) + 1.0);
    return mix(color * rolled / peak, vec3<f32>(rolled), white);
}

fn srgb_from_linear(linear: vec3<f32>) -> vec3<f32> {
    let power = 1.055 * pow(max(linear, vec3<f32>(0.0031308)), vec3<f32>(1.0 / 2.4)) - 0.055;
    return select(power, 12.92 * linear, linear <= vec3<f32>(0.0031308));
}

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
