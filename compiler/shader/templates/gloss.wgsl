// The glossy lobe in a table: how much it sends back, and what shape it has.
//
// Theory: D V cos is close to a clamped cosine lobe whose directions are multiplied by a matrix (Heitz, Dupuy, Hill,
// Neubelt, "Real-Time Polygonal-Light Shading with Linearly Transformed Cosines", 2016), so that its integral over a polygon
// is in closed form.
// Practice: `examples/fit_gloss` computes the table. Rows of angles, evenly in √(1 − cos), for each roughness; an entry is
// two rows: the inverse matrix [[a, 0, b], [0, 1, 0], [c, 0, d]] in the frame of the mirror image as a, b/α, c/α, d/α; then
// the lobe's albedo if Fresnel's term were 1, and if it were (1 − h·l)⁵.

@group(0) @binding(3) var<storage, read> gloss_table: array<vec4<f32>>;

const GLOSS_EDGE: u32 = 32u;
const LEAST_ROUGHNESS: f32 = 0.03;
const LEAST_COSINE: f32 = 0.01;

/// Row 0 or 1 of the entry for a roughness and the cosine between normal and view.
fn gloss_entry(roughness: f32, cosine: f32, row: u32) -> vec4<f32> {
    let most = f32(GLOSS_EDGE - 1u);
    let x = most * clamp(sqrt(max(1.0 - cosine, 0.0) / (1.0 - LEAST_COSINE)), 0.0, 1.0);
    let y = most * clamp((roughness - LEAST_ROUGHNESS) / (1.0 - LEAST_ROUGHNESS), 0.0, 1.0);
    let i = min(u32(x), GLOSS_EDGE - 2u);
    let j = min(u32(y), GLOSS_EDGE - 2u);
    let first = 2u * (j * GLOSS_EDGE + i) + row;
    let next = first + 2u * GLOSS_EDGE;
    let smoother = mix(gloss_table[first], gloss_table[first + 2u], x - f32(i));
    let rougher = mix(gloss_table[next], gloss_table[next + 2u], x - f32(i));
    return mix(smoother, rougher, y - f32(j));
}
