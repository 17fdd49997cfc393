// From radiance to what a screen shows.
//
// Theory: Khronos's PBR Neutral tone mapper keeps a colour as it is up to a peak of 0.8, so that materials look like
// their sRGB numbers in full white light, and rolls brighter ones off towards white.

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
