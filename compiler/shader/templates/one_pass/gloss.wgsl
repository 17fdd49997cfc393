// The glossy lobe's albedo without a table.
//
// Theory: The rows 1 of `gloss.wgsl`'s table as polynomials in α and the cosine between normal and view, fitted to it by
// least squares.
// Practice: they differ from the table by 0.012 and 0.004 on average, most at grazing angles of rough surfaces.

const LEAST_ROUGHNESS: f32 = 0.03;

/// Row 1 of the entry for a roughness and a cosine: the albedo if Fresnel's term were 1, and if it were (1 − h·l)⁵. There is no
/// other row here.
fn gloss_entry(roughness: f32, cosine: f32, row: u32) -> vec4<f32> {
    let c = clamp(cosine, 0.0, 1.0);
    let powers = vec3<f32>(1.0, c, c * c);
    let alpha = roughness * roughness;
    let first = dot(powers, vec3<f32>(0.715, -0.162, -0.669));
    let second = dot(powers, vec3<f32>(-1.643, 4.644, -0.964));
    let third = dot(powers, vec3<f32>(1.072, -3.418, 1.094));
    let whole = 1.0 - alpha * (first + alpha * (second + alpha * third));
    let at_grazing = 1.075 + roughness * (-2.539 + roughness * (1.802 - 0.29 * roughness));
    let grazing = pow(max(1.0 - c, 1e-6), 4.5 - 2.0 * roughness) * at_grazing;
    return vec4<f32>(clamp(whole, 0.1, 1.0), max(grazing, 0.0), 0.0, 0.0);
}
