// The glossy lobe without a table.
//
// Theory: The entries of `gloss.wgsl`'s table as polynomials in α, the roughness, and the angle between normal and view, fitted
// to it by least squares.
// Practice: the albedos differ from the table's by 0.012 and 0.004 on average, most at grazing angles of rough surfaces; the
// elements of the matrix by 0.01 to 0.02.

const LEAST_ROUGHNESS: f32 = 0.03;

/// Row 0 or 1 of the entry for a roughness and the cosine between normal and view: what `gloss.wgsl` says of them.
fn gloss_entry(roughness: f32, cosine: f32, row: u32) -> vec4<f32> {
    let c = clamp(cosine, 0.01, 1.0);
    if row == 0u {
        return gloss_matrix(roughness, c);
    }
    return gloss_albedo(roughness, c);
}

/// The inverse matrix of the lobe: a, b/α, c/α, d/α.
fn gloss_matrix(roughness: f32, c: f32) -> vec4<f32> {
    let alpha = roughness * roughness;
    let s2 = 1.0 - c * c;
    let s = sqrt(s2);
    let a = c + alpha * s2 * (1.391 + alpha * (0.263 * alpha - 1.681));
    let b = roughness * s * (0.802 * roughness - 1.848);
    let below_a = roughness * s * (4.348 - roughness * (2.779 + 0.303 * roughness));
    let d = c * (2.0 - 0.86 * alpha * alpha);
    return vec4<f32>(a, b, below_a, d);
}

/// The albedo if Fresnel's term were 1, and if it were (1 − h·l)⁵.
fn gloss_albedo(roughness: f32, c: f32) -> vec4<f32> {
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
