// The glossy lobe's albedo without a table.
//
// Theory: Karis, "Physically Based Shading on Mobile" (2014): a polynomial of roughness and cosine after Lazarov's fit of
// D V F over the hemisphere.
// Changes: The entry has the layout of `gloss.wgsl`: the albedo if Fresnel's term were 1, and if it were (1 − h·l)⁵.

const LEAST_ROUGHNESS: f32 = 0.03;

/// Row 1 of the entry for a roughness and the cosine between normal and view; there is no other row here.
fn gloss_entry(roughness: f32, cosine: f32, row: u32) -> vec4<f32> {
    let r = roughness * vec4<f32>(-1.0, -0.0275, -0.572, 0.022) + vec4<f32>(1.0, 0.0425, 1.04, -0.04);
    let a = min(r.x * r.x, exp2(-9.28 * max(cosine, 0.0))) * r.x + r.y;
    let scale_and_bias = vec2<f32>(-1.04, 1.04) * a + r.zw;
    let grazing = max(scale_and_bias.y, 0.0);
    return vec4<f32>(scale_and_bias.x + grazing, grazing, 0.0, 0.0);
}
