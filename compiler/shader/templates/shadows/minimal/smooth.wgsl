/// The fast soft shadow of section 4.1 with its cubic.
fn disc_part(m: f32) -> f32 {
    return smooth_area(m);
}
